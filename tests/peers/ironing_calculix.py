"""Shallow ironing as input of CalculiX, and its forces. Slave is the die's lower side."""
import os
import re

from calculix import iterations, rows
from ironing_mesh import BLOCK, DIE, FRICTION, NU, PRESS, die, graded


def cells_of(shape, first):
    """Corners of the cells of a grid of nodes numbered upwards first, and the number of its node (i, j)."""
    def number(i, j):
        return first + i * shape[1] + j

    return [[number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)] for i in range(shape[0] - 1) for j in range(shape[1] - 1)], number


def deck(cells, press, slide, reach, stiffness):
    across, up = graded(0, 12, cells[0], 1), graded(-4, 0, cells[1], 0.4)
    block, at = cells_of((len(across), len(up)), 1)
    tool, on = cells_of((15, 7), 1 + len(across) * len(up))
    points = [(x, y) for x in across for y in up] + [point for column in die() for point in column]
    text = ["*NODE, NSET=ALL"] + [f"{k + 1},{x:.12g},{y:.12g}" for k, (x, y) in enumerate(points)]
    for name, grid, first in ("BLOCK", block, 1), ("DIE", tool, 1 + len(block)):
        text += [f"*ELEMENT, TYPE=CPE4, ELSET={name}"] + [f"{first + k},{rows(cell)}" for k, cell in enumerate(grid)]
    for name, young in ("BLOCK", BLOCK), ("DIE", DIE):
        shear, bulk = young / (2 * (1 + NU)), young / (3 * (1 - 2 * NU))
        text += [f"*MATERIAL, NAME={name}", "*HYPERELASTIC, NEO HOOKE", f"{shear / 2:.12g},{2 / bulk:.12g}", f"*SOLID SECTION, ELSET={name}, MATERIAL={name}", "1."]
    text += ["*NSET, NSET=BASE", rows(at(i, 0) for i in range(len(across))), "*NSET, NSET=TOP", rows(on(i, 6) for i in range(15))]
    d = 1 + len(block)
    lower = [f"{d + 6 * i},S1" for i in range(14)] + [f"{d + j},S4" for j in range(6)] + [f"{d + 6 * 13 + j},S2" for j in range(6)]
    text += ["*SURFACE, NAME=ROUND"] + lower + ["*SURFACE, NAME=FLAT"] + [f"{cells[1] * (i + 1)},S3" for i in range(cells[0])]
    text += ["*SURFACE INTERACTION, NAME=TOUCH", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", f"{stiffness * BLOCK}", "*FRICTION", f"{FRICTION},{stiffness * BLOCK / 10}"]
    text += ["*CONTACT PAIR, INTERACTION=TOUCH, TYPE=SURFACE TO SURFACE", "ROUND,FLAT", "*BOUNDARY", "BASE,1,2"]
    for many, x, y in (press, 0.0, -PRESS), (slide, reach, -PRESS):
        text += ["*STEP, NLGEOM, INC=2000", "*STATIC", f"{1 / many},1.,1e-5,{1 / many}", "*BOUNDARY", f"TOP,1,1,{x}", f"TOP,2,2,{y}", "*NODE PRINT, NSET=TOP, TOTALS=ONLY", "RF", "*END STEP"]
    return "\n".join(text) + "\n"


def forces(path, up=1):
    """Times (1 to 2: the slide) with vertical and horizontal force; `up` is the vertical axis."""
    with open(path, encoding="utf-8") as file:
        found = re.findall(r"and time\s+(\S+)\s+(\S+)\s+(\S+)\s+(\S+)", file.read())
    return [(float(t), abs(float(part[up])), abs(float(part[0]))) for t, *part in found]


def run(folder, given, measured):
    """Slides as far as it is asked for: `reach` is that of the scene."""
    end = given.reach * given.until
    with open(os.path.join(folder, "scene.inp"), "w", encoding="utf-8") as file:
        file.write(deck([int(n) for n in given.cells.split(",")], given.press, round(given.slide * given.until), end, given.stiffness))
    _, row = measured(["ccx", "scene"], folder, given.limit)
    found = [(t if t < 1 else 1 + (t - 1) * given.until, *force) for t, *force in forces(os.path.join(folder, "scene.dat"))]
    return row, found, iterations(os.path.join(folder, "scene.cvg")).split("/")[0], ""
