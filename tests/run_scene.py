#!/usr/bin/env python3
"""Runs a scene and checks its summary: run_scene.py AMONTONS OUTPUT RANKS SCENE [--set X]... [--check "path OP value"]...

path: dots through objects, numbers through arrays ("pairs.0.peak_pressure", "meshes.-1.reference.errors.contact_size");
"all(newton.1:.iterations)" style slices: "newton.1:.iterations" holds for every element.  OP: <= >= == or ~ (with "value rel tolerance").
"""
import json
import os
import shutil
import subprocess
import sys


def values(node, path):
    if not path:
        return [node]
    head, rest = path[0], path[1:]
    if isinstance(node, list):
        if ":" in head:
            low, high = (int(s) if s else None for s in head.split(":"))
            return [v for item in node[low:high] for v in values(item, rest)]
        return values(node[int(head)], rest)
    return values(node[head], rest)


def holds(value, operator, numbers):
    if operator == "is":
        return str(value) == numbers[0]
    target = float(numbers[0])
    if value is None:
        return False
    if operator == "~":
        return abs(value - target) <= float(numbers[1]) * abs(target)
    return {"<=": value <= target, ">=": value >= target, "==": value == target}[operator]


def main():
    executable, output, ranks, scene = sys.argv[1:5]
    sets, checks = [], []
    for flag, text in zip(sys.argv[5::2], sys.argv[6::2]):
        (sets if flag == "--set" else checks).append(text)
    shutil.rmtree(output, ignore_errors=True)
    command = [executable, scene, "--output", output, "--quiet"]
    for text in sets:
        command += ["--set", text]
    environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    if int(ranks) > 1:
        command = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-np", ranks] + command
    code = subprocess.run(command, env=environment, timeout=1200).returncode
    if code != 0:
        sys.exit(f"{' '.join(command)}: exit code {code}")
    with open(os.path.join(output, "summary.json")) as file:
        summary = json.load(file)
    failed = 0
    for check in checks:
        words = check.split()
        found = values(summary, words[0].split("."))
        good = bool(found) and all(holds(v, words[1], words[2:]) for v in found)
        print(f"{'ok    ' if good else 'FAILED'} {check}   found {found if len(found) < 9 else found[:9]}")
        failed += not good
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
