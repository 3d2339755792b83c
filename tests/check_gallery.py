#!/usr/bin/env python3
"""Is every scene in doc/gallery.md, once, with a picture that exists, and nothing else? check_gallery.py [SOURCE_DIR]

Scenes are parameters/*.prm and those of its folders, but for studies. Titles have to be those of the files, pictures of doc/pictures/gallery small (PICTURE bytes; ALL together), and each
on the page. Prints what is wrong, and exits 1 then; `python3 doc/gallery.py build/amontons` makes the page anew.
"""
import collections
import pathlib
import re
import sys

PICTURE, ALL = 50_000, 3_000_000
ROW = re.compile(r"^\| !\[[^\]]*\]\(pictures/gallery/(?P<picture>[\w.]+)\) \| \[`(?P<name>[\w/]+)`\]\(\.\./parameters/(?P<file>[\w/]+)\.prm\) \*\*(?P<title>.*?)\.\*\* (?P<text>\S.*?) \| [\d,]+ \| [\d.]+ \|$", re.M)


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent.parent)
    page = (root / "doc/gallery.md").read_text(encoding="utf-8")
    rows = [match.groupdict() for match in ROW.finditer(page)]
    wrong = []
    if len(rows) != len(re.findall(r"^\| !", page, re.M)):
        wrong.append("rows that are not | picture | scene, title, text | DoFs | seconds |")

    scenes = {str(path.relative_to(root / "parameters"))[:-4]: path for path in (root / "parameters").rglob("*.prm") if path.parent.name != "studies"}
    counts = collections.Counter(row["file"] for row in rows)
    wrong += [f"parameters/{name}.prm is not in doc/gallery.md: put it into a group of doc/gallery.py" for name in sorted(set(scenes) - set(counts))]
    wrong += [f"there is no parameters/{name}.prm" for name in sorted(set(counts) - set(scenes))]
    wrong += [f"{name} is there {n} times" for name, n in counts.items() if n > 1]
    for row in rows:
        if row["name"] != row["file"]:
            wrong.append(f"{row['name']} leads to {row['file']}.prm")
        elif row["name"] in scenes and not re.search(r"^\s*set Title\s*=\s*" + re.escape(row["title"]) + r"\s*(#.*)?$", scenes[row["name"]].read_text(encoding="utf-8"), re.M):
            wrong.append(f"{row['name']}.prm has another title than '{row['title']}'")

    sizes = {path.name: path.stat().st_size for path in (root / "doc/pictures/gallery").iterdir()}
    shown = [row["picture"] for row in rows]
    wrong += [f"there is no picture {name}" for name in sorted(set(shown) - set(sizes))]
    wrong += [f"{name} is not in doc/gallery.md" for name in sorted(set(sizes) - set(shown))]
    wrong += [f"{name} has {size} bytes" for name, size in sizes.items() if size > PICTURE or size < 500]
    if sum(sizes.values()) > ALL:
        wrong.append(f"all pictures have {sum(sizes.values())} bytes")
    print("\n".join(wrong) or f"{len(rows)} scenes are in the gallery")
    sys.exit(1 if wrong or not rows else 0)


if __name__ == "__main__":
    main()
