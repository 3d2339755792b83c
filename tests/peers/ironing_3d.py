#!/usr/bin/env python3
"""Ironing in space (parameters/ironing_3d.prm, case IR3) by CalculiX: ironing_3d.py [--element C3D8] [--stiffness 100] [--until 0.775] [--write FILE].

The mesh is that of the scene: 18 x 5 x 5 cells of the slab, 46 x 13 x 1 of the die; neo-Hookean, friction 0.3; ten increments of the press by 1.4 and fifty of the slide by 4, which ends at
--until of it. --stiffness of the penalty over Young's modulus of the slab. Slave is the die. Prints the mean forces of the meshed half over slides from 1.2 to 3.1.
"""
import argparse
import itertools
import math
import os
import pathlib
import shutil
import tempfile

from calculix import iterations, rows
from ironing_calculix import forces
from peers import COLUMNS, write
from process import measured

SLAB, DIE, NU, FRICTION = 1.0, 1000.0, 0.3, 0.3
PRESS, SLIDE, LOW, HIGH = 1.4, 4.0, 1.2, 3.1
CORNERS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]  # of a cell in CalculiX' order


class Grid:
    """Nodes and cells of a block of cells, bent by `place` of the part of each side; numbered from what is before."""

    def __init__(self, cells, place, node, cell):
        indices = itertools.product(*(range(n + 1) for n in cells))
        self.number = {index: node + k for k, index in enumerate(indices)}
        self.nodes = {number: place(*(i / n for i, n in zip(index, cells))) for index, number in self.number.items()}
        self.cells = {cell + k: (index, [self.number[tuple(map(sum, zip(index, step)))] for step in CORNERS])
                      for k, index in enumerate(itertools.product(*map(range, cells)))}

    def side(self, axis, end):
        return [number for index, number in self.number.items() if index[axis] == end]

    def top(self, layer):
        """Faces of the last layer along the third axis."""
        return [f"{cell},S2" for cell, (index, _) in self.cells.items() if index[2] == layer]


def grids():
    def bent(a, b, c):
        r, angle = 2.8 + 0.2 * c, math.pi * a
        return 3 + r * math.cos(angle), -2.6 + 2.6 * b, 3 - r * math.sin(angle)

    slab = Grid((18, 5, 5), lambda a, b, c: (9 * a, -2 + 2 * b, -3 + 3 * c), 1, 1)
    return slab, Grid((46, 13, 1), bent, 1 + len(slab.nodes), 1 + len(slab.cells))


def deck(element, stiffness, until):
    slab, die = grids()
    text = ["*NODE, NSET=ALL"] + [f"{n}," + ",".join(f"{x:.12g}" for x in p) for body in (slab, die) for n, p in body.nodes.items()]
    for name, body, young in ("SLAB", slab, SLAB), ("DIE", die, DIE):
        shear, bulk = young / (2 * (1 + NU)), young / (3 * (1 - 2 * NU))
        text += [f"*ELEMENT, TYPE={element}, ELSET={name}"] + [f"{k},{rows(cell)}" for k, (_, cell) in body.cells.items()]
        text += [f"*MATERIAL, NAME={name}", "*HYPERELASTIC, NEO HOOKE", f"{shear / 2:.12g},{2 / bulk:.12g}", f"*SOLID SECTION, ELSET={name}, MATERIAL={name}"]
    driven = die.side(0, 0) + die.side(0, 46)
    sets = ("BASE", slab.side(2, 0)), ("DRIVEN", driven), ("MIDDLE", slab.side(1, 5) + [n for n in die.side(1, 13) if n not in driven])
    text += [line for name, nodes in sets for line in (f"*NSET, NSET={name}", rows(nodes))]
    text += ["*SURFACE, NAME=ROUND", *die.top(0), "*SURFACE, NAME=FLAT", *slab.top(4), "*SURFACE INTERACTION, NAME=TOUCH"]
    text += ["*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", f"{stiffness * SLAB}", "*FRICTION", f"{FRICTION},{stiffness * SLAB / 10}"]
    text += ["*CONTACT PAIR, INTERACTION=TOUCH, TYPE=SURFACE TO SURFACE", "ROUND,FLAT", "*BOUNDARY", "BASE,1,3", "MIDDLE,2,2"]
    for many, x in (10, 0.0), (round(50 * until), SLIDE * until):
        text += ["*STEP, NLGEOM, INC=2000", "*STATIC", f"{1 / many},1.,1e-5,{1 / many}", "*BOUNDARY", f"DRIVEN,1,1,{x}", "DRIVEN,2,2,0.", f"DRIVEN,3,3,{-PRESS}"]
        text += ["*NODE PRINT, NSET=DRIVEN, TOTALS=ONLY", "RF", "*END STEP"]
    return "\n".join(text) + "\n"


def solve(given):
    """The row of the table."""
    with tempfile.TemporaryDirectory(prefix="peers-") as folder:
        pathlib.Path(folder, "scene.inp").write_text(deck(given.element, given.stiffness, given.until), encoding="utf-8")
        _, row = measured(["ccx", "scene"], folder, given.limit)
        found, counted = forces(os.path.join(folder, "scene.dat"), up=2), iterations(os.path.join(folder, "scene.cvg")).split("/")[0]
    slid = [(SLIDE * given.until * (t - 1), v, h) for t, v, h in found]
    middle = [row for row in slid if LOW < row[0] < HIGH + 1e-9]
    mean = [sum(row[k] for row in middle) / max(1, len(middle)) for k in (1, 2)]
    end = f"V {mean[0]:.2f} H {mean[1]:.2f} over {LOW}..{min(HIGH, slid[-1][0]):.3g}" if middle else f"slide {slid[-1][0] if slid else 0:.2f}"
    end = ("" if slid and slid[-1][0] > SLIDE * given.until - 1e-6 else f"not finished: {row['wall']:.0f} s; ") + end
    return {**dict.fromkeys(COLUMNS, ""), "program": "ccx2.20", "formulation": f"f2f {given.element} K={given.stiffness:g}E", "case": "IR3", "N": f"10+{round(50 * given.until)}",
            "threads": "1", "wall": f"{row['wall']:.1f}", "cpu": f"{row['cpu']:.1f}", "memory_MB": f"{row['memory_MB']:.0f}", "iterations": counted, "note": end}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--element", default="C3D8", help="or C3D8I")
    for name, default in ("stiffness", 100.0), ("until", 0.775), ("limit", 600.0):
        parser.add_argument(f"--{name}", type=float, default=default)
    parser.add_argument("--write", type=pathlib.Path)
    given = parser.parse_args()
    if not shutil.which("ccx"):
        print("ccx is left out: it is not installed")
        return
    result = solve(given)
    print(",".join(result[name] for name in COLUMNS))
    if given.write:
        write(given.write, [result])


if __name__ == "__main__":
    main()
