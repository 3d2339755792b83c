#!/usr/bin/env python3
"""Does the program still go the same way? golden.py AMONTONS GOLDEN.json [--record] [--only NAME] [--ranks N] [-j N]

Runs the scenes below with tight tolerances and compares with what was recorded (GOLDEN.json): number of unknowns and meshes, and of every increment the time,
the forces, moments of energy and contact (to `digits`), and the number of iterations, as a range: friction at its limit takes other ways with other digits.
This is for changes that may not change answers (a redesign); where an answer is meant to change, record anew and say so in the commit.

--record: writes what runs say now. --ranks: on so many ranks instead of the recorded ones; --only: names that contain this.
"""
import argparse
import concurrent.futures
import json
import os
import sys
import tempfile

import launch

PARAMETERS = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "parameters")

# name: scene, changes, ranks, digits of the forces (snaps and friction at its limit: fewer), iterations that may be more or less
SCENES = {
    "hertz_q2": ("hertz_cylinder.prm", ["Refinement/Cycles=3"], (1, 2), 1e-8, 1),
    "hertz_q1": ("hertz_cylinder.prm", ["Refinement/Cycles=2", "Discretization/Degree=1"], (1,), 1e-8, 1),
    "sphere_3d": ("hertz_sphere.prm", ["Refinement/Cycles=1"], (1, 3), 1e-8, 1),
    "sphere_axisymmetric": ("hertz_sphere_axisymmetric.prm", ["Refinement/Cycles=2"], (1,), 1e-8, 1),
    "tied": ("verification/tied_patch.prm", [], (1,), 1e-8, 0),
    "three_blocks": ("three_blocks.prm", [], (1, 3), 1e-8, 1),
    "replay": ("cattaneo_mindlin.prm", ["Refinement/Cycles=1", "End time=2.5", "Increments=3", "Output times="], (1, 2), 1e-8, 2),
    "transfer": ("cattaneo_mindlin.prm", ["Refinement/Cycles=2", "Refinement/History=transfer", "End time=2.5", "Increments=5", "Output times="], (1, 2), 1e-8, 2),
    "friction_3d": ("verification/patch_friction_3d.prm", [], (1, 3), 1e-8, 2),
    "friction_limit": ("floating_slab.prm", [], (1,), 1e-6, 4),
    "mindlin_3d": ("mindlin_sphere.prm", ["Refinement/Cycles=0", "Increments=2"], (1,), 1e-8, 2),
    "auto": ("verification/rubber_indentation.prm", ["Refinement/Cycles=0"], (1,), 1e-8, 2),
    "finite": ("verification/objectivity.prm", ["End time=2", "Increments=2"], (1, 2), 1e-8, 2),
    "finite_3d": ("verification/patch_finite_turned_3d.prm", [], (1,), 1e-8, 2),
    "ironing": ("ironing.prm", ["End time=0.3", "Increments=20", "Body block/Cells=24,4"], (1, 2), 1e-8, 2),
    "snap": ("snap_away.prm", [], (1,), 1e-6, 20),
    "greco": ("greco.prm", ["Refinement/Cycles=1"], (1, 3), 1e-8, 2),
    "rotations": ("verification/turned_with_friction.prm", [], (1,), 1e-8, 2),
    "follower_pressure": ("verification/press_finite.prm", [], (1,), 1e-8, 2),
}


def run(program, name, ranks):
    scene, changes, _, _, _ = SCENES[name]
    with tempfile.TemporaryDirectory(prefix="amontons-golden-") as folder:
        command = [program, os.path.join(PARAMETERS, scene), "--output", folder, "--quiet"]
        for change in changes + ["Output/VTU=false", "Output/Report=false", "Contact solver/Tolerance=1e-12"]:
            command += ["--set", change]
        done = launch.run(command, ranks, capture_output=True, timeout=600)
        if done.returncode != 0:
            return {"failed": done.stdout.decode()[-500:] + done.stderr.decode()[-500:]}
        with open(os.path.join(folder, "summary.json")) as file:
            summary = json.load(file)
    increments = []
    for mesh in summary["meshes"]:
        increments.append({
            "t": mesh["t"], "dofs": mesh["dofs"], "energy": mesh["energy"],
            "forces": [[*pair["normal_force"], *pair["tangential_force"]] for pair in mesh["pairs"]],
        })
    return {"increments": increments, "iterations": [solve["iterations"] for solve in summary["newton"]]}


def differences(golden, now, digits, more):
    """What is not as recorded."""
    if "failed" in now:
        return ["fails: " + now["failed"]]
    a, b = golden["increments"], now["increments"]
    if [(x["t"], x["dofs"]) for x in a] != [(x["t"], x["dofs"]) for x in b]:
        return [f"increments and unknowns {[(x['t'], x['dofs']) for x in b]} instead of {[(x['t'], x['dofs']) for x in a]}"]
    result = []
    size = max(abs(f) for x in a for pair in x["forces"] for f in pair)
    energy = max(abs(x["energy"]) for x in a)
    for x, y in zip(a, b):
        worst = max(abs(f - g) for p, q in zip(x["forces"], y["forces"]) for f, g in zip(p, q))
        if worst > digits * size:
            result.append(f"t = {x['t']}: forces differ by {worst / size:.1e} of the largest")
        if abs(x["energy"] - y["energy"]) > digits * energy:
            result.append(f"t = {x['t']}: energy differs by {abs(x['energy'] - y['energy']) / energy:.1e}")
    m, n = golden["iterations"], now["iterations"]
    if len(m) != len(n) or any(abs(i - j) > more for i, j in zip(m, n)):
        result.append(f"iterations {n} instead of {m}, may be {more} more or less")
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("amontons")
    parser.add_argument("golden")
    parser.add_argument("--record", action="store_true")
    parser.add_argument("--only", default="")
    parser.add_argument("--ranks", type=int)
    parser.add_argument("-j", type=int, default=2)
    arguments = parser.parse_args()
    recorded = {}
    if os.path.exists(arguments.golden):
        with open(arguments.golden) as file:
            recorded = json.load(file)
    names = [name for name in SCENES if arguments.only in name]
    failed = False
    with concurrent.futures.ThreadPoolExecutor(arguments.j) as pool:
        if arguments.record:
            for name, now in zip(names, pool.map(lambda name: run(arguments.amontons, name, 1), names)):
                print(name, now.get("failed", now.get("iterations")), flush=True)
                recorded[name] = now
            with open(arguments.golden, "w") as file:
                json.dump(recorded, file, indent=1)
                file.write("\n")
            return
        jobs = [(name, ranks) for name in names for ranks in ((arguments.ranks,) if arguments.ranks else SCENES[name][2])]
        for (name, ranks), now in zip(jobs, pool.map(lambda job: run(arguments.amontons, *job), jobs)):
            found = differences(recorded[name], now, *SCENES[name][3:])
            failed = failed or bool(found)
            print(f"{name} on {ranks}: " + ("; ".join(found) if found else "as recorded"), flush=True)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
