"""Shallow ironing by GetFEM (Debian's python3-getfem), a process of its own: ironing_getfem.py CELLS PRESS SLIDE REACH UNTIL STIFFNESS SLAVE ANSWER.

Elements and multipliers Q1, neo-Hookean; contact by ray tracing (Poulios and Renard 2015), an augmented Lagrangian of STIFFNESS times Young's modulus of the block. SLAVE, block or die,
carries the multiplier. The slide of REACH in SLIDE increments ends at UNTIL of it; an increment that does not converge is halved.
"""
import json
import sys

import getfem as gf
import numpy as np
from ironing_mesh import BLOCK, DIE, FRICTION, NU, PRESS, die, graded

HELD, DRIVEN, CONTACT = 1, 2, 3
RELEASE = 0.6  # how far rays look
HALVINGS = 6
MOST = 30  # iterations of an increment


class Body:
    """Mesh and elements of a grid of nodes [i][j]; the sides of its regions are tests of the indices of a face's two nodes."""

    def __init__(self, nodes, young, regions):
        grid = np.array(nodes)
        cells = [(i, j) for i in range(len(grid) - 1) for j in range(len(grid[0]) - 1)]
        self.mesh = gf.Mesh("empty", 2)
        for i, j in cells:
            self.mesh.add_convex(gf.GeoTrans("GT_QK(2,1)"), np.array([grid[i, j], grid[i + 1, j], grid[i, j + 1], grid[i + 1, j + 1]]).T)
        index = {tuple(np.round(grid[i, j], 9)): (i, j) for i in range(len(grid)) for j in range(len(grid[0]))}
        faces = self.mesh.outer_faces()
        points = self.mesh.pts()
        ends = [[index[tuple(np.round(points[:, p], 9))] for p in self.mesh.pid_in_faces(faces[:, k:k + 1])] for k in range(faces.shape[1])]
        for number, test in regions.items():
            self.mesh.set_region(number, faces[:, [k for k, face in enumerate(ends) if test(face)]])
        self.u = gf.MeshFem(self.mesh, 2)
        self.u.set_classical_fem(1)
        self.mim = gf.MeshIm(self.mesh, gf.Integ("IM_GAUSS_PARALLELEPIPED(2, 4)"))
        self.lame = young * NU / ((1 + NU) * (1 - 2 * NU)), young / (2 * (1 + NU))


def bodies(cells):
    across, up = graded(0, 12, cells[0], 1), graded(-4, 0, cells[1], 0.4)
    block = Body([[(x, y) for y in up] for x in across], BLOCK, {HELD: lambda f: all(j == 0 for _, j in f), CONTACT: lambda f: all(j == cells[1] for _, j in f)})
    tool = die()
    last, top = len(tool) - 1, len(tool[0]) - 1
    tool = Body(tool, DIE, {DRIVEN: lambda f: all(j == top for _, j in f), CONTACT: lambda f: all(j == 0 for _, j in f) or all(i == 0 for i, _ in f) or all(i == last for i, _ in f)})
    return block, tool


def neo_hooke(name, lame):
    """mu (F - F^-T) + lambda/2 (J^2 - 1) F^-T."""
    F = f"(Id(2)+Grad_{name})"
    return f"({lame[1]!r}*({F}-Inv({F})')+{lame[0] / 2!r}*(sqr(Det({F}))-1)*Inv({F})'):Grad_Test_{name}"


def model(block, tool, stiffness, slave):
    md = gf.Model("real")
    for name, body in ("w", block), ("u", tool):
        md.add_fem_variable(name, body.u)
        md.add_fem_data(name + "0", body.u)
        md.add_nonlinear_term(body.mim, neo_hooke(name, body.lame))
    md.add_initialized_data("drive", [0.0, 0.0])
    md.add_Dirichlet_condition_with_simplification("w", HELD)
    md.add_Dirichlet_condition_with_simplification("u", DRIVEN, "drive")
    md.add_initialized_data("r", [stiffness * BLOCK])
    md.add_initialized_data("friction", [FRICTION])
    one, two = (("w", block), ("u", tool)) if slave == "block" else (("u", tool), ("w", block))
    md.add_filtered_fem_variable("p", one[1].u, CONTACT)
    brick = md.add_integral_large_sliding_contact_brick_raytracing("r", RELEASE, "friction", "1", 0)
    md.add_slave_contact_boundary_to_large_sliding_contact_brick(brick, one[1].mim, CONTACT, one[0], "p", one[0] + "0")
    md.add_master_contact_boundary_to_large_sliding_contact_brick(brick, two[1].mim, CONTACT, two[0], two[0] + "0")
    return md, one[1]


def force(md, side):
    return [abs(float(gf.asm_generic(side.mim, 0, f"p({k})", CONTACT, md))) for k in (2, 1)]


def place(t, reach):
    return [reach * max(t - 1, 0.0), -PRESS * min(t, 1.0)]


def increment(md, t, reach):
    """Iterations, and whether it converged; if not, all is as it was."""
    old = {name: md.variable(name) for name in ("u", "w", "p")}
    md.set_variable("drive", place(t, reach))
    many, converged = md.solve("max_res", 1e-6, "max_iter", MOST, "noisy", "lsearch", "simplest", "alpha min", 0.2)
    if many >= MOST or not all(np.isfinite(md.variable(name)).all() for name in old):
        for name, value in old.items():
            md.set_variable(name, value)
        return many, False
    for name in ("u", "w"):
        md.set_variable(name + "0", md.variable(name))
    return many, True


def walk(md, side, press, slide, reach, until):
    """Rows of time, vertical and horizontal force; iterations; the time that was reached."""
    ends = [(k + 1) / press for k in range(press)] + [1 + (k + 1) / slide for k in range(round(slide * until))]
    rows, total, t = [], 0, 0.0
    for end in ends:
        step = end - t
        while t < end - 1e-9:
            many, converged = increment(md, min(t + step, end), reach)
            total += many
            if not converged:
                step /= 2
                if step < (ends[1] - ends[0]) / 2**HALVINGS:
                    return rows, total, t
                continue
            t = min(t + step, end)
        rows.append([t, *force(md, side)])
    return rows, total, t


def main():
    press, slide, reach, until, stiffness = int(sys.argv[2]), int(sys.argv[3]), *map(float, sys.argv[4:7])
    gf.util_trace_level(0)
    gf.util_warning_level(0)
    pair = bodies([int(n) for n in sys.argv[1].split(",")])  # GetFEM's model does not keep what it is made of
    md, side = model(*pair, stiffness, sys.argv[7])
    rows, total, t = walk(md, side, press, slide, reach, until)
    with open(sys.argv[8], "w", encoding="utf-8") as file:
        json.dump({"rows": rows, "iterations": total, "end": t, "dofs": md.nbdof()}, file)


if __name__ == "__main__":
    main()
