#!/usr/bin/env python3
"""What does a change cost? cost.py BEFORE AFTER [--pairs 9] [--callgrind] [--only NAME]

BEFORE and AFTER are two builds of the program; the scenes below have one mesh and given increments, so that both do the same. Prints the processor time of
AFTER over that of BEFORE, the median and the range of alternating pairs, and Newton's turns of both. --callgrind: instructions (millions) of the whole run
and of the iteration instead, on smaller meshes. By hand; where both builds do not know an entry of a scene, give --scenes, the folder of those of BEFORE.
"""
import argparse
import json
import os
import pathlib
import re
import statistics
import subprocess
import tempfile

import launch

PARAMETERS = pathlib.Path(__file__).resolve().parent.parent / "parameters"
ONE_MESH = ["Refinement/Cycles=0", "Output/VTU=false", "Output/Report=false"]
# name: scene, changes, those of --callgrind
SCENES = {
    "small strain 2D": ("hertz_cylinder.prm", ["Body block/Refinements=5"], ["Body block/Refinements=4"]),
    "small strain 3D": ("hertz_sphere.prm", ["Body block/Refinements=2", "Refinement/Initial refinements=5"], ["Refinement/Initial refinements=3"]),
    "friction 2D": ("half_plane_box_friction.prm", ["Body lower/Refinements=3", "Body upper/Refinements=3", "Increments=5"],
                    ["Body lower/Refinements=2", "Body upper/Refinements=2"]),
    "friction 3D": ("mindlin_sphere.prm", ["Increments=4"], []),
    "finite strain 2D": ("ironing.prm", ["End time=0.5", "Increments=25"], ["End time=0.1", "Increments=5"]),
    "finite strain 3D": ("ironing_3d.prm", ["End time=1", "Increments=5"], ["End time=0.2", "Increments=1"]),
}
ITERATION = re.compile(r"Amontons::(?:ContactSolver|SemismoothNewton|FiniteNewton)<\d>::solve\(")


def run(program, folder, scene, changes, prefix=()):
    """Seconds of the processor, turns, and what was printed."""
    with tempfile.TemporaryDirectory(prefix="amontons-cost-") as output:
        command = [*prefix, program, str(folder / scene), "--output", output, "--quiet"]
        for change in changes + ONE_MESH:
            command += ["--set", change]
        log = pathlib.Path(output, "log")
        _, seconds = launch.timed(command, 3600, log)
        summary = json.loads(pathlib.Path(output, "summary.json").read_text())
        return seconds, sum(mesh["iterations"] for mesh in summary["meshes"]), log.read_text()


def instructions(program, folder, scene, changes):
    """Millions, of all and of the iteration."""
    with tempfile.TemporaryDirectory(prefix="amontons-cost-") as output:
        file = os.path.join(output, "callgrind")
        _, turns, text = run(program, folder, scene, changes, ("valgrind", "--tool=callgrind", f"--callgrind-out-file={file}"))
        total = int(re.search(r"Collected : (\d+)", text).group(1))
        table = subprocess.run(["callgrind_annotate", "--inclusive=yes", file], capture_output=True, text=True, check=True).stdout
    iteration = max(int(line.split()[0].replace(",", "")) for line in table.split("\n") if ITERATION.search(line))
    return total / 1e6, iteration / 1e6, turns


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("--pairs", type=int, default=9)
    parser.add_argument("--callgrind", action="store_true")
    parser.add_argument("--only", default="")
    parser.add_argument("--scenes", type=pathlib.Path, default=PARAMETERS)
    arguments = parser.parse_args()
    for name, (scene, changes, smaller) in SCENES.items():
        if arguments.only not in name:
            continue
        if arguments.callgrind:
            (all_before, before, turns), (all_after, after, others) = (
                instructions(program, arguments.scenes, scene, changes + smaller) for program in (arguments.before, arguments.after))
            print(f"{name}: all {all_before:.0f} {all_after:.0f}, {all_after / all_before:.3f}; iteration {before:.0f} {after:.0f}, {after / before:.3f}; "
                  f"turns {turns} {others}", flush=True)
            continue
        ratios = []
        for pair in range(arguments.pairs):
            programs = [arguments.before, arguments.after] if pair % 2 else [arguments.after, arguments.before]
            done = {program: run(program, arguments.scenes, scene, changes) for program in programs}
            ratios.append(done[arguments.after][0] / done[arguments.before][0])
        print(f"{name}: {statistics.median(ratios):.3f} ({min(ratios):.3f} to {max(ratios):.3f}) of {done[arguments.before][0]:.2f} s, "
              f"turns {done[arguments.before][1]} {done[arguments.after][1]}", flush=True)


if __name__ == "__main__":
    main()
