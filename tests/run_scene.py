#!/usr/bin/env python3
"""Runs a scene and checks its summary: run_scene.py AMONTONS OUTPUT RANKS SCENE [--set X]... [--check "path OP value"]... [--fails] [--read-back]

path: dots through objects, numbers through arrays ("pairs.0.peak_pressure", "meshes.-1.reference.errors.contact_size"); what follows a slice
("newton.1:.iterations") or a choice ("contact.X=1.pressure", "contact.pair=roller,state=slip.tx") holds for every element; peak(path) is the
largest magnitude, sum(path) the sum, count(path) how many there are, kink(path) the largest second difference over it. "contact" and "history" are the rows of the two tables, "skew" and "slowdown" see below.
A '|' in X stands for ';', at which CMake splits.
OP: <= >= == abs<= is (a word) has (words in a text), or ~ with "value relative-tolerance"; the value may be a path, which must be one number.
--fails: the program must end with exit code 1.
--read-back: with VTU, report and terminal, all of which are read and compared (read_back.py).
"""
import csv
import json
import math
import os
import shutil
import subprocess
import sys

import launch


def matches(value, wanted):
    return value == wanted if isinstance(value, str) else abs(value - float(wanted)) < 1e-9


def values(node, path):
    if not path:
        return [node]
    head, rest = path[0], path[1:]
    if isinstance(node, list):
        if ":" in head:
            low, high = (int(s) if s else None for s in head.split(":"))
            return [v for item in node[low:high] for v in values(item, rest)]
        if "=" in head:
            wanted = [word.split("=") for word in head.split(",")]
            return [v for item in node if all(matches(item[key], text) for key, text in wanted) for v in values(item, rest)]
        return values(node[int(head)], rest)
    # column names have dots themselves
    n = next(n for n in range(1, len(path) + 1) if ".".join(path[:n]) in node)
    return values(node[".".join(path[:n])], path[n:])


def find(node, text):
    """The values at a path; peak(path): the largest of their magnitudes; sum(path): their sum; count(path): how many; kink(path): of their second differences, relative to the peak."""
    if text.startswith("peak("):
        return [max(abs(v) for v in find(node, text[5:-1]))]
    if text.startswith("sum("):
        return [math.fsum(find(node, text[4:-1]))]
    if text.startswith("count("):
        return [len(find(node, text[6:-1]))]
    if text.startswith("kink("):
        v = find(node, text[5:-1])
        return [max(abs(a - 2 * b + c) for a, b, c in zip(v, v[1:], v[2:])) / max(abs(x) for x in v)]
    return values(node, text.split("."))


def number(node, text):
    """A number, or that at a path."""
    try:
        return float(text)
    except ValueError:
        (value,) = find(node, text)
        return value


def rows(path):
    def cell(text):
        try:
            return float(text)
        except (TypeError, ValueError):
            return text

    if not os.path.exists(path):
        return []
    with open(path) as file:
        return [{key: cell(text) for key, text in row.items()} for row in csv.DictReader(file)]


def skew(contact):
    """Sine of the angle between slip and shear traction where nodes slip: a mean, weighted by area and both magnitudes."""
    across = along = 0
    for row in contact:
        if row["state"] == "slip":
            t, s = ([row[name + c] for c in "xyz"] for name in ("t", "slip_"))
            cross = [t[1] * s[2] - t[2] * s[1], t[2] * s[0] - t[0] * s[2], t[0] * s[1] - t[1] * s[0]]
            across += row["area"] * math.hypot(*cross)
            along += row["area"] * math.hypot(*t) * math.hypot(*s)
    return across / along if along > 0 else 0


def slowdown(newton):
    """Ratio of two reductions of the residual, one after the other, the largest of all solves: well below 1 where convergence is superlinear. Of a solve, those
    at the first residual below 1e-7, or after it if they show more: what comes after may also be how far linear systems were solved."""
    largest = 0
    for solve in newton:
        r = solve["residuals"]
        n = next((k for k, residual in enumerate(r) if residual is not None and residual < 1e-7), 0)
        if n >= 2:
            largest = max(largest, min(r[k] * r[k - 2] / r[k - 1] ** 2 for k in range(n, min(n + 2, len(r)))))
    return largest


def holds(summary, value, operator, numbers):
    if operator == "is":
        return str(value) == numbers[0]
    if operator == "has":
        return " ".join(numbers) in value
    target = number(summary, numbers[0])
    if value is None:
        return False
    if operator == "~":
        return abs(value - target) <= float(numbers[1]) * abs(target)
    return {"<=": value <= target, "abs<=": abs(value) <= target, ">=": value >= target, "==": value == target}[operator]


def failures(output, checks):
    """How many of the checks do not hold; says so of each."""
    with open(os.path.join(output, "summary.json")) as file:
        summary = json.load(file)
    for table in "contact", "history":
        summary[table] = rows(os.path.join(output, table + ".csv"))
    summary["skew"] = skew(summary["contact"])
    summary["slowdown"] = slowdown(summary["newton"])
    failed = 0
    for check in checks:
        words = check.split()
        found = find(summary, words[0])
        good = bool(found) and all(holds(summary, v, words[1], words[2:]) for v in found)
        print(f"{'ok    ' if good else 'FAILED'} {check}   found {found if len(found) < 9 else found[:9]}")
        failed += not good
    return failed


def main():
    executable, output, ranks, scene = sys.argv[1:5]
    flags = [a for a in sys.argv[5:] if a in ("--fails", "--read-back")]
    arguments = [a for a in sys.argv[5:] if a not in flags]
    expected = 1 if "--fails" in flags else 0
    sets, checks = [], []
    for flag, text in zip(arguments[::2], arguments[1::2]):
        (sets if flag == "--set" else checks).append(text)
    shutil.rmtree(output, ignore_errors=True)
    command = [executable, scene, "--output", output]
    if "--read-back" not in flags:
        command += ["--quiet", "--set", "Output/VTU=false", "--set", "Output/Report=false"]
    for text in sets:
        command += ["--set", text.replace("|", ";")]
    done = launch.run(command, ranks, timeout=1200, stdout=subprocess.PIPE, universal_newlines=True)
    if done.returncode != expected:
        sys.exit(f"{done.stdout}\n{' '.join(command)}: exit code {done.returncode}")
    failed = failures(output, checks)
    reread = []
    if "--read-back" in flags:
        import read_back  # what it needs takes a third of the time that all else does

        reread = read_back.check(output, done.stdout)
    for what, good, detail in reread:
        print(f"{'ok    ' if good else 'FAILED'} {what}   {'' if good else detail}")
        failed += not good
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
