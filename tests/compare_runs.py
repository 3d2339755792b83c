#!/usr/bin/env python3
"""Runs one scene in several ways and compares: compare_runs.py AMONTONS OUTPUT SCENE [--set X]... --run "RANKS | SET | SET"... [--check X]... [OPTION]...

The first run is the reference. The same forces, reactions, peaks, sizes, sets, energies and rows of contact.csv (sorted by place), to a relative tolerance.
--set: a '|' in X stands for ';'. --check: of the first run, as those of run_scene.py.
--tolerance 1e-8: of forces and pressures;  --iterations 0: by how much the iterations on a mesh may differ;
--any-iterations: by whatever;  --forces-only: no contact.csv.
--history T: instead of all that, the force on the pairs' first bodies from t = T on, whichever side is the slave: each component to the tolerance.
"""
import csv
import json
import os
import shutil
import sys

import launch
import run_scene


def run(executable, output, scene, ranks, sets):
    shutil.rmtree(output, ignore_errors=True)
    command = [executable, scene, "--output", output, "--quiet"]
    for text in sets:
        command += ["--set", text]
    code = launch.run(command, ranks, timeout=1200).returncode
    if code != 0:
        sys.exit(f"{' '.join(command)}: exit code {code}")
    with open(os.path.join(output, "summary.json")) as file:
        summary = json.load(file)
    with open(os.path.join(output, "contact.csv")) as file:
        rows = list(csv.DictReader(file))
    # a hanging node may lie on a node of the coarser face: it has no area
    rows.sort(key=lambda r: (r["pair"], *(round(float(r[c]), 9) for c in "XYZ"), float(r["area"]) > 0))
    return summary, rows


def compare(first, other, tolerance, iterations, forces_only):
    """The differences, as messages."""
    messages = []

    def near(what, a, b, scale):
        if not abs(a - b) <= tolerance * scale:
            messages.append(f"{what}: {a} and {b}")

    (s, rows), (t, others) = first, other
    found = [n["iterations"] for n in s["newton"]], [n["iterations"] for n in t["newton"]]
    if iterations is not None and (len(found[0]) != len(found[1]) or any(abs(a - b) > iterations for a, b in zip(*found))):
        messages.append(f"iterations: {found[0]} and {found[1]}")
    for p, q in zip(s["pairs"], t["pairs"]):
        force = max(sum(f * f for f in p["normal_force"]) ** 0.5, 1e-300)
        for kind in "normal_force", "tangential_force":
            for a, b in zip(p[kind], q[kind]):
                near(f"{p['name']} {kind}", a, b, force)
        for kind in "peak_pressure", "contact_size":
            near(f"{p['name']} {kind}", p[kind], q[kind], abs(p[kind]))
        for kind in "n_open", "n_stick", "n_slip":
            if p[kind] != q[kind]:
                messages.append(f"{p['name']} {kind}: {p[kind]} and {q[kind]}")
    size = max([abs(float(r[c])) for r in rows for c in "XYZ"] or [0])
    largest = max([abs(f) for r in s["reactions"] for f in r["force"]] or [0])
    for p, q in zip(s["reactions"], t["reactions"]):
        for kind, scale in ("force", largest), ("moment", largest * size):
            for a, b in zip(p[kind], q[kind]):
                near(f"reaction {p['boundary']} {kind}", a, b, scale)
    # Where increments differ, so does the dissipation: it is the sum of their last tractions times slip.
    for kind in ("energy", "external_work") if iterations is None else ("energy", "external_work", "dissipation"):
        a, b = (m["meshes"][-1].get(kind) for m in (s, t))
        if a is None or b is None:  # works are those of load histories
            continue
        near(kind, a, b, max(abs(a), abs(s["meshes"][-1].get("external_work") or 0)))
    if forces_only:
        return messages
    if len(rows) != len(others):
        messages.append(f"rows of contact.csv: {len(rows)} and {len(others)}")
    peak = max([abs(float(r["pressure"])) for r in rows] or [0])
    for r, o in zip(rows, others):
        place = f"{r['pair']} ({r['X']}, {r['Y']}, {r['Z']})"
        for name in "pressure", "tx", "ty", "tz":
            near(f"{place} {name}", float(r[name]), float(o[name]), peak)
        if r["state"] != o["state"]:
            messages.append(f"{place} state: {r['state']} and {o['state']}")
    return messages


