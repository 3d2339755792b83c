#!/usr/bin/env python3
"""Does every link of the pages lead somewhere? check_links.py [SOURCE_DIR]

Of README.md, CONTRIBUTING.md, CHANGELOG.md and doc/*.md: files and folders that links and pictures name, and the headings that anchors name, as GitHub
makes anchors of headings. Addresses of the web are not tried. Prints each dead link as FILE:LINE: REASON and exits 1 if there are any.
"""
import os
import pathlib
import re
import sys

LINK = re.compile(r"(?<!\\)!?\[(?:[^\[\]]|\[[^\[\]]*\](?:\([^()]*\))?)*\]\(\s*<?([^()\s>]+(?:\([^()\s]*\))?)>?(?:\s+\"[^\"]*\")?\s*\)")
REFERENCE = re.compile(r"^ {0,3}\[[^\]]+\]:\s*<?(\S+?)>?\s*$", re.M)
HTML = re.compile(r"<(?:a|img)\s[^>]*?(?:href|src)=[\"']([^\"']+)[\"']")


def blank(match):
    return re.sub(r"[^\n]", " ", match.group(0))


def prose(text):
    """Without code and formulas; every character stays at its place."""
    text = re.sub(r"^(```|~~~).*?^\1", blank, text, flags=re.S | re.M)
    text = re.sub(r"^(?: {4,}|\t)(?![-*+\d]).*$", blank, text, flags=re.M)
    text = re.sub(r"(?<!`)(`+)(?!`)(?:(?!\n\n).)+?(?<!`)\1(?!`)", blank, text, flags=re.S)
    return re.sub(r"\$\$.+?\$\$|\$[^$\n]+\$", blank, text, flags=re.S)


def anchor(heading):
    """GitHub's: of what is shown, small letters, digits, '-' and '_'; blanks become '-'."""
    shown = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading.strip().rstrip("#").strip())
    return re.sub(r"[^\w\- ]", "", shown.lower()).replace(" ", "-")


def anchors(text):
    found = set(re.findall(r"<a\s+(?:id|name)=[\"']([^\"']+)[\"']", text))
    counts = {}
    outside = re.sub(r"^(```|~~~).*?^\1", blank, text, flags=re.S | re.M)
    for heading in re.findall(r"^#{1,6}\s+(.+)$", outside, re.M):
        name = anchor(heading)
        found.add(f"{name}-{counts[name]}" if counts.get(name) else name)
        counts[name] = counts.get(name, 0) + 1
    return found


def pages(root):
    top = [root / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md")]
    return top + sorted((root / "doc").glob("*.md"))


def dead(root, page, link):
    """Why, or None."""
    if re.match(r"[a-z][a-z0-9+.-]*:", link):
        return None
    name, _, wanted = link.partition("#")
    target = page if not name else (root / name[1:] if name[0] == "/" else page.parent / name)
    if not target.exists():
        return f"there is no {name}"
    # As written: where the pages are installed, parameters/ is a link to what stands beside them.
    if not pathlib.Path(os.path.abspath(target)).is_relative_to(os.path.abspath(root)):
        return f"{name} is outside"
    if wanted and target.suffix == ".md" and wanted not in anchors(target.read_text(encoding="utf-8")):
        return f"{name or page.name} has no heading #{wanted}"
    return None


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent.parent)
    n_links, wrong = 0, []
    for page in pages(root):
        text = prose(page.read_text(encoding="utf-8"))
        for pattern in (LINK, REFERENCE, HTML):
            for match in pattern.finditer(text):
                n_links += 1
                reason = dead(root, page, match.group(1))
                if reason:
                    wrong.append(f"{page.relative_to(root)}:{text.count(chr(10), 0, match.start()) + 1}: {reason}")
    print("\n".join(wrong) or f"{n_links} links lead somewhere")
    if not n_links:
        print("no link was found")
    return 1 if wrong or not n_links else 0


if __name__ == "__main__":
    sys.exit(main())
