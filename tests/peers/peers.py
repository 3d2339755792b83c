#!/usr/bin/env python3
"""Other programs on the scenes of Amontons: peers.py [--case H2] [--program ccx|getfem|amontons] [--n 20,40] [--repeat 3] [--write FILE] [--compare FILE].

CalculiX and GetFEM (Debian: calculix-ccx, python3-getfem) get the scenes of cases.py with the same meshes, material and loads. Of each run: error of the pressure against
Hertz's for the force that was found, iterations, unknowns, seconds and memory of the whole process; of its linear partner on the same mesh (glued where contact will be) the
same, in turns, so that their ratio does not depend on what else the machine does. Medians of --repeat runs, of fewer where they are long. A program that is not installed is left out, and that is said.
"""
import argparse
import csv
import pathlib
import re
import statistics
import tempfile
import time

from amontons_peer import Amontons
from calculix import CalculiX
from cases import CASES
from getfem_peer import GetFEM
from process import measured

COLUMNS = "program formulation case N dofs threads wall cpu memory_MB iterations error note".split()
LIMIT = 120  # seconds of one run
PATIENCE = 20  # seconds, after which nothing is repeated
DECIMALS = {"wall": 3, "cpu": 3, "memory_MB": 0, "error": 4}


class Failed(RuntimeError):
    pass


def once(program, case, formulation, N):
    with tempfile.TemporaryDirectory(prefix="peers-") as folder:
        def start(command):
            code, row = measured(command, folder, LIMIT)
            if code:
                raise Failed(f"exit code {code} after {row['wall']:.0f} s")
            return row

        return program.run(case, formulation, N, folder, start)


def row_of(runs, **head):
    row = {**runs[0], **head, "threads": 1}
    for key in ("wall", "cpu", "memory_MB"):
        row[key] = statistics.median(run[key] for run in runs)
    return {key: f"{row[key]:.{DECIMALS[key]}f}" if key in DECIMALS and key in row else str(row.get(key, "")) for key in COLUMNS}


def pair(program, case, formulation, N, repeat, known):
    """Rows of a run and of its linear partner, in turns. Amontons measures the partner within the run."""
    partner = program.forms[formulation][2]
    many, begin = {formulation: [], partner: []}, time.monotonic()
    for k in range(repeat):
        if k and time.monotonic() - begin > PATIENCE:
            break
        for form in filter(None, many):
            if form == formulation or (case.name, form, N) not in known:
                many[form].append(once(program, case, form, N))
    head = {"program": program.name, "case": case.name, "N": N}
    rows = [row_of(runs, formulation=form, **head) for form, runs in many.items() if runs]
    if "linear" in many[formulation][0]:
        seconds = statistics.median(run["linear"] for run in many[formulation])
        rows.append({**dict.fromkeys(COLUMNS, ""), **head, "N": str(N), "formulation": f"linear/{formulation}", "dofs": rows[0]["dofs"], "threads": "1", "cpu": f"{seconds:.4f}", "iterations": "1"})
    known.add((case.name, partner, N))
    return rows


def key(row):
    return row["program"], row["formulation"], row["case"], str(row["N"]), "" if row["case"].startswith("IR") else row["note"]  # of ironing that is the answer


def read(path):
    """Lines of the head, rows."""
    if not path.exists():
        return [], []
    lines = path.read_text(encoding="utf-8").splitlines()
    rows = csv.DictReader(line for line in lines if not line.startswith("#"))
    return [line for line in lines if line.startswith("#")], [{name: row.get(name) or "" for name in COLUMNS} for row in rows]


def write(path, new):
    """Rows of the same program, formulation, case and N are replaced."""
    head, rows = read(path)
    rows = [row for row in rows if key(row) not in {key(row) for row in new}] + new
    rows.sort(key=lambda row: (list(CASES).index(row["case"]) if row["case"] in CASES else 9, row["program"], row["formulation"], int(re.match(r"\d*", row["N"])[0] or 0)))
    path.write_text("\n".join(head + [",".join(COLUMNS)] + [",".join(row[name] for name in COLUMNS) for row in rows]) + "\n", encoding="utf-8")


def linear_seconds(rows, row, partner):
    same = [other for other in rows if (other["program"], other["case"], other["N"], other["formulation"]) == (row["program"], row["case"], row["N"], partner)]
    return float(same[0]["cpu"]) if same else None


def compare(rows, path, programs):
    """A table of what was found beside what another file has."""
    _, others = read(path)
    others = [row for row in others if row["threads"] in ("", "1")]
    partners = {form: value[2] for program in programs for form, value in program.forms.items()}
    print("| case | program | formulation | N | DoFs | error | iterations | over one linear solve |\n|---|---|---|---|---|---|---|---|")
    for row in rows:
        same = [other for other in others if key(other) == key(row)] or [other for other in others if key(other)[:4] == key(row)[:4]]
        if not same or not row["error"]:
            continue
        ratios = []
        for table, one in ((rows, row), (others, same[0])):
            linear = linear_seconds(table, one, partners.get(row["formulation"]))
            ratios.append(f"{float(one['cpu']) / linear:.1f}" if linear else "")
        cells = [row["case"], row["program"], row["formulation"], row["N"]] + [f"{row[name]} ({same[0][name]})" for name in ("dofs", "error", "iterations")]
        print("| " + " | ".join(map(str, cells + [f"{ratios[0]} ({ratios[1]})"])) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--case", help="of " + ", ".join(CASES) + "; several with commas")
    parser.add_argument("--program", help="of ccx, getfem, amontons; several with commas")
    parser.add_argument("--formulation", help="as f2f/CPE4")
    parser.add_argument("--n", help="elements over the half-width (Amontons: refinements), with commas")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--amontons", default=str(pathlib.Path(__file__).resolve().parent.parent.parent / "build/amontons"))
    parser.add_argument("--write", type=pathlib.Path, help="table to write rows into")
    parser.add_argument("--compare", type=pathlib.Path, help="table to print the found rows beside; alone with --write: all rows of that table")
    parser.add_argument("--only-compare", action="store_true", help="run nothing")
    given = parser.parse_args()
    programs = {"ccx": CalculiX(), "getfem": GetFEM(), "amontons": Amontons(given.amontons)}
    found = []
    for name, program in programs.items():
        if given.only_compare or given.program and name not in given.program.split(","):
            continue
        if program.missing():
            print(f"{name} is left out: {program.missing()}")
            continue
        for case, lot in program.lot.items():
            if given.case and case not in given.case.split(","):
                continue
            known = set()
            for formulation, numbers in lot.items():
                if given.formulation and formulation != given.formulation:
                    continue
                for N in [int(n) for n in given.n.split(",")] if given.n else numbers:
                    try:
                        rows = pair(program, CASES[case], formulation, N, given.repeat, known)
                    except Failed as reason:
                        print(f"{name}, {case}, {formulation}, N = {N}: {reason}", flush=True)
                        continue
                    for row in rows:
                        print(",".join(row[name] for name in COLUMNS), flush=True)
                    found += rows
                    if given.write:
                        write(given.write, rows)
    if given.compare:
        compare(read(given.write)[1] if given.write else found, given.compare, programs.values())


if __name__ == "__main__":
    main()
