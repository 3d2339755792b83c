#!/usr/bin/env python3
"""Is CITATION.cff complete, and is the version one everywhere? check_citation.py VERSION (CMake's) [SOURCE_DIR]

What the format (1.2.0) demands must be there; the first entry of CHANGELOG.md is of the same version, too.
"""
import pathlib
import re
import sys

DEMANDED = {"cff-version": "1.2.0", "message": None, "title": None, "authors": None, "license": "LGPL-2.1-or-later"}


def main():
    version = sys.argv[1]
    root = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else pathlib.Path(__file__).resolve().parent.parent)
    text = (root / "CITATION.cff").read_text()
    entries = dict(re.findall(r"^([\w-]+):[ \t]*(.*)$", text, re.M))
    wrong = [f"CITATION.cff: '{name}' is missing or not '{value}'" for name, value in {**DEMANDED, "version": version}.items()
             if name not in entries or value not in (None, entries[name].strip('"'))]
    wrong += [f"CITATION.cff:{number}: a tab" for number, line in enumerate(text.splitlines(), 1) if "\t" in line]
    if not re.search(r"^authors:\n  - (name|family-names): \S", text, re.M):
        wrong.append("CITATION.cff: no author")
    latest = re.search(r"^## (\S+)", (root / "CHANGELOG.md").read_text(), re.M)
    if not latest or latest.group(1) != version:
        wrong.append(f"CHANGELOG.md: its first entry is not of {version}")
    print("\n".join(wrong) or f"CITATION.cff and CHANGELOG.md are of {version}, as CMake is")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
