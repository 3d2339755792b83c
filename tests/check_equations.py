#!/usr/bin/env python3
"""Do the source and the introduction know each other? check_equations.py [SOURCE_DIR]

- The equations of doc/introduction.md are numbered from 1 on, in their order.
- Every number that include/, source/ or another page cites ("introduction.md, (7)") is one of them, and each of them is cited in include/ or source/: an equation
  has a number because the program implements it.
- What its tables of notation and of the algorithm set in code is a file of include/amontons/ or a word that stands there.
"""
import pathlib
import re
import sys

CITATION = re.compile(r"introduction(?:\.md)?\)?, ((?:\(\d+\)(?:, | and )?)+)")


def cited(text):
    """Numbers; a citation may go on in the next line of a comment."""
    text = re.sub(r"\n[ \t]*//[/!]?[ \t]*", " ", text)
    return [int(n) for group in CITATION.findall(text) for n in re.findall(r"\((\d+)\)", group)]


def check_names(page, root, wrong):
    headers = "\n".join(path.read_text() for path in sorted((root / "include").rglob("*.h")))
    tables = re.findall(r"^## (?:Notation|The algorithm)\n(.*?)(?=^## )", page, flags=re.M | re.S)
    if len(tables) != 2:
        wrong.append("no sections 'Notation' and 'The algorithm'")
    for line in "".join(tables).splitlines():
        for name in re.findall(r"`([^`]*)`", line) if line.startswith("| ") else []:
            if name.endswith(".h"):
                if not (root / "include" / "amontons" / name).exists():
                    wrong.append(f"no file {name}")
            elif any(not re.search(rf"\b{word}\b", headers) for word in name.replace("()", "").split("::")):
                wrong.append(f"no '{name}' in include/")


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent.parent)
    page = (root / "doc" / "introduction.md").read_text()
    tags = [int(n) for n in re.findall(r"\\tag\{(\d+)\}", page)]
    wrong = [] if tags == list(range(1, len(tags) + 1)) else [f"equations are numbered {tags}"]
    source, n_citations = set(), 0
    files = [p for folder in ("include", "source", "doc") for p in sorted((root / folder).rglob("*")) if p.suffix in (".h", ".cc", ".md", ".py")]
    for path in files:
        numbers = cited(path.read_text())
        n_citations += len(numbers)
        wrong += [f"{path.relative_to(root)}: no equation ({n})" for n in numbers if n not in tags]
        if path.suffix in (".h", ".cc") and "doc" not in path.relative_to(root).parts:
            source.update(numbers)
    wrong += [f"introduction.md: ({n}) is cited nowhere in the source" for n in tags if n not in source]
    check_names(page, root, wrong)
    print("\n".join(wrong) or f"{len(tags)} equations, {n_citations} citations")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
