#!/usr/bin/env python3
"""Shallow ironing (parameters/ironing.prm, case IR2) by CalculiX: ironing.py [--press 20] [--slide 60] [--reach 3] [--stiffness 10] [--write FILE].

The same mesh (96 x 16 cells of the block, 14 x 6 of the die), neo-Hookean, friction 0.3; so many increments of the press by 1 and of the slide by --reach; --stiffness of the
penalty over Young's modulus of the block. Slave is the die's lower side. Prints the mean forces over the middle of the slide, from 0.3 to 0.7 of the reach (IR2: 3 to 7 of 10).
A whole slide takes CalculiX three minutes of the processor.
"""
import argparse
import math
import os
import pathlib
import re
import shutil
import tempfile

from calculix import iterations, rows
from peers import COLUMNS, write
from process import measured

BLOCK, DIE, NU, FRICTION = 68.96, 689.6, 0.32, 0.3


def graded(low, high, cells, ratio):
    """Places of cells whose last is `ratio` times as large as the first."""
    q = ratio ** (1 / (cells - 1))
    sizes = [q**k for k in range(cells)]
    return [low + (high - low) * sum(sizes[:k]) / sum(sizes) for k in range(cells + 1)]


def arc(centre, radius, start, end, cells):
    angles = [start + (end - start) * k / cells for k in range(cells + 1)]
    return [(centre[0] + radius * math.cos(t), centre[1] + radius * math.sin(t)) for t in angles]


def die():
    """Its nodes [i][j], i along the bottom (fillet, arc, fillet) and j upwards: transfinite, as parameters/ironing.geo has it."""
    fillet, radius = 0.15, 0.75
    dx = 0.6 - fillet
    dy = math.sqrt((radius - fillet) ** 2 - dx**2)
    meet = math.atan2(-dy, dx)  # of the right fillet and the arc, seen from either centre
    left = arc((1 - dx, radius - dy), fillet, math.pi, math.pi - meet, 2)
    right = arc((1 + dx, radius - dy), fillet, meet, 0, 2)
    bottom = left + arc((1, radius), radius, math.pi - meet, 2 * math.pi + meet, 10)[1:] + right[1:]
    top = [(0.4 + 1.2 * k / 14, 1.2) for k in range(15)]
    nodes = []
    for i, (low, high) in enumerate(zip(bottom, top)):
        s = i / 14
        column = []
        for t in (j / 6 for j in range(7)):
            sides = [(1 - t) * a + t * b for a, b in zip(bottom[0], top[0])], [(1 - t) * a + t * b for a, b in zip(bottom[14], top[14])]
            corners = [(1 - s) * a + s * b for a, b in zip(*sides)]
            column.append(tuple((1 - t) * low[d] + t * high[d] + (1 - s) * sides[0][d] + s * sides[1][d] - corners[d] for d in (0, 1)))
        nodes.append(column)
    return nodes


def cells_of(shape, first):
    """Corners of the cells of a grid of nodes numbered upwards first, and the number of its node (i, j)."""
    def number(i, j):
        return first + i * shape[1] + j

    return [[number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)] for i in range(shape[0] - 1) for j in range(shape[1] - 1)], number


