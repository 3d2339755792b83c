#!/usr/bin/env python3
"""Error against seconds beside other programs: peers_chart.py [AMONTONS] draws doc/pictures/peers.svg from doc/peers.csv, and before that measures Amontons' rows anew if AMONTONS is given (2 minutes).

Runs verification/peers_cylinder.prm and peers_shear.prm with 2 to 12 (10) refinements, three times each, one after the other; keep the machine quiet. The error is measured as tests/scorecard.py does,
seconds are of the processor, of the whole process, its start with them.
"""
import csv
import math
import pathlib
import statistics
import sys

from figures import BLUE, FOLDER, GREEN, GREY, INK, RED, Figure

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests"))
TABLE = ROOT / "doc/peers.csv"
CASES = {"H2": ("peers_cylinder", 2, range(2, 13, 2)), "CM": ("peers_shear", 1, range(2, 11, 2))}  # scene, share of the force that is meshed, refinements
CURVES = [
    ("Amontons", "degree 1", BLUE, "5 3", "Amontons, linear"), ("Amontons", "degree 2", BLUE, "", "Amontons, quadratic"),
    ("GetFEM5.4.2", "ALM-Q1/Q1", GREEN, "5 3", "GetFEM, linear"), ("GetFEM5.4.2", "ALM-Q2/Q2", GREEN, "", "GetFEM, quadratic"),
    ("ccx2.20", "f2f/CPE4", RED, "5 3", "CalculiX, face to face, linear"), ("ccx2.20", "MORTAR/C3D8", "#c98a1b", "5 3", "CalculiX, mortar, linear")]


def read():
    lines = TABLE.read_text(encoding="utf-8").splitlines()
    return [line for line in lines if line.startswith("#")], list(csv.DictReader(line for line in lines if not line.startswith("#")))


def measure(program):
    """Rows of Amontons: of the whole run, and of the first linear solve of its last mesh."""
    from scorecard_benchmarks import BLOCK, CIRCLE, compared, line_floor
    from scorecard_parts import Runner

    rows = []
    for case, (scene, share, refinements) in CASES.items():
        for degree in (1, 2):
            for cycles in refinements:
                seconds, linear = [], []
                for _ in range(3):
                    run = Runner(program)
                    answer = run(f"verification/{scene}.prm", f"Discretization/Degree={degree}", f"Refinement/Cycles={cycles}")
                    seconds.append(run.seconds)
                    linear.append(answer.summary["one_linear_solve_seconds"])
                error = compared(answer, share, line_floor, f"{BLOCK}, {CIRCLE}", "")[0].error
                head = {"program": "Amontons", "case": case, "N": cycles, "dofs": answer.summary["dofs"]}
                rows.append({**head, "formulation": f"degree {degree}", "cpu": f"{statistics.median(seconds):.2f}", "error": f"{error:.4f}"})
                rows.append({**head, "formulation": f"linear/degree {degree}", "cpu": f"{statistics.median(linear):.4f}", "error": ""})
                print(rows[-2], flush=True)
    return rows


def draw(rows):
    f = Figure("peers", 760, 420)
    f.path = FOLDER / "peers.svg"
    low, high, bottom, top = 0.3, 40.0, 1e-3, 0.1
    for column, (case, title) in enumerate((("H2", "without friction"), ("CM", "with friction"))):
        left, upper, width, height = 62 + 370 * column, 40, 310, 262

        def place(x, y, left=left, upper=upper, width=width, height=height):
            return left + width * math.log(x / low) / math.log(high / low), upper + height * math.log(top / y) / math.log(top / bottom)

        f.text(left + width / 2, 24, title, INK, "middle", 14, True)
        for x in (0.3, 1, 3, 10, 30):
            f.line([place(x, top), place(x, bottom)], "#e4e7ea", 1)
            f.text(*map(sum, zip(place(x, bottom), (0, 17))), f"{x:g}", INK, "middle", 12)
        for y in (0.1, 0.03, 0.01, 0.003, 0.001):
            f.line([place(low, y), place(high, y)], "#e4e7ea", 1)
            f.text(left - 6, place(low, y)[1] + 4, f"{100 * y:g} %", INK, "end", 12)
        f.line([place(low, top), place(low, bottom), place(high, bottom)], GREY, 1)
        f.text(left + width / 2, upper + height + 36, "processor seconds of the whole process", INK, "middle", 13)
        for program, formulation, colour, dash, _ in CURVES:
            points = sorted((float(row["cpu"]), float(row["error"])) for row in rows if (row["program"], row["formulation"], row["case"]) == (program, formulation, case))
            points = [place(*point) for point in points if point[1] <= top]
            f.line(points, colour, 2, dash) if len(points) > 1 else None
            for point in points:
                f.dot(*point, colour, 3.5, hollow=bool(dash))
    f.text(8, 24, "error of the pressure", INK, "start", 11)
    for k, (_, _, colour, dash, name) in enumerate(CURVES):
        x, y = 62 + 220 * (k // 2), 372 + 24 * (k % 2)
        f.line([(x, y), (x + 34, y)], colour, 2, dash)
        f.dot(x + 17, y, colour, 3.5, hollow=bool(dash))
        f.text(x + 42, y + 5, name, INK, "start", 13)
    f.save()


def main():
    head, rows = read()
    if len(sys.argv) > 1:
        rows = [row for row in rows if row["program"] != "Amontons"] + measure(str(pathlib.Path(sys.argv[1]).resolve()))
        columns = ["program", "formulation", "case", "N", "dofs", "cpu", "error"]
        TABLE.write_text("\n".join(head + [",".join(columns)] + [",".join(str(row[name]) for name in columns) for row in rows]) + "\n", encoding="utf-8")
    draw(rows)


if __name__ == "__main__":
    main()
