#!/usr/bin/env python3
"""Shallow ironing (parameters/ironing.prm, case IR2): ironing.py --program ccx|getfem|amontons [--write FILE], with the options below; --lot runs what doc/peers.csv has.

All get the same mesh (--cells of the block, as 96,16; 14 x 6 of the die), neo-Hookean, friction 0.3. --press increments of the press by 1
and --slide of the slide by --reach, which ends at --until of it, as the rest is not looked at. --stiffness is that of the penalty, or of GetFEM's augmented Lagrangian, over Young's modulus of the
block. Prints the mean forces over the middle of the slide, from 0.3 to 0.7 of the reach; the error is the larger one of both against what is known (V 51.39, H 18.27).
"""
import argparse
import json
import os
import pathlib
import shutil
import sys
import tempfile

import ironing_calculix
from getfem_peer import GetFEM
from peers import COLUMNS, write
from process import measured

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tests"))
KNOWN = 51.39, 18.27  # of two programs on fine meshes; they differ by 0.2 and 0.5 %
LOW, HIGH = 0.3, 0.7  # of the slide, where the mean is taken
# what doc/peers.csv has: program and options
COARSE, MIDDLE, FINE = (("--cells", f"{n},{n // 6}", "--press", str(k), "--slide", str(10 * k)) for n, k in ((24, 10), (48, 10), (96, 20)))
LOT = [("amontons", *mesh) for mesh in (COARSE, MIDDLE, FINE)] + [("getfem", *mesh) for mesh in (COARSE, MIDDLE, FINE)]
LOT += [("ccx", "--stiffness", "10", *mesh) for mesh in (COARSE, MIDDLE, FINE)] + [("ccx", "--stiffness", "100", "--limit", "3600")]
LOT += [("amontons", *COARSE, "--cycles", str(n)) for n in (2, 4, 6)] + [("amontons", *MIDDLE, "--degree", "2")]
LOT += [("amontons", *mesh, "--method", method) for mesh in (COARSE, MIDDLE) for method in ("penalty 10", "penalty 1000", "augmented Lagrangian")]


def calculix(folder, given):
    row, found, counted, _ = ironing_calculix.run(folder, given, measured)
    return row, found, counted, "ccx2.20", f"f2f K={given.stiffness:g}E"


def getfem(folder, given):
    path = os.path.join(folder, "answer.json")
    numbers = (given.cells, given.press, given.slide, given.reach, given.until, given.stiffness, given.slave)
    _, row = measured([GetFEM().python, str(ROOT / "tests/peers/ironing_getfem.py"), *map(str, numbers), path], folder, given.limit)
    answer = json.loads(pathlib.Path(path).read_text(encoding="utf-8")) if os.path.exists(path) else {"rows": [], "iterations": 0, "dofs": ""}
    row["dofs"] = answer["dofs"]
    return row, answer["rows"], answer["iterations"], "GetFEM5.4.2", f"ray-tracing Q1 r={given.stiffness:g}E"


def amontons(folder, given):
    """Its increments are equal: the press takes as much less time than the slide as it has fewer of them."""
    pressed = given.press / given.slide
    method, _, factor = given.method.partition(" ") if given.method.startswith("penalty") else (given.method, "", "")
    sets = [f"Boundary condition drive/Value={given.reach}*table({pressed}: 0, {pressed + 1}: 1); -table(0: 0, {pressed}: 1)", f"End time={pressed + given.until}"]
    sets += [f"Increments={round(given.press + given.until * given.slide)}", f"Body block/Cells={given.cells}", f"Discretization/Degree={given.degree}"]
    sets += [f"Contact solver/Method={method}"] + ([f"Contact solver/Penalty factor={factor}"] if factor else [])
    sets += [f"Refinement/Cycles={given.cycles}"] if given.cycles else []
    sets += given.set + ["Output/VTU=false", "Output/Report=false"]
    command = [given.amontons, str(ROOT / "parameters/ironing.prm"), "--output", folder, "--quiet"]
    _, row = measured(command + [part for entry in sets for part in ("--set", entry)], folder, given.limit)
    from scorecard_parts import Answer

    answer = Answer(folder, os.path.join(folder, "log"))
    row["dofs"] = answer.summary.get("dofs", "")
    found = [(1 + line["t"] - pressed, *(abs(line[f"ironing.normal_force_{axis}"] + line[f"ironing.tangential_force_{axis}"]) for axis in "yx")) for line in answer.history if line["mesh"] == answer.history[-1]["mesh"]]
    counted = round(sum(line.get("iterations", 0) for line in answer.history))
    return row, found, counted, "Amontons", f"degree {given.degree} {given.method}" + (" adaptive" if given.cycles else "")


