#!/usr/bin/env python3
"""A failure atlas: atlas.py AMONTONS [RESULTS.csv] [-j N] [--part K/N] [--only FAMILY] [--keep DIR] [--again] [--list]

Runs small scenes (atlas_scenes.py, atlas_held.py, atlas_compared.py) in which mathematics knows something about the answer, each in a process of its own,
and tells the outcomes:
  right     converged, and all that is known holds;
  refused   there is no equilibrium, and the program says why;
  failed    there is an answer, but the program says that it has not found it (or there is none, but the message does not say why);
  wrong     converged, but something that is known does not hold;
  hang      no end within 120 s;    crash   ended by a signal.
RESULTS.csv gets a row for each; a point that it has is not run again, so that an atlas that was stopped goes on (after a change of the program, begin anew).
Exit code 0: nothing is wrong, hangs or crashes, and of the answers that exist below 0.5 % failed.

-j: so many at once. --part K/N: each N-th point, from the K-th (1 to N). --only: families or points whose names contain this. --keep: folder for the scenes
of all that is neither right nor refused. --again: runs those anew. --list: names of the points.
"""
import argparse
import collections
import concurrent.futures
import csv
import os
import random
import re
import subprocess
import sys
import tempfile
import time

import atlas_compared
import atlas_held
import atlas_scenes
import launch
from atlas_parts import Answer, Point

# Module: families and their numbers of points.
FAMILIES = {
    atlas_scenes: {
        "patch": 120, "thin": 50, "distorted": 50, "patch_friction": 120, "interference": 80, "column": 50, "brought": 50, "tied_pile": 50, "cross": 50,
        "tee": 40, "patch_3d": 40, "cylinders": 40, "shrink": 50, "rings": 20, "finite_patch": 50, "hertz": 20,
    },
    atlas_held: {
        "slab": 50, "slab_over": 16, "slab_3d": 20, "slab_3d_over": 8, "incline": 40, "incline_over": 16, "tipping": 60, "tipping_over": 16, "pulled_over": 24,
        "groove": 30, "corner_3d": 12, "bar": 24, "bar_over": 8, "dragged": 30,
    },
    atlas_compared: {
        "turned": 16, "units": 16, "mirrored": 12, "swapped": 12, "steps": 16, "friction_steps": 16, "sides": 20, "rough_is_tied": 12, "stiff_is_rigid": 16,
        "released": 16, "reversed_shear": 24, "unloaded": 20,
    },
}
CAUSE = r"hold|held|nothing|balance|support"  # what the message of a scene without equilibrium must say
LIMIT = 120
OUTCOMES = ["right", "refused", "failed", "wrong", "hang", "crash"]
GOOD = ("right", "refused")
COLUMNS = ["family", "name", "outcome", "iterations", "increments", "seconds", "what"]


def all_points():
    """Each has random numbers of its own, from its family and number."""
    result = []
    for module, families in FAMILIES.items():
        for family, count in families.items():
            for k in range(count):
                name, scenes, check = getattr(module, family)(random.Random(f"{family} {k}"))
                result.append(Point(family, f"{k} {name}".replace(" ", "_"), scenes, check))
    return result


def write(scene, folder, name):
    """The scene and its meshes as files; where it is."""
    os.makedirs(folder, exist_ok=True)
    for file, text in {**scene.files, name + ".prm": scene.text}.items():
        with open(os.path.join(folder, file), "w") as out:
            out.write(text)
    return os.path.join(folder, name + ".prm")


def solve(program, scene):
    with tempfile.TemporaryDirectory(prefix="amontons-atlas-") as folder:
        start = time.time()
        command = [program, write(scene, folder, "scene"), "--output", folder, "--quiet"]
        done = launch.run(command, capture_output=True, timeout=LIMIT)
        return Answer(folder, done.returncode, (done.stdout + done.stderr).decode(), time.time() - start)


def judge(point, answers):
    """Outcome and what was off."""
    if any(answer.code < 0 or answer.code > 1 for answer in answers):
        return "crash", " | ".join(f"exit code {answer.code}: {answer.output[-300:]}" for answer in answers)
    missed = [answer.summary.get("message") or answer.output[-300:] for answer in answers if not answer.converged]
    messages = " | ".join(missed)
    if point.check is None:
        if len(missed) < len(answers):
            return "wrong", "converged, but there is no equilibrium"
        return ("refused" if re.search(CAUSE, messages) else "failed"), messages
    if missed:
        return "failed", messages
    off = point.check(answers)
    return ("wrong" if off else "right"), "; ".join(off[:3])


