#!/usr/bin/env python3
"""Runs are killed at random moments, and resumed: nothing may be lost, and the answer is that of a run that nobody killed.

    tests/kills.py build/amontons N [--seed S] [--ranks R] [--resume-ranks Q] [--scene FILE] [--set ENTRY]... [--signal KILL|TERM|INT]

At every kill all files in the folder must be whole, and the resumed run must give, on the same ranks, the same increments, meshes
and iterations; numbers within ten times 'Tolerance' of their size (on other ranks: within 1e-6, or --allowed)."""

import argparse
import contextlib
import csv
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree

TOLERANCE = 1e-10  # the default of 'Contact solver/Tolerance'
ROW = ["increment", "t", "mesh", "cells", "dofs", "iterations"]
COMPARED = ["normal", "tangential", "peak", "contact", "energy", "external"]  # beginnings of the names of columns


def kind(name):
    """Of a column: what it is relative to is the largest of its kind."""
    return "force" if "_force_" in name else name


def command(program, ranks, arguments):
    mpi = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
    return mpi + [program] + arguments


def start(program, ranks, arguments, folder):
    environment = dict(os.environ, TMPDIR=folder, OPENBLAS_NUM_THREADS="1")
    return subprocess.Popen(command(program, ranks, arguments), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            env=environment, start_new_session=True)


def end_of(process, limit=600):
    """Its output and exit code; what does not end is killed, and that is an error."""
    try:
        output, _ = process.communicate(timeout=limit)
        return output, process.returncode
    except subprocess.TimeoutExpired:
        kill_all(process)
        process.communicate()
        return "no end after %d s" % limit, -1


def descendants(pid):
    """The ranks that mpirun has started have process groups of their own, and outlive it for a while."""
    with open(f"/proc/{pid}/task/{pid}/children") as file:
        children = [int(word) for word in file.read().split()]
    return children + [grandchild for child in children for grandchild in descendants(child)]


def kill_all(process):
    """All at once, as when a machine goes down; comes back when none is left to write or to hold the lock."""
    processes = descendants(process.pid)
    os.killpg(process.pid, signal.SIGKILL)
    for pid in processes:
        with contextlib.suppress(ProcessLookupError):
            os.kill(pid, signal.SIGKILL)
    for pid in processes:
        while is_alive(pid):
            time.sleep(0.01)


def is_alive(pid):
    try:
        with open(f"/proc/{pid}/stat") as file:
            return file.read().rpartition(")")[2].split()[0] not in "ZX"
    except (FileNotFoundError, ProcessLookupError):
        return False


def half_written(folder):
    """Files that cannot be read."""
    bad = []
    for place, _, files in os.walk(folder):
        if os.path.basename(place) == "checkpoint":  # checked by its checksums when it is resumed
            continue
        for name in files:
            path = os.path.join(place, name)
            try:
                if name.endswith((".vtu", ".pvtu", ".pvd")):
                    xml.etree.ElementTree.parse(path)
                elif name.endswith(".json"):
                    json.load(open(path))
                elif name.endswith(".csv"):
                    rows = list(csv.reader(open(path)))
                    if not rows or any(len(row) != len(rows[0]) for row in rows):
                        bad.append(name + ": rows of different lengths")
                elif name.endswith(".html") and "</html>" not in open(path).read():
                    bad.append(name + ": no end")
            except (xml.etree.ElementTree.ParseError, ValueError) as error:
                bad.append(f"{name}: {error}")
    return bad


def answer_of(folder):
    with open(os.path.join(folder, "summary.json")) as file:
        summary = json.load(file)
    with open(os.path.join(folder, "history.csv")) as file:
        history = list(csv.DictReader(file))
    return summary, history


