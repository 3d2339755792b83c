#!/usr/bin/env python3
"""Takes pictures out of report.html. report_pictures.py REPORT.html lists their titles, report_pictures.py REPORT.html TITLE PICTURE.svg writes one,
report_pictures.py AMONTONS runs the scenes of PAGES below, half a minute, and writes doc/pictures/NAME.svg anew.

A picture is what the program wrote, but for three things: a title of the pair that begins as TITLE does is found, too; cells have only the points of their outline that are
seen; it may be shown smaller. doc/gallery.py uses the same functions.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SVG = re.compile(r"<svg\b.*?</svg>", re.S)
TITLE = re.compile(r'font-weight="600">([^<]*)</text>')
PLAIN_PATH = re.compile(r' d="((?:M[-\d.]+ [-\d.]+(?:L[-\d.]+ [-\d.]+)+Z)+)"')
SEEN = 0.15  # of a pixel: what is nearer to the line between its neighbours is left out

# Of the pages: run (scene and entries), then names of pictures with their titles.
PAGES = [
    ("walk/pin_in_lug", [], {
        "walk_pressure": "Contact pressure", "walk_shear": "Shear traction", "walk_around": "Around the contact", "walk_errors": "Relative errors"}),
    ("walk/pin_in_lug", ["Refinement/Cycles=0"], {"walk_coarse_mesh": "Deformed mesh"}),
    ("walk/pin_in_lug_3d", [], {"walk_3d_bodies": "Bodies", "walk_3d_pressure": "Pressure on the surface", "walk_3d_states": "States"}),
    ("small_scene", [], {"small_scene_mesh": "Deformed mesh", "small_scene_pressure": "Contact pressure", "small_scene_shear": "Shear traction"}),
    ("hertz_cylinder", [], {"hertz_cylinder_mesh": "Deformed mesh", "hertz_cylinder_pressure": "Contact pressure"}),
    ("half_plane_box_friction", ["End time=4", "Increments=40"], {
        "half_plane_box_friction_shear": "Shear traction", "half_plane_box_friction_sizes": "Size of contact and stick", "half_plane_box_friction_work": "Work of friction"}),
]


def pictures(report):
    """By title, in their order."""
    found = {}
    for svg in SVG.findall(pathlib.Path(report).read_text(encoding="utf-8")):
        title = TITLE.search(svg)
        found.setdefault(title.group(1) if title else f"picture {len(found) + 1}", svg)
    return found


def picture(report, title):
    """The first one whose title begins so, or None."""
    return next((svg for name, svg in pictures(report).items() if name.startswith(title)), None)


def short(value):
    return f"{value:.1f}".rstrip("0").rstrip(".").replace("-0.", "-.").removeprefix("0") or "0"


def outline(points):
    """Without the points that lie on the line between the ones before and after, which are kept."""
    kept = [points[0]]
    for at in range(1, len(points)):
        (ax, ay), (bx, by), (cx, cy) = kept[-1], points[at], points[(at + 1) % len(points)]
        length = ((cx - ax) ** 2 + (cy - ay) ** 2) ** 0.5
        off = abs((cx - ax) * (by - ay) - (cy - ay) * (bx - ax)) / length if length else 1
        between = (bx - ax) * (cx - bx) + (by - ay) * (cy - by) >= 0
        if off > SEEN or not between:
            kept.append((bx, by))
    return kept


def shortened(path):
    """An SVG path of straight lines, relative from point to point."""
    text = ""
    for part in path.split("Z")[:-1]:
        points = outline([tuple(float(x) for x in pair.split()) for pair in part[1:].split("L")])
        text += "M" + " ".join(map(short, points[0]))
        for (ax, ay), (bx, by) in zip(points, points[1:]):
            text += "l" + short(round(bx - ax, 1)) + " " + short(round(by - ay, 1))
        text += "z"
    return text.replace(" -", "-")


def slim(svg, size=None):
    """Smaller to store; shown in a square of this size, if one is given."""
    svg = PLAIN_PATH.sub(lambda match: f' d="{shortened(match.group(1))}"', svg)
    if size:
        w, h = (float(x) for x in re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', svg).groups())
        svg = re.sub(r'width="[\d.]+" height="[\d.]+"', f'width="{size * min(1, w / h):.0f}" height="{size * min(1, h / w):.0f}"', svg, count=1)
    return svg + "\n"


def of_pages(program):
    for scene, entries, wanted in PAGES:
        with tempfile.TemporaryDirectory(prefix="amontons-pictures-") as folder:
            command = [program, str(ROOT / "parameters" / f"{scene}.prm"), "--quiet", "--output", folder, "--set", "Output/VTU=false"]
            subprocess.run(command + [word for entry in entries for word in ("--set", entry)], check=True, stdout=subprocess.DEVNULL)
            for name, title in wanted.items():
                (ROOT / "doc/pictures" / f"{name}.svg").write_text(slim(picture(f"{folder}/report.html", title)), encoding="utf-8")
                print(f"doc/pictures/{name}.svg")


def main():
    if len(sys.argv) == 4:
        svg = picture(sys.argv[1], sys.argv[2])
        if svg is None:
            sys.exit(f"no picture of {sys.argv[1]} has a title that begins with '{sys.argv[2]}'")
        pathlib.Path(sys.argv[3]).write_text(slim(svg), encoding="utf-8")
    elif len(sys.argv) == 2 and sys.argv[1].endswith(".html"):
        print("\n".join(pictures(sys.argv[1])))
    elif len(sys.argv) == 2:
        of_pages(str(pathlib.Path(sys.argv[1]).resolve()))
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