def run(program, point, keep):
    answers = []
    try:
        for scene in point.scenes:
            answers.append(solve(program, scene))
        outcome, what = judge(point, answers)
    except subprocess.TimeoutExpired:
        outcome, what = "hang", f"no end within {LIMIT} s"
    if keep and outcome not in GOOD:
        for k, scene in enumerate(point.scenes):
            write(scene, os.path.join(keep, f"{point.family}_{point.name}".replace("/", "_")), f"scene_{k}")
    numbers = [sum(answer.iterations for answer in answers), sum(answer.increments for answer in answers)]
    return [point.family, point.name, outcome, *numbers, f"{sum(answer.seconds for answer in answers):.2f}", " ".join(what.split())]


def read(path, again):
    """Rows of an atlas that was begun, by point."""
    if not os.path.exists(path):
        return {}
    with open(path, newline="") as file:
        rows = [row for row in csv.reader(file) if len(row) == len(COLUMNS)][1:]
    return {(row[0], row[1]): row for row in rows if row[2] in GOOD or not again}


def explore(program, points, results, jobs, keep):
    """Runs what has no row yet, and writes its rows as they come."""
    todo = [point for point in points if (point.family, point.name) not in results]
    start = time.time()
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        tasks = [pool.submit(run, program, point, keep) for point in todo]
        for k, task in enumerate(concurrent.futures.as_completed(tasks)):
            row = task.result()
            yield row
            if row[2] not in GOOD:
                print(f"{row[2]}: {row[0]} {row[1]}: {row[-1]}", flush=True)
            if (k + 1) % 50 == 0 or k + 1 == len(todo):
                print(f"{k + 1} of {len(todo)} points, {(time.time() - start) / (k + 1) * (len(todo) - k - 1) / 60:.1f} minutes left", flush=True)


def summarize(rows):
    """Prints a row per family; whether the aims are met."""
    counts = collections.defaultdict(collections.Counter)
    for row in rows:
        for name in row[0], "all":
            counts[name][row[2]] += 1
            counts[name]["seconds"] += float(row[5])
    families = sorted(name for name in counts if name != "all")
    print(f"\n| {'family':22} | points | " + " | ".join(OUTCOMES) + " | seconds each |\n|---|" + "---|" * (len(OUTCOMES) + 2))
    for name in families + ["all"]:
        total = sum(counts[name][outcome] for outcome in OUTCOMES)
        numbers = " | ".join(f"{counts[name][outcome]:{len(outcome)}}" for outcome in OUTCOMES)
        print(f"| {name:22} | {total:6} | {numbers} | {counts[name]['seconds'] / total:.2f} |")
    every = counts["all"]
    answers = every["right"] + every["failed"]
    return not (every["wrong"] or every["hang"] or every["crash"]) and every["failed"] < 0.005 * max(answers, 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("amontons")
    parser.add_argument("results", nargs="?", default=os.devnull)
    parser.add_argument("-j", type=int, default=2)
    parser.add_argument("--part", default="1/1")
    parser.add_argument("--only", default="")
    parser.add_argument("--keep")
    parser.add_argument("--again", action="store_true")
    parser.add_argument("--list", action="store_true")
    arguments = parser.parse_args()
    part, parts = (int(word) for word in arguments.part.split("/"))
    points = [point for point in all_points()[part - 1 :: parts] if arguments.only in f"{point.family} {point.name}"]
    if arguments.list:
        for point in points:
            print(point.family, point.name)
        return
    results = read(arguments.results, arguments.again)
    with open(arguments.results, "w", newline="") as file:
        table = csv.writer(file)
        table.writerows([COLUMNS] + list(results.values()))
        file.flush()
        for row in explore(arguments.amontons, points, results, arguments.j, arguments.keep):
            results[row[0], row[1]] = row
            table.writerow(row)
            file.flush()
    good = summarize([results[point.family, point.name] for point in points])
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
