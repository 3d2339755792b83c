#!/usr/bin/env python3
"""Do the commands of the pages still print what stands there? check_numbers.py AMONTONS [PAGE...] (of doc/; all if none is named)

In a block "```console", lines that begin with "$ " are commands, run from top to bottom of a page in a folder that has the repository's doc/ and parameters/; what
follows are lines of their output, in their order, "..." stands for any others. "build/amontons" is AMONTONS. Numbers may differ by 1e-3 of their size, or both be
below 1e-9; seconds are not compared.
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
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?$")


def alike(quoted, printed):
    a, b = ([word.strip("();%") for word in re.split(r"[\s,]+", text.strip())] for text in (quoted, printed))
    if len(a) != len(b) or not a:
        return a == b
    if a[0] == b[0] == "time":
        return True
    for x, y in zip(a, b):
        if NUMBER.match(x) and NUMBER.match(y):
            x, y = float(x), float(y)
            if not (math.isclose(x, y, rel_tol=1e-3) or max(abs(x), abs(y)) < 1e-9):
                return False
        elif x != y:
            return False
    return True


def missing(lines, output):
    """The first line that does not stand there after those before; None: all do."""
    printed = iter(output)
    for line in lines:
        if line.strip() and line.strip() != "..." and not any(alike(line, other) for other in printed):
            return line
    return None


def run(command, program, folder):
    words = [program if word == "build/amontons" else word for word in shlex.split(command)]
    ranks = 1
    if words[0] == "mpirun":
        ranks, words = int(words[2]), words[words.index(program):]
    done = launch.run(words, ranks, cwd=folder, capture_output=True, text=True, timeout=300)
    return (done.stdout + done.stderr).splitlines()


def check(page, program, folder):
    """What is wrong on the page; number of commands."""
    wrong, n_commands = [], 0
    for block in BLOCK.finditer(page):
        for part in re.split(r"^\$ ", block.group("lines"), flags=re.M)[1:]:
            command, *lines = part.splitlines()
            n_commands += 1
            line = missing(lines, run(command, program, folder))
            if line is not None:
                wrong.append(f"{page.count(chr(10), 0, block.start()) + 1}: not printed (there) by '{command}':\n  {line}")
    return wrong, n_commands


def main():
    program, pages = str(pathlib.Path(sys.argv[1]).resolve()), sys.argv[2:]
    wrong, n_all = [], 0
    for page in sorted((ROOT / "doc").glob("*.md")):
        if pages and page.name not in pages:
            continue
        with tempfile.TemporaryDirectory() as folder:
            for name in ("doc", "parameters"):
                os.symlink(ROOT / name, pathlib.Path(folder) / name)
            problems, n_commands = check(page.read_text(), program, folder)
        wrong += [f"doc/{page.name}:{text}" for text in problems]
        n_all += n_commands
    print("\n".join(wrong) or f"{n_all} commands print what stands in the pages")
    sys.exit(1 if wrong or not n_all else 0)


if __name__ == "__main__":
    main()