def differences(one, other, same_ranks, allowed):
    (summary, history), (expected, wanted) = one, other
    bad = []
    if summary["status"] != expected["status"]:
        bad.append(f"{summary['status']}: {summary.get('message')}")
    if len(history) != len(wanted):
        return bad + [f"{len(history)} rows of history.csv instead of {len(wanted)}"]
    for row, right in zip(history, wanted):
        for name in ROW if same_ranks else ROW[:-1]:
            if abs(float(row[name]) - float(right[name])) > 1e-12 * abs(float(right[name])):
                bad.append(f"increment {right['increment']} on mesh {right['mesh']}: {name} {row[name]} instead of {right[name]}")
        for name in right:
            if name.split(".")[-1].split("_")[0] in COMPARED and right[name] != "nan":
                largest = max(abs(float(r[other])) for r in wanted for other in r if kind(other) == kind(name) and r[other] != "nan")
                if not abs(float(row[name]) - float(right[name])) <= allowed * largest:
                    bad.append(f"increment {right['increment']} on mesh {right['mesh']}: {name} {row[name]} instead of {right[name]}")
    return bad


def tally(parts):
    return ", ".join(f"{name} {count}" for name, count in parts.items())


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("n", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--ranks", type=int, default=1)
    parser.add_argument("--resume-ranks", type=int)
    parser.add_argument("--scene", default=os.path.join(os.path.dirname(os.path.abspath(__file__)), "../parameters/mindlin_sphere.prm"))
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--signal", choices=["KILL", "TERM", "INT"], default="KILL")
    parser.add_argument("--allowed", type=float)
    options = parser.parse_args()
    program = os.path.abspath(options.program)
    resume_ranks = options.resume_ranks or options.ranks
    same_ranks = resume_ranks == options.ranks
    allowed = options.allowed or (10 * TOLERANCE if same_ranks else 1e-6)
    entries = ["--set", "Output/Checkpoint every = 1 increment"]
    for entry in options.set:
        entries += ["--set", entry]
    chance = random.Random(options.seed)
    counts, failures = {"resumed": 0, "started again": 0, "had ended": 0}, []

    with tempfile.TemporaryDirectory(prefix="amontons-kills-") as folder:
        whole = os.path.join(folder, "whole")
        before = time.monotonic()
        output, code = end_of(start(program, options.ranks, [options.scene, "--output", whole] + entries, folder))
        seconds = time.monotonic() - before
        if code != 0:
            sys.exit("the run itself fails:\n" + output)
        expected = answer_of(whole)
        for k in range(options.n):
            out = os.path.join(folder, "killed")
            shutil.rmtree(out, ignore_errors=True)
            process = start(program, options.ranks, [options.scene, "--output", out] + entries, folder)
            begun, moment = time.monotonic(), chance.uniform(0.02, 1) * seconds
            try:
                process.wait(moment)
                seconds = min(seconds, time.monotonic() - begun)  # the machine was busier before
            except subprocess.TimeoutExpired:
                if options.signal == "KILL":
                    kill_all(process)
                else:
                    os.kill(process.pid, getattr(signal, "SIG" + options.signal))
            output, code = end_of(process)
            problems = half_written(out)
            if code == 0:
                counts["had ended"] += 1
            elif options.signal != "KILL" and options.ranks == 1 and code != 2:
                problems.append(f"exit code {code} after SIG{options.signal}: {output[-300:]}")
            elif os.path.isfile(os.path.join(out, "checkpoint", "run")):
                counts["resumed"] += 1
                output, code = end_of(start(program, resume_ranks, ["--resume", out], folder))
            else:  # killed before its first increment
                counts["started again"] += 1
                output, code = end_of(start(program, resume_ranks, [options.scene, "--output", out] + entries, folder))
            if code != 0:
                problems.append(f"exit code {code}: {output[-400:]}")
            else:
                problems += half_written(out) + differences(answer_of(out), expected, same_ranks, allowed)
                left = [name for name in os.listdir(out) if name in ("checkpoint", "earlier_run", ".lock") or name.endswith(".tmp")]
                problems += [f"{name} is left" for name in left]
            if problems:
                failures.append(f"killed after {moment:.2f} of {seconds:.2f} s: " + "; ".join(problems[:4]))
    print(f"{options.n} kills of a run of {seconds:.1f} s: {tally(counts)}; {len(failures)} failures")
    print("\n".join(failures))
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
