#!/usr/bin/env python3
"""Damaged input: fuzz.py PROGRAM N [--seed S] [-j JOBS] [--keep DIR] [--readers] [--seconds T] [--memory KB]

Damages shipped scenes, studies, meshes (.geo, .msh), CAD files, a scene as JSON and a mesh of Abaqus at random, N times (the same ones for the same seed), has each
read, and counts what came: an answer, a refusal (exit code 1, one message of at most 2 kB and 20 lines in valid UTF-8), or what must not be: a crash, a hang, more
than MEMORY, another message. Those are kept, with what was said. PROGRAM is build/amontons, which solves what is still a scene; with --readers it is
build/tests/read_inputs, which reads all in one process, some hundred in a second. A gmsh file may mesh for ever, which the program ends after a minute.
"""
import argparse
import collections
import concurrent.futures
import json
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time

import launch
import readers
import scene_text

PARAMETERS = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "parameters")
MEMORY, READING_MEMORY = 8_000_000, 2_000_000  # kB, of addresses
SECONDS = 10
GMSH_SECONDS = 62
GOOD = ("answer", "refusal", "long")
WORDS = [b"nan", b"inf", b"-1", b"0", b"1e308", b"1e-308", b"9" * 20, b"", b"\x00", b"\xff\xfe", b"(" * 7, b"end\n", b"subsection X\n", b"include /dev/zero\n", b"x" * 3000,
         b"0/0", b"sqrt(-1)", b"%s%n", b";", b",", b"=", b"\\\n", b"set "]
FAST = ["--set", "Refinement/Cycles=0", "--set", "Refinement/Target error=0", "--set", "Output/VTU=false", "--set", "Output/Report=false"]
# what is damaged, and the scene that reads it
READ_BY = {"nafems_punch.geo": "nafems_punch.prm", "ironing.geo": "ironing.prm", "snap_away.geo": "snap_away.prm", "step_file.msh": "step_file.prm",
           "step_file.step": "step_file.prm", "patch_3d_step.msh": "verification/patch_3d_step.prm", "patch_3d_lower.msh": "verification/patch_3d_irregular.prm"}



def abaqus_mesh(n):
    """A unit square of n times n cells."""
    place = range(n + 1)
    lines = ["*NODE"] + [f"{1 + i + (n + 1) * j}, {i / n}, {j / n}" for j in place for i in place] + ["*ELEMENT, TYPE=CPE4, ELSET=all"]
    for j in range(n):
        for i in range(n):
            first = 1 + i + (n + 1) * j
            lines.append(f"{1 + i + n * j}, {first}, {first + 1}, {first + n + 2}, {first + n + 1}")
    return "\n".join(lines + ["*NSET, NSET=bottom", ", ".join(str(1 + i) for i in place), "*NSET, NSET=top", ", ".join(str(1 + i + (n + 1) * n) for i in place), ""])


def more_files():
    """What is damaged beside the shipped files, by name."""
    tree = {}
    for kind, name, entries in scene_text.read(os.path.join(PARAMETERS, "half_plane_box_friction.prm")):
        tree.update({f"{kind} {name}".strip(): entries} if kind else entries)
    square = {"Body square": {"Mesh": "fuzz.inp", "Young modulus": 100, "Poisson ratio": 0.3},
              "Boundary condition a": {"Boundaries": "square/bottom", "Value": [0, 0]}, "Boundary condition b": {"Boundaries": "square/top", "Value": [0, "-0.01*t"]}}
    return {"fuzz.json": json.dumps(tree, indent=1), "fuzz.inp": abaqus_mesh(3), "fuzz_inp.json": json.dumps(square)}


def lines_changed(dice, text):
    lines = text.split(b"\n")
    one, other = dice.randrange(len(lines)), dice.randrange(len(lines))
    change = dice.choice(("drop", "repeat", "swap"))
    if change == "drop":
        del lines[one]
    elif change == "repeat":
        lines.insert(other, lines[one])
    else:
        lines[one], lines[other] = lines[other], lines[one]
    return b"\n".join(lines)


def damaged(dice, text):
    for _ in range(dice.choice((1, 1, 1, 2, 4, 10))):
        if not text:
            break
        at = dice.randrange(len(text))
        kind = dice.choice(("byte", "gap", "word", "number", "lines", "lines", "end"))
        if kind == "byte":
            text = text[:at] + bytes([dice.randrange(256)]) + text[at + 1:]
        elif kind == "gap":
            text = text[:at] + text[at + dice.randrange(1, 60):]
        elif kind == "word":
            text = text[:at] + dice.choice(WORDS) + text[at:]
        elif kind == "number":
            numbers = list(re.finditer(rb"[-+0-9.eE]+", text))
            if numbers:
                chosen = dice.choice(numbers)
                text = text[:chosen.start()] + dice.choice(WORDS) + text[chosen.end():]
        elif kind == "lines":
            text = lines_changed(dice, text)
        elif dice.random() < 0.2:
            text = text[:at]
    return text


def victims():
    """(what is damaged, what is run, whether that is a study), relative to PARAMETERS."""
    found = [(os.path.join(folder, name), os.path.join(folder, name), folder == "studies") for folder in ("", "verification", "studies")
             for name in sorted(os.listdir(os.path.join(PARAMETERS, folder))) if name.endswith(".prm")]
    found += 12 * [("fuzz.json", "fuzz.json", False), ("fuzz.inp", "fuzz_inp.json", False)]
    for file, scene in READ_BY.items():  # gmsh meshes slowly what is not meant to be meshed
        found += (1 if file.endswith(".geo") else 12) * [(os.path.join(os.path.dirname(scene), file), scene, False)]
    return found


