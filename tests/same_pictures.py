#!/usr/bin/env python3
"""The bodies in report.html look the same on any number of ranks: same_pictures.py AMONTONS.

Each scene runs on 1 and on 2 ranks. Titles, captions and sizes of the pictures are the same; pixels differ in next to none, where a solution that differs in
rounding moves a corner across one. A cut, an enlarged part and a strip are among them.
"""
import pathlib
import re
import sys
import tempfile

import launch
import read_back

PARAMETERS = pathlib.Path(__file__).resolve().parent.parent / "parameters"
# Scene, entries, and the titles that its report must have, in this order.
WHOLE, AROUND, CUT, STRIP = "Bodies, von Mises stress", "Around the contact, von Mises stress", "Cut through the contact, von Mises stress", "From the first contact to the end, von Mises stress"
SCENES = [
    ("hertz_sphere", ["Refinement/Cycles=2"], [WHOLE, AROUND]),
    ("verification/patch_friction_3d", ["Units=mm, N"], [WHOLE + " [MPa]", STRIP + " [MPa]"]),
    ("verification/oblique_drag", ["Refinement/Cycles=0"], [WHOLE, CUT, STRIP]),
]


def report(program, scene, entries, ranks):
    with tempfile.TemporaryDirectory(prefix="amontons-pictures-") as folder:
        command = [program, str(PARAMETERS / f"{scene}.prm"), "--quiet", "--output", folder, "--set", "Output/VTU=false"]
        launch.run(command + [word for entry in entries for word in ("--set", entry)], ranks, check=True)
        return (pathlib.Path(folder) / "report.html").read_text(encoding="utf-8")


def differing(one, other):
    """Part of the pixels that differ by more than a 32nd of full light, or None: sizes differ."""
    (w, h, rows), (v, g, others) = one, other
    if (w, h) != (v, g):
        return None
    n = sum(any(abs(a - b) > 8 for a, b in zip(row[3 * x : 3 * x + 3], also[3 * x : 3 * x + 3])) for row, also in zip(rows, others) for x in range(w))
    return n / (w * h)


def main():
    program, good = str(pathlib.Path(sys.argv[1]).resolve()), True
    for scene, entries, titles in SCENES:
        one, two = (read_back.body_pictures(report(program, scene, entries, ranks)) for ranks in (1, 2))
        if list(one) != titles or list(two) != titles:
            print(f"{scene}: pictures {list(one)}, {list(two)}, expected {titles}")
            good = False
            continue
        for title, (svg, images) in one.items():
            words = [re.findall(r">([^<>\n]+)</text>", text) for text in (svg, two[title][0])]
            parts = [differing(a, b) for a, b in zip(images, two[title][1])]
            same = words[0] == words[1] and len(images) == len(two[title][1]) and all(part is not None and part < 2e-3 for part in parts)
            print(f"{scene}: {title}: {'' if same else 'DIFFERS: '}{parts}, {words[0] if same else words}")
            good = good and same
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
