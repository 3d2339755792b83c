#!/usr/bin/env python3
"""A file includes only from its own folder and from folders above it in the table of LAYOUT.md. verification/ includes what it wants; main.cc alone includes it.

Usage: check_layers.py [SOURCE_DIR]. Prints each violation as FILE:LINE: REASON and exits 1 if there are any.
"""

import pathlib
import re
import sys

ORDER = ["base", "scene", "geometry", "discretization", "elasticity", "contact", "friction", "algebra", "solver",
         "adaptivity", "output"]
STRANGERS = {"elasticity", "contact"}  # they meet in the Newton loop only
BESIDE = "verification"  # a library beside the program
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]amontons/([^">]+)[>"]')


def violation(folder, included):
    """Why a file of `folder` ("": the top level) may not include <amontons/`included`>, or None."""
    if folder == BESIDE:
        return None
    if included.startswith(BESIDE + "/"):
        return f"only main.cc includes {BESIDE}"
    if folder == "":
        return None
    if "/" not in included:
        return "a header of the top level"
    other = included.split("/")[0]
    if other not in ORDER:
        return f"unknown folder '{other}'"
    if folder != other and {folder, other} == STRANGERS:
        return "elasticity and contact never include each other"
    if ORDER.index(other) > ORDER.index(folder):
        return f"'{other}' comes after '{folder}'"
    return None


def violations(root):
    for top in ("include/amontons", "source"):
        for path in sorted((root / top).rglob("*")):
            parts = path.relative_to(root / top).parts
            if path.suffix not in (".h", ".cc") or parts == ("main.cc",):
                continue
            where = path.relative_to(root)
            folder = parts[0] if len(parts) > 1 else ""
            if folder and folder not in ORDER + [BESIDE]:
                yield f"{where}:1: folder '{folder}' is not in the order of LAYOUT.md"
                continue
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                found = INCLUDE.match(line)
                reason = found and violation(folder, found.group(1))
                if reason:
                    yield f"{where}:{number}: includes <amontons/{found.group(1)}>: {reason}"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent.parent)
    if not (root / "source").is_dir():
        sys.exit(f"{root} has no folder 'source'")
    found = list(violations(root))
    for line in found:
        print(line)
    if not found:
        print("all includes follow the order of the layers")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
