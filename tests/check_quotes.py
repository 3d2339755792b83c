#!/usr/bin/env python3
"""Does doc/program.md quote what stands in the source? check_quotes.py [SOURCE_DIR] [--fix]

Each block of C++ follows a line "<!-- source/file.cc: name -->" and is the text between two lines "//! [name]" of that file, less the indentation; several such
pairs of one name are joined by "...". --fix writes what stands in the source.
"""
import pathlib
import re
import sys
import textwrap

BLOCK = re.compile(r"(?P<head><!-- (?P<file>[\w./]+): (?P<name>[\w ]+) -->\n)?```cpp\n(?P<code>.*?)```", re.S)


def quoted(root, name, file):
    """The text, or None if it is not marked."""
    path = root / file
    if not path.exists():
        return None
    parts = re.split(r"^[ \t]*//! \[" + re.escape(name) + r"\][ \t]*\n", path.read_text(), flags=re.M)[1::2]
    return "...\n".join(textwrap.dedent(part) for part in parts) or None


def main():
    arguments = [a for a in sys.argv[1:] if a != "--fix"]
    root = pathlib.Path(arguments[0] if arguments else pathlib.Path(__file__).resolve().parent.parent)
    fix, wrong = "--fix" in sys.argv, []
    for page in sorted((root / "doc").glob("*.md")):
        text = page.read_text()

        def check(match):
            where = f"{page.relative_to(root)}:{text.count(chr(10), 0, match.start()) + 1}"
            if not match.group("head"):
                wrong.append(f"{where}: a block of C++ without '<!-- file: name -->' before it")
                return match.group(0)
            now = quoted(root, match.group("name"), match.group("file"))
            if now is None:
                wrong.append(f"{where}: '//! [{match.group('name')}]' does not stand twice in {match.group('file')}")
                return match.group(0)
            if now != match.group("code"):
                wrong.append(f"{where}: not what stands in {match.group('file')}; python3 tests/check_quotes.py --fix mends it")
            return f"{match.group('head')}```cpp\n{now}```"

        mended = BLOCK.sub(check, text)
        if fix and mended != text:
            page.write_text(mended)
    print("\n".join(wrong) or "all quotes stand in the source")
    sys.exit(1 if wrong and not fix else 0)


if __name__ == "__main__":
    main()