def verdict(code, said):
    if code == "hang":
        return "hang"
    if code == 0:
        return "answer"
    if code == "error":
        return "error"
    if code != 1:
        return f"crash ({code})"
    try:
        said.decode()
    except UnicodeDecodeError:
        return "no UTF-8"
    return "refusal" if 0 < len(said) <= 2048 and said.count(b"\n") <= 20 else "message too long" if said else "no message"


class Mutant:
    """A damaged copy of a file in a folder that is as PARAMETERS otherwise."""

    def __init__(self, folder, seed, number):
        dice = random.Random(f"{seed} {number}")
        self.number, self.folder = number, folder
        self.victim, self.scene, self.is_study = dice.choice(victims())
        self.path = os.path.join(folder, self.victim)
        with open(self.path, "rb") as stream:
            self.sound = stream.read()
        self.text = damaged(dice, self.sound)
        self.limit = GMSH_SECONDS if self.victim.endswith(".geo") else SECONDS

    def __enter__(self):
        with open(self.path, "wb") as stream:
            stream.write(self.text)
        return self

    def __exit__(self, *_):
        with open(self.path, "wb") as stream:
            stream.write(self.sound)

    def keep(self, folder, result, said):
        os.makedirs(folder, exist_ok=True)
        name = os.path.join(folder, f"{self.number}_{os.path.basename(self.victim)}")
        with open(name, "wb") as stream:
            stream.write(self.text)
        with open(name + ".said", "wb") as stream:
            stream.write(f"{result}: {self.scene}\n".encode() + said[:4000])


def copy_of_parameters(top):
    folder = os.path.join(top, "parameters")
    shutil.copytree(PARAMETERS, folder)
    for name, text in more_files().items():
        with open(os.path.join(folder, name), "w", encoding="utf-8") as stream:
            stream.write(text)
    return folder


class Runs:
    """Each mutant by a process of its own."""

    def __init__(self, executable, top, memory):
        self.executable, self.top, self.memory = executable, top, memory or MEMORY

    def verdict(self, mutant):
        out = os.path.join(self.top, "out")
        shutil.rmtree(out, ignore_errors=True)
        command = [self.executable, "study", mutant.scene, "--jobs", "1"] if mutant.is_study else [self.executable, mutant.scene, "--quiet"] + FAST
        try:
            done = launch.run(["bash", "-c", f'ulimit -v {self.memory}; exec "$@"', "fuzz"] + command + ["--output", out], 1, cwd=mutant.folder, timeout=mutant.limit,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        except subprocess.TimeoutExpired:
            # it may be at work, on a study or a scene with other numbers
            return "long" if mutant.victim == mutant.scene else "hang", b""
        return verdict(done.returncode, done.stderr), done.stderr


class Reads:
    """All by one process."""

    def __init__(self, executable, top, memory):
        self.readers = readers.Readers(executable, top, memory or READING_MEMORY)

    def verdict(self, mutant):
        self.readers.noise()
        code, said = self.readers.ask(f"{'study' if mutant.is_study else 'scene'} {os.path.join(mutant.folder, mutant.scene)}", mutant.limit)
        noise = self.readers.noise()
        result = verdict(code, said)
        return (result, said + noise) if not noise or result not in ("answer", "refusal") else ("words beside the answer", noise)

    def stop(self):
        self.readers.stop()


def run_some(arguments, numbers, started):
    """Verdicts of those of `numbers` that time allows: (number, what was damaged, verdict)."""
    found = []
    with tempfile.TemporaryDirectory(prefix="amontons-fuzz-") as top:
        folder = copy_of_parameters(top)
        judge = (Reads if arguments.readers else Runs)(arguments.executable, top, arguments.memory)
        for number in numbers:
            if time.monotonic() - started > arguments.seconds:
                break
            with Mutant(folder, arguments.seed, number) as mutant:
                result, said = judge.verdict(mutant)
            found.append(result)
            if result not in GOOD:
                print(f"{number} ({mutant.victim}): {result}", flush=True)
                if arguments.keep:
                    mutant.keep(arguments.keep, result, said)
        if arguments.readers:
            judge.stop()
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("executable", type=os.path.abspath)
    parser.add_argument("n", type=int)
    parser.add_argument("--seed", default="1")
    parser.add_argument("-j", type=int, default=1)
    parser.add_argument("--keep")
    parser.add_argument("--readers", action="store_true")
    parser.add_argument("--seconds", type=float, default=1e9)
    parser.add_argument("--memory", type=int)
    arguments = parser.parse_args()
    started = time.monotonic()
    counts = collections.Counter()
    with concurrent.futures.ThreadPoolExecutor(arguments.j) as pool:
        for part in [pool.submit(run_some, arguments, range(k, arguments.n, arguments.j), started) for k in range(arguments.j)]:
            counts.update(part.result())
    print(", ".join(f"{count} times {result}" for result, count in counts.most_common()))
    sys.exit(not counts or any(result not in GOOD for result in counts))


if __name__ == "__main__":
    main()