def mean(found):
    """Vertical and horizontal force over the middle of the slide; nothing, where it was not reached."""
    middle = [row for row in found if LOW < row[0] - 1 < HIGH + 1e-9]
    whole = middle and middle[-1][0] > 1 + HIGH - 0.02
    return [sum(row[k] for row in middle) / len(middle) for k in (1, 2)] if whole else None


def cells(text):
    numbers = text.split(",")
    if len(numbers) != 2 or not all(n.isdigit() and int(n) > 0 for n in numbers):
        raise argparse.ArgumentTypeError(f"found '{text}'; allowed: two numbers, across and up, as 96,16")
    return text


def options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", choices=("ccx", "getfem", "amontons"), default="ccx")
    parser.add_argument("--lot", action="store_true")
    for name, kind, default in ("press", int, 20), ("slide", int, 200), ("reach", float, 10.0), ("until", float, HIGH), ("stiffness", float, 10.0), ("limit", float, 600.0):
        parser.add_argument(f"--{name}", type=kind, default=default)
    parser.add_argument("--slave", choices=("block", "die"), default="block", help="of GetFEM")
    parser.add_argument("--cells", default="96,16", type=cells, help="of the block")
    parser.add_argument("--degree", type=int, default=1, help="by Amontons")
    parser.add_argument("--method", default="mortar", help="of Amontons: mortar, penalty 10, augmented Lagrangian, ...")
    parser.add_argument("--set", action="append", default=[], help="of Amontons, as on its command line")
    parser.add_argument("--cycles", type=int, default=0, help="of Amontons: adaptive refinements, for each of which the path is gone again")
    parser.add_argument("--amontons", default=str(ROOT / "build/amontons"))
    parser.add_argument("--write", type=pathlib.Path)
    return parser


def solve(given):
    """The row of the table."""
    with tempfile.TemporaryDirectory(prefix="peers-") as folder:
        row, found, counted, program, formulation = {"ccx": calculix, "getfem": getfem, "amontons": amontons}[given.program](folder, given)
    forces, end = mean(found), given.reach * given.until
    note = f"slide {end:g}; V {forces[0]:.2f} H {forces[1]:.2f} over {LOW * given.reach:.3g}..{HIGH * given.reach:.3g}" if forces else \
        f"not finished: t = {found[-1][0] if found else 0:.3f} after {row['wall']:.0f} s"
    mesh = given.cells.replace(",", "x") + (f"/{given.cycles}" if given.cycles else "")
    return {**dict.fromkeys(COLUMNS, ""), "program": program, "formulation": formulation, "case": "IR2", "N": f"{mesh} {given.press}+{round(given.slide * given.until)}", "threads": "1",
            "dofs": str(row.get("dofs", "")), "wall": f"{row['wall']:.1f}", "cpu": f"{row['cpu']:.1f}", "memory_MB": f"{row['memory_MB']:.0f}", "iterations": str(counted),
            "error": f"{max(abs(f / k - 1) for f, k in zip(forces, KNOWN)):.4f}" if forces else "", "note": note}


def main():
    given = options().parse_args()
    for arguments in LOT if given.lot else [None]:
        one = options().parse_args(["--program", *arguments, "--amontons", given.amontons]) if arguments else given
        if one.program == "ccx" and not shutil.which("ccx") or one.program == "getfem" and GetFEM().missing() or one.program == "amontons" and not os.access(one.amontons, os.X_OK):
            print(f"{one.program} is left out: it is not installed")
            continue
        result = solve(one)
        print(",".join(result[name] for name in COLUMNS), flush=True)
        if given.write:
            write(given.write, [result])


if __name__ == "__main__":
    main()
