#!/usr/bin/env python3
"""All .h and .cc files are as .clang-format has them. Usage: check_format.py [SOURCE_DIR] [--fix].

Prints a line FILE:LINE for each first difference and exits 1 if there are any; exits 77 where clang-format is not installed.
"""
import pathlib
import re
import shutil
import subprocess
import sys


def files(root):
    return sorted(str(path) for folder in ("include", "source", "tests", "doc") for path in (root / folder).rglob("*") if path.suffix in (".h", ".cc"))


def main():
    arguments = [a for a in sys.argv[1:] if a != "--fix"]
    root = pathlib.Path(arguments[0] if arguments else pathlib.Path(__file__).resolve().parent.parent)
    if not shutil.which("clang-format"):
        print("clang-format is not installed: nothing was checked")
        return 77
    if "--fix" in sys.argv:
        return subprocess.run(["clang-format", "-i", *files(root)]).returncode
    messages = subprocess.run(["clang-format", "--dry-run", *files(root)], capture_output=True, text=True, cwd=root).stderr
    found = {}
    for name, line in re.findall(r"^(.*?):(\d+):\d+: warning: code should be clang-formatted", messages, re.M):
        found.setdefault(name, line)
    for name, line in found.items():
        print(f"{name}:{line}: not as .clang-format has it; python3 tests/check_format.py --fix mends it")
    if not found:
        print("all files are formatted")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
