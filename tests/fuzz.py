#!/usr/bin/env python3
"""Damaged input: fuzz.py AMONTONS N [--seed S] [-j JOBS] [--keep DIR]

Damages shipped scenes, studies, meshes (.geo, .msh) and CAD files at random, N times (the same ones for the same seed), runs each, and counts what came: an answer,
a refusal (exit code 1, one message of at most 2 kB and 20 lines in valid UTF-8), or what must not be: a crash, a hang, more than MEMORY, another message. Those are
kept, with what was said. By hand; a gmsh file may mesh for ever, which the program ends after a minute.
"""
import argparse
import collections
import concurrent.futures
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile

import launch

PARAMETERS = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "parameters")
MEMORY = 8_000_000  # kB, of addresses
SECONDS = 10
GMSH_SECONDS = 62
WORDS = [b"nan", b"inf", b"-1", b"0", b"1e308", b"1e-308", b"9" * 20, b"", b"\x00", b"\xff\xfe", b"(" * 7, b"end\n", b"subsection X\n", b"include /dev/zero\n", b"x" * 3000,
         b"0/0", b"sqrt(-1)", b"%s%n", b";", b",", b"=", b"\\\n", b"set "]
FAST = ["--set", "Refinement/Cycles=0", "--set", "Refinement/Target error=0", "--set", "Output/VTU=false", "--set", "Output/Report=false"]
# what is damaged, and the scene that reads it
READ_BY = {"nafems_punch.geo": "nafems_punch.prm", "ironing.geo": "ironing.prm", "snap_away.geo": "snap_away.prm", "step_file.msh": "step_file.prm",
           "step_file.step": "step_file.prm", "patch_3d_step.msh": "verification/patch_3d_step.prm", "patch_3d_lower.msh": "verification/patch_3d_irregular.prm"}


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
    return found + 12 * [(os.path.join(os.path.dirname(scene), file), scene, False) for file, scene in READ_BY.items()]


def verdict(code, said):
    if code == "hang":
        return "hang"
    if code == 0:
        return "answer"
    if code != 1:
        return f"crash ({code})"
    try:
        said.decode()
    except UnicodeDecodeError:
        return "no UTF-8"
    return "refusal" if 0 < len(said) <= 2048 and said.count(b"\n") <= 20 else "message too long" if said else "no message"


def run(executable, number, seed, keep):
    dice = random.Random(f"{seed} {number}")
    victim, scene, is_study = dice.choice(victims())
    with tempfile.TemporaryDirectory(prefix="amontons-fuzz-") as top:
        copy = os.path.join(top, "parameters")
        shutil.copytree(PARAMETERS, copy)
        with open(os.path.join(PARAMETERS, victim), "rb") as stream:
            text = damaged(dice, stream.read())
        with open(os.path.join(copy, victim), "wb") as stream:
            stream.write(text)
        command = [executable, "study", scene, "--jobs", "1"] if is_study else [executable, scene, "--quiet"] + FAST
        limit = GMSH_SECONDS if victim.endswith(".geo") else SECONDS
        try:
            done = launch.run(["bash", "-c", f'ulimit -v {MEMORY}; exec "$@"', "fuzz"] + command + ["--output", os.path.join(top, "out")], 1, cwd=copy, timeout=limit,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            code, said = done.returncode, done.stderr
        except subprocess.TimeoutExpired:
            code, said = "hang", b""
        result = verdict(code, said)
        if result == "hang" and victim == scene:
            result = "long"  # it may be at work, on a study or a scene with other numbers
        if keep and result not in ("answer", "refusal", "long"):
            os.makedirs(keep, exist_ok=True)
            name = os.path.join(keep, f"{number}_{os.path.basename(victim)}")
            with open(name, "wb") as stream:
                stream.write(text)
            with open(name + ".said", "wb") as stream:
                stream.write(f"{result}: {' '.join(command)}\n".encode() + said[:4000])
        return result, victim


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("executable", type=os.path.abspath)
    parser.add_argument("n", type=int)
    parser.add_argument("--seed", default="1")
    parser.add_argument("-j", type=int, default=2)
    parser.add_argument("--keep")
    arguments = parser.parse_args()
    counts = collections.Counter()
    with concurrent.futures.ThreadPoolExecutor(arguments.j) as pool:
        for number, future in enumerate([pool.submit(run, arguments.executable, k, arguments.seed, arguments.keep) for k in range(arguments.n)]):
            result, victim = future.result()
            counts[result] += 1
            if result not in ("answer", "refusal", "long"):
                print(f"{number} ({victim}): {result}", flush=True)
    print(", ".join(f"{count} times {result}" for result, count in counts.most_common()))
    sys.exit(any(result not in ("answer", "refusal", "long") for result in counts))


if __name__ == "__main__":
    main()