def deck(press, slide, reach, stiffness):
    across, up = graded(0, 12, 96, 1), graded(-4, 0, 16, 0.4)
    block, at = cells_of((97, 17), 1)
    tool, on = cells_of((15, 7), 1 + 97 * 17)
    points = [(x, y) for x in across for y in up] + [point for column in die() for point in column]
    text = ["*NODE, NSET=ALL"] + [f"{k + 1},{x:.12g},{y:.12g}" for k, (x, y) in enumerate(points)]
    for name, cells, first in ("BLOCK", block, 1), ("DIE", tool, 1 + len(block)):
        text += [f"*ELEMENT, TYPE=CPE4, ELSET={name}"] + [f"{first + k},{rows(cell)}" for k, cell in enumerate(cells)]
    for name, young in ("BLOCK", BLOCK), ("DIE", DIE):
        shear, bulk = young / (2 * (1 + NU)), young / (3 * (1 - 2 * NU))
        text += [f"*MATERIAL, NAME={name}", "*HYPERELASTIC, NEO HOOKE", f"{shear / 2:.12g},{2 / bulk:.12g}", f"*SOLID SECTION, ELSET={name}, MATERIAL={name}", "1."]
    text += ["*NSET, NSET=BASE", rows(at(i, 0) for i in range(97)), "*NSET, NSET=TOP", rows(on(i, 6) for i in range(15))]
    d = 1 + len(block)
    lower = [f"{d + 6 * i},S1" for i in range(14)] + [f"{d + j},S4" for j in range(6)] + [f"{d + 6 * 13 + j},S2" for j in range(6)]
    text += ["*SURFACE, NAME=ROUND"] + lower + ["*SURFACE, NAME=FLAT"] + [f"{16 * i + 16},S3" for i in range(96)]
    text += ["*SURFACE INTERACTION, NAME=TOUCH", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", f"{stiffness * BLOCK}", "*FRICTION", f"{FRICTION},{stiffness * BLOCK / 10}"]
    text += ["*CONTACT PAIR, INTERACTION=TOUCH, TYPE=SURFACE TO SURFACE", "ROUND,FLAT", "*BOUNDARY", "BASE,1,2"]
    for many, x, y in (press, 0.0, -1.0), (slide, reach, -1.0):
        text += ["*STEP, NLGEOM, INC=2000", "*STATIC", f"{1 / many},1.,1e-5,{1 / many}", "*BOUNDARY", f"TOP,1,1,{x}", f"TOP,2,2,{y}", "*NODE PRINT, NSET=TOP, TOTALS=ONLY", "RF", "*END STEP"]
    return "\n".join(text) + "\n"


def forces(path, low, high):
    """Mean vertical and horizontal force of the increments between two times of the slide (times 1 to 2)."""
    with open(path, encoding="utf-8") as file:
        found = re.findall(r"and time\s+(\S+)\s+(\S+)\s+(\S+)\s+\S+", file.read())
    found = [(float(t), abs(float(y)), abs(float(x))) for t, x, y in found]
    middle = [row for row in found if low < row[0] - 1 < high]
    return [sum(row[k] for row in middle) / len(middle) if middle else math.nan for k in (1, 2)], found[-1][0] if found else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name, kind, default in ("press", int, 20), ("slide", int, 60), ("reach", float, 3.0), ("stiffness", float, 10.0), ("limit", float, 120.0):
        parser.add_argument(f"--{name}", type=kind, default=default)
    parser.add_argument("--low", type=float, default=0.3, help="of the slide, where the mean begins")
    parser.add_argument("--high", type=float, default=0.7)
    parser.add_argument("--write", type=pathlib.Path)
    given = parser.parse_args()
    if not shutil.which("ccx"):
        print("ccx is left out: it is not installed")
        return
    with tempfile.TemporaryDirectory(prefix="peers-") as folder:
        pathlib.Path(folder, "scene.inp").write_text(deck(given.press, given.slide, given.reach, given.stiffness), encoding="utf-8")
        code, row = measured(["ccx", "scene"], folder, given.limit)
        (vertical, horizontal), last = forces(os.path.join(folder, "scene.dat"), given.low, given.high)
        counted = iterations(os.path.join(folder, "scene.cvg"))
    note = f"slide {given.reach:g}; V {vertical:.2f} H {horizontal:.2f} over {given.low * given.reach:.3g}..{given.high * given.reach:.3g}"
    note = note if not code and last > 1.999 else f"not finished: t = {last:.3f} after {row['wall']:.0f} s"
    result = {**dict.fromkeys(COLUMNS, ""), "program": "ccx2.20", "formulation": f"f2f K={given.stiffness:g}E", "case": "IR2", "N": f"{given.press}+{given.slide}", "threads": "1",
              "wall": f"{row['wall']:.1f}", "cpu": f"{row['cpu']:.1f}", "memory_MB": f"{row['memory_MB']:.0f}", "iterations": counted.split("/")[0], "note": note}
    print(",".join(result[name] for name in COLUMNS))
    if given.write:
        write(given.write, [result])


if __name__ == "__main__":
    main()
