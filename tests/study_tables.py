#!/usr/bin/env python3
"""Are the tables of studies in doc/ those that the program prints? study_tables.py AMONTONS [--fix] [--only TEXT]

By hand: each line "    build/amontons study FILE" of doc/*.md is run, and the indented table that follows is compared, but for its seconds. --fix writes what was printed.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
BLOCK = re.compile(r"^    build/amontons study (?P<file>\S+)\n(?P<between>(?:(?!    build/amontons)(?!    \S.*\n    ===).*\n)*?)(?P<table>    \S.*\n    ===+\n(?:(?:    .*)?\n)*)", re.M)


def numbers(table):
    """Words of each line without those of the column of seconds."""
    result, place = [], None
    for line in table.split("\n"):
        words = line.split()
        if words[:1] == ["mesh"] or "seconds" in words:
            place = words.index("seconds") if "seconds" in words else None
        elif place is not None and words[:1] and re.fullmatch(r"[\d.e+-]+", words[0]) and len(words) > place:
            words = words[:place] + words[place + 1:]
        result.append(words)
    return [words for words in result if words]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("amontons", type=pathlib.Path)
    parser.add_argument("--fix", action="store_true")
    parser.add_argument("--only", default="")
    arguments = parser.parse_args()
    failed = False
    for page in sorted((ROOT / "doc").glob("*.md")):
        text = page.read_text()
        mended = text
        for match in BLOCK.finditer(text):
            if arguments.only not in match.group("file"):
                continue
            with tempfile.TemporaryDirectory() as folder:
                done = subprocess.run([arguments.amontons.resolve(), "study", ROOT / match.group("file"), "--output", folder], cwd=ROOT, capture_output=True, text=True)
            title = match.group("table").split("\n")[0].strip()
            found = done.stdout.find(title + "\n=")
            where = f"{page.relative_to(ROOT)}: {match.group('file')}"
            if done.returncode != 0 or found < 0:
                failed = True
                print(f"{where}: no table ({done.returncode}) {done.stderr[-200:]}")
                continue
            lines = done.stdout[found:].rstrip("\n").split("\n")
            while lines and (not lines[-1].strip() or lines[-1].startswith("Wrote")):
                lines.pop()
            table = "".join(f"    {line}".rstrip() + "\n" for line in lines) + "\n"
            same = numbers(match.group("table")) == numbers(table)
            failed = failed or not same
            print(f"{where}: {'as printed' if same else 'another table'}", flush=True)
            if arguments.fix:
                mended = mended.replace(match.group("table"), table)
        if mended != text:
            page.write_text(mended)
    sys.exit(1 if failed and not arguments.fix else 0)


if __name__ == "__main__":
    main()
