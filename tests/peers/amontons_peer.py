"""Amontons as peers.py asks for it: N is the number of refinements, of targets their thousandths; 'linear' is the first linear solve of the last mesh, as summary.json has it."""
import math
import os
import pathlib
import sys

from cases import CLEARANCE, E, NU, place
from pressure import closed_form

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tests"))

METHOD = "Contact solver/Method="
# of each formulation what is set, N within
FORMS = {
    "degree 1": ["Discretization/Degree=1", "Refinement/Cycles={}"], "degree 2": ["Discretization/Degree=2", "Refinement/Cycles={}"],
    "degree 1 uniform": ["Discretization/Degree=1", "Refinement/Strategy=uniform", "Refinement/Cycles={}"],
    "degree 2 uniform": ["Discretization/Degree=2", "Refinement/Strategy=uniform", "Refinement/Cycles={}"],
    "degree 2 targets": ["Discretization/Degree=2", "Refinement/Cycles=-1", "Refinement/Target error={}e-3"],
    "degree 2 penalty 10": ["Discretization/Degree=2", METHOD + "penalty", "Contact solver/Penalty factor=10", "Refinement/Cycles={}"],
    "degree 2 penalty 1000": ["Discretization/Degree=2", METHOD + "penalty", "Contact solver/Penalty factor=1000", "Refinement/Cycles={}"],
    "degree 2 augmented Lagrangian": ["Discretization/Degree=2", METHOD + "augmented Lagrangian", "Refinement/Cycles={}"],
    "degree 2 node-to-segment": ["Discretization/Degree=2", METHOD + "node-to-segment", "Refinement/Cycles={}"],
    "degree 2 seed": ["Discretization/Degree=2", METHOD + "seed", "Refinement/Cycles={}"]}
# with the clearance, the moduli and the force of cases.py; the force is spread about the pin's centre
PIN = [f"Contact hole/Initial gap={CLEARANCE}"] + [f"Body {body}/{name}={value}" for body in ("pin", "plate") for name, value in (("Young modulus", E), ("Poisson ratio", NU))]
PIN += ["Body pin/Refinements=2", "Body plate/Refinements=2"]  # a coarser start
PIN += [f"Body pin/Body force=0; -{E / (1 - NU**2) * CLEARANCE / 2}/(pi*0.01)*exp(-(x^2+y^2)/0.01)"]


def of_pin(case, answer):
    """Relative error in L2 against the closed form for the load that the contact carries."""
    force = case.share * abs(math.fsum(row["fy"] for row in answer.nodes()))
    reach, exact = closed_form(case, force)
    return answer.profile(lambda angle: exact(abs(angle)), 0, 1.3 * reach, coordinate=lambda row: place(case, (row["X"], row["Y"])))


TWO = "degree 1", "degree 2"


class Amontons:
    name = "Amontons"
    forms = {form: (sets, "", "") for form, sets in FORMS.items()}
    lot = {"H2": {form: (2, 4, 6, 8, 10, 12) for form in TWO}, "CM": {form: (2, 4, 6, 8, 10) for form in TWO}, "HA": {form: (2, 4, 6, 8, 10, 12) for form in TWO},
           "H3": {"degree 1": (3, 4, 5, 6, 7), "degree 2": (2, 3, 4)},
           "PI": {form: (100, 30, 10, 3) if "targets" in form else (0, 1, 2, 3) if "uniform" in form else (0, 2, 4, 6, 8, 10, 12) if form in TWO else (0, 2, 4, 6, 8)
                  for form in forms}}

    def __init__(self, program):
        self.program = program

    def missing(self):
        return "" if os.access(self.program, os.X_OK) else f"no program {self.program}: --amontons FILE"

    def run(self, case, formulation, N, folder, measured):
        from scorecard_benchmarks import compared, line_floor, point_floor
        from scorecard_parts import Answer

        sets = [entry.format(N) for entry in FORMS[formulation]] + ["Output/VTU=false", "Output/Report=false"] + (PIN if case.kind == "pin" else [])
        command = [self.program, str(ROOT / f"parameters/verification/{case.scene}.prm"), "--output", folder, "--quiet"]
        row = measured(command + [part for entry in sets for part in ("--set", entry)])
        answer = Answer(folder, os.path.join(folder, "log"))
        if answer.summary.get("status") != "converged":
            raise RuntimeError(answer.summary.get("message"))
        point = case.kind in ("axisymmetric", "space")
        row["error"] = of_pin(case, answer) if case.kind == "pin" else compared(answer, case.share, point_floor if point else line_floor, "", "", point=point)[0].error
        row["dofs"] = answer.summary["dofs"]
        if case.kind != "pin":
            row["linear"] = answer.summary["one_linear_solve_seconds"]
        return row