def forces(output):
    """{pair: [(t, force)]} of the converged increments. Forces of a file act on the slave: turned to be those of positive last component at the end."""
    with open(os.path.join(output, "history.csv")) as file:
        rows = {float(r["t"]): r for r in csv.DictReader(file)}  # the last of each time: on the finest mesh
    found = {}
    for name in next(iter(rows.values())):
        if name.endswith(".normal_force_x"):
            pair = name[: -len(".normal_force_x")]
            axes = [c for c in "xyz" if f"{pair}.normal_force_{c}" in rows[min(rows)]]
            total = [(t, [float(rows[t][f"{pair}.normal_force_{c}"]) + float(rows[t][f"{pair}.tangential_force_{c}"]) for c in axes]) for t in sorted(rows)]
            sign = 1 if total[-1][1][-1] > 0 else -1
            found[pair] = [(t, [sign * f for f in force]) for t, force in total]
    return found


def compare_histories(output, other, tolerance, start):
    """The differences, as messages; between the times of the other run its forces are interpolated."""
    messages, reference = [], forces(output)
    for pair, others in forces(other).items():
        largest = 0
        for t, force in reference[pair]:
            after = next((i for i, (s, _) in enumerate(others) if s >= t - 1e-12), None)
            if t < start - 1e-12:
                continue
            if not after:
                messages.append(f"{pair}: no force at t = {t}")
                continue
            (s, f), (r, g) = others[after - 1], others[after]
            for a, b, c in zip(force, f, g):
                b += (c - b) * (t - s) / (r - s)
                largest = max(largest, abs(a - b) / max(abs(a), 1e-300))
                if not abs(a - b) <= tolerance * abs(a):
                    messages.append(f"{pair} force at t = {t}: {a} and {b}")
        print(f"       {pair}: components of the force differ by {100 * largest:.2f} % at most")
    return messages


def main():
    executable, output, scene = sys.argv[1:4]
    checks, sets, runs, tolerance, iterations, forces_only, start = [], [], [], 1e-8, 0, False, None
    arguments = sys.argv[4:]
    while arguments:
        flag = arguments.pop(0)
        if flag == "--forces-only":
            forces_only = True
        elif flag == "--any-iterations":
            iterations = None
        elif flag == "--history":
            start = float(arguments.pop(0))
        elif flag == "--check":
            checks.append(arguments.pop(0))
        elif flag == "--set":
            sets.append(arguments.pop(0).replace("|", ";"))
        elif flag == "--run":
            runs.append([word.strip() for word in arguments.pop(0).split("|")])
        elif flag == "--tolerance":
            tolerance = float(arguments.pop(0))
        elif flag == "--iterations":
            iterations = int(arguments.pop(0))
        else:
            sys.exit(f"unknown option {flag}")
    results = [run(executable, f"{output}_{i}", scene, r[0], sets + r[1:]) for i, r in enumerate(runs)]
    failed = run_scene.failures(f"{output}_0", checks)
    for i, (words, result) in enumerate(zip(runs[1:], results[1:])):
        if start is None:
            messages = compare(results[0], result, tolerance, iterations, forces_only)
        else:
            messages = compare_histories(f"{output}_0", f"{output}_{i + 1}", tolerance, start)
        print(f"{'FAILED' if messages else 'ok    '} {' | '.join(runs[0])} against {' | '.join(words)}")
        for message in messages[:10]:
            print(f"         {message}")
        failed += bool(messages)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
