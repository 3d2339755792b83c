"""Amontons as peers.py asks for it: N is the number of refinements, 'linear' the first linear solve of the last mesh, as summary.json has it."""
import os
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tests"))


class Amontons:
    name = "Amontons"
    forms = {"degree 1": (1, "", ""), "degree 2": (2, "", "")}
    lot = {"H2": {form: (2, 4, 6, 8, 10, 12) for form in forms}, "CM": {form: (2, 4, 6, 8, 10) for form in forms}, "HA": {form: (2, 4, 6, 8, 10, 12) for form in forms},
           "H3": {"degree 1": (3, 4, 5, 6, 7), "degree 2": (2, 3, 4)}}

    def __init__(self, program):
        self.program = program

    def missing(self):
        return "" if os.access(self.program, os.X_OK) else f"no program {self.program}: --amontons FILE"

    def run(self, case, formulation, N, folder, measured):
        from scorecard_benchmarks import compared, line_floor, point_floor
        from scorecard_parts import Answer

        sets = [f"Discretization/Degree={self.forms[formulation][0]}", f"Refinement/Cycles={N}", "Output/VTU=false", "Output/Report=false"]
        command = [self.program, str(ROOT / f"parameters/verification/{case.scene}.prm"), "--output", folder, "--quiet"]
        row = measured(command + [part for entry in sets for part in ("--set", entry)])
        answer = Answer(folder, os.path.join(folder, "log"))
        if answer.summary.get("status") != "converged":
            raise RuntimeError(answer.summary.get("message"))
        point = case.kind != "plane"
        row["error"] = compared(answer, case.share, point_floor if point else line_floor, "", "", point=point)[0].error
        row["dofs"], row["linear"] = answer.summary["dofs"], answer.summary["one_linear_solve_seconds"]
        return row
