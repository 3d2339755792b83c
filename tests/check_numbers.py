#!/usr/bin/env python3
"""Do the commands of the pages still print what stands there? check_numbers.py AMONTONS [PAGE...] [--fix] (of doc/; all if none is named)

In a block "```console", lines that begin with "$ " are commands, run from top to bottom of a page in a folder that has the repository's doc/ and parameters/; what
follows are lines of their output, in their order, "..." stands for any others. "build/amontons" is AMONTONS. Numbers may differ by 1e-3 of their size, or both be
below 1e-9; seconds are not compared, nor by more than two the steps of the Krylov solver (last in the lines of the iteration), which rounding decides: BLAS has other
kernels for other processors. --fix puts what is printed now in the place of lines that differ in numbers alone; text around them has to be read again.
"""
import math
import os
import pathlib
import re
import shlex
import sys
import tempfile

import launch

ROOT = pathlib.Path(__file__).resolve().parent.parent
BLOCK = re.compile(r"^```console\n(?P<lines>.*?)^```", re.S | re.M)
ITERATION = re.compile(r" +\d+ +\d\.\d\de[-+]\d\d(?: +\d+){5}$")
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?$")


def alike(quoted, printed):
    a, b = ([word.strip("();%") for word in re.split(r"[\s,]+", text.strip())] for text in (quoted, printed))
    if len(a) != len(b) or not a:
        return a == b
    if a[0] == b[0] == "time":
        return True
    if ITERATION.match(quoted) and ITERATION.match(printed) and abs(int(a.pop()) - int(b.pop())) > 2:
        return False
    for x, y in zip(a, b):
        if NUMBER.match(x) and NUMBER.match(y):
            x, y = float(x), float(y)
            if not (math.isclose(x, y, rel_tol=1e-3) or max(abs(x), abs(y)) < 1e-9):
                return False
        elif x != y:
            return False
    return True


def words_of(line):
    return re.sub(r"[-+]?\d[\d.]*(?:e[-+]?\d+)?", "#", line).split()


def compare(lines, output):
    """The first line that does not stand there after those before (None: all do); the lines as they would have to be."""
    first, mended, place = None, [], 0
    for line in lines:
        if line.strip() and line.strip() != "...":
            found = next((n for n in range(place, len(output)) if alike(line, output[n])), None)
            if found is None:
                first = first or line
                near = [n for n in range(place, len(output)) if words_of(line) == words_of(output[n])]
                found = max(near, key=lambda n: sum(a == b for a, b in zip(line.split(), output[n].split())), default=None)
                line = line if found is None else output[found]
            place = place if found is None else found + 1
        mended.append(line)
    return first, mended


def run(command, program, folder):
    words = [program if word == "build/amontons" else word for word in shlex.split(command)]
    ranks = 1
    if words[0] == "mpirun":
        ranks, words = int(words[2]), words[words.index(program):]
    done = launch.run(words, ranks, cwd=folder, capture_output=True, text=True, timeout=300)
    return (done.stdout + done.stderr).splitlines()


def check(page, program, folder):
    """The page as it would have to be; what is wrong; number of commands."""
    wrong, mended, n_commands = [], page, 0
    for block in BLOCK.finditer(page):
        begin, *parts = re.split(r"^\$ ", block.group("lines"), flags=re.M)
        text = begin
        for part in parts:
            command, *lines = part.splitlines()
            n_commands += 1
            line, lines = compare(lines, run(command, program, folder))
            text += "\n".join(["$ " + command] + lines) + "\n"
            if line is not None:
                wrong.append(f"{page.count(chr(10), 0, block.start()) + 1}: not printed (there) by '{command}':\n  {line}")
        mended = mended.replace(block.group("lines"), text)
    return mended, wrong, n_commands


def main():
    arguments = [a for a in sys.argv[1:] if a != "--fix"]
    program, pages = str(pathlib.Path(arguments[0]).resolve()), arguments[1:]
    wrong, n_all = [], 0
    for page in sorted((ROOT / "doc").glob("*.md")):
        if pages and page.name not in pages:
            continue
        with tempfile.TemporaryDirectory() as folder:
            for name in ("doc", "parameters"):
                os.symlink(ROOT / name, pathlib.Path(folder) / name)
            mended, problems, n_commands = check(page.read_text(), program, folder)
        if "--fix" in sys.argv and problems:
            page.write_text(mended)
        wrong += [f"doc/{page.name}:{text}" for text in problems]
        n_all += n_commands
    print("\n".join(wrong) or f"{n_all} commands print what stands in the pages")
    sys.exit(1 if wrong or not n_all else 0)


if __name__ == "__main__":
    main()
