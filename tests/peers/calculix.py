"""Scenes of cases.py as input of CalculiX (ccx 2.20), and its answers.

f2f     face-to-face penalty, in the plane or axisymmetric with elements of degree 1 or 2 (CPE4, CPE8, CAX4), in space C3D8
mortar  C3D8 (mortar works in space only: in the plane one layer, held across)
tie     one linear solve of the same mesh, glued where contact will be

Slave is the curved side, which is the finer one. It reaches to 1.85 a.
"""
import itertools
import math
import os
import re
import shutil

import pressure
from calculix_mesh import Mesh, Plane, slave_nodes
from cases import E, NU, place

STIFFNESS = 50 * E  # of the penalty, N/mm^3: the upper end of the 5 to 50 E that users are told to take. 10 E costs a third less, and its error stays at 3 % on any mesh;
# 500 E takes twice the iterations. It does not follow the mesh, as users' does not: beyond N = 80 it decides on the error.
STICK = 10 * E  # N/mm^3, of friction before it slips: errors are the same to 1 % with 1 and with 100 E
SPRING = 1e3 * E  # N/mm, of each slave node that mortar cannot hold
SAMPLES = 4  # between nodes, for integrals


def rows(values, many=12):
    values = [str(v) for v in values]
    return "\n".join(",".join(values[k:k + many]) for k in range(0, len(values), many))


def interaction(case, contact):
    """What acts between the sides CURVED and FLAT."""
    if contact == "tie":
        return ["*TIE, NAME=GLUE, POSITION TOLERANCE=0.1, ADJUST=NO", "CURVED,FLAT"]
    text = ["*SURFACE INTERACTION, NAME=TOUCH"]
    if contact == "mortar":
        return text + ["*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=HARD", "*CONTACT PAIR, INTERACTION=TOUCH, TYPE=MORTAR", "CURVED,FLAT"]
    text += ["*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", f"{STIFFNESS}"]
    text += ["*FRICTION", f"{case.friction},{STICK}"] if case.friction else []
    return text + ["*CONTACT PAIR, INTERACTION=TOUCH, TYPE=SURFACE TO SURFACE", "CURVED,FLAT"]


def deck(case, N, element, contact, solver="SPOOLES"):
    """The input file; contact is f2f, mortar or tie."""
    degree, space = (2 if element == "CPE8" else 1), element.startswith("C3D8")
    layer = space and case.kind in ("plane", "pin")
    up = 3 if space else 2
    upper = Mesh(case, N, degree, False, layer, {"node": 1, "cell": 1})
    text = ["*NODE, NSET=ALL"]
    bodies = [upper]
    if not case.rigid:
        bodies.append(Mesh(case, N, degree, True, layer, {"node": 1 + len(upper.nodes), "cell": 1 + len(upper.cells)}))
    text += [f"{n}," + ",".join(f"{x:.12g}" for x in point) for body in bodies for n, point in body.nodes.items()]
    text.append(f"*ELEMENT, TYPE={element}, ELSET=SOLID")
    text += [f"{n},{rows(cell)}" for body in bodies for n, cell in body.cells.items()]
    text += ["*MATERIAL, NAME=STEEL", "*ELASTIC", f"{E},{NU}", "*SOLID SECTION, ELSET=SOLID, MATERIAL=STEEL"]
    text += [] if space else ["1."]
    held, springs = [], []
    reach = 1.85 if contact != "tie" else 1 - 1e-9  # of the slave side, times a
    slave = upper.faces(lambda r: r < reach * case.a)
    free = slave_nodes(upper, slave) if contact == "mortar" else set()  # with their supports mortar goes on for ever: they get springs

    def hold(name, nodes, *axes):
        springs.extend((n, axis) for n in nodes if n in free for axis in axes)
        text.extend([f"*NSET, NSET={name}", rows(n for n in nodes if n not in free)])
        held.extend(f"{name},{axis},{axis}" for axis in axes)

    for k, body in enumerate(bodies):
        end = "UL"[k]
        hold(f"FAR{end}", body.side(len(body.lines) - 1, -1 if k == 0 else 0), *([up] if k else []))
        if case.clamped:
            held.extend([f"FAR{end},1,1"] if k else [])
        if not case.whole:
            hold(f"AXIS{end}", body.side(0, 0) + (body.side(0, -1) if case.kind == "pin" else []), 1)
        if space:
            hold(f"ACROSS{end}", body.nodes if layer else body.side(1, 0), 2)
    rigid = case.rigid and contact != "tie"
    if rigid:
        plane = Plane(case, up, {"node": 1 + len(upper.nodes), "cell": 1 + len(upper.cells)})
        text += ["*NODE, NSET=PLANE"] + [f"{n}," + ",".join(f"{x:.12g}" for x in p) for n, p in plane.nodes.items()]
        text += [f"*ELEMENT, TYPE={element}, ELSET=SOLID"] + [f"{n}," + rows(cell) for n, cell in plane.cells.items()]
        held.extend(f"PLANE,{axis},{axis}" for axis in range(1, up + 1))
    if contact == "tie" and case.rigid:
        hold("GLUED", sorted(slave_nodes(upper, slave)), up)
    else:
        master = plane.faces(lambda r: True) if rigid else bodies[1].faces(lambda r: r < 2.2 * case.a)
        text += ["*SURFACE, NAME=CURVED"] + [f"{c},{s}" for c, s in slave] + ["*SURFACE, NAME=FLAT"] + [f"{c},{s}" for c, s in master] + interaction(case, contact)
    first = 1 + sum(len(body.cells) for body in bodies) + 64  # beyond the plane's cells, too
    for axis in sorted({axis for _, axis in springs}):
        text += [f"*ELEMENT, TYPE=SPRING1, ELSET=SPRING{axis}"] + [f"{first + k},{n}" for k, (n, other) in enumerate(springs) if other == axis]
        text += [f"*SPRING, ELSET=SPRING{axis}", f"{axis}", f"{SPRING}"]
    text += ["*BOUNDARY"] + held
    for along in [0.0, case.shear] if case.shear and contact != "tie" else [0.0]:
        text += ["*STEP, INC=100", f"*STATIC, SOLVER={solver}", "1.,1."] if contact != "tie" else ["*STEP", f"*STATIC, SOLVER={solver}"]
        text += ["*BOUNDARY", f"FARU,{up},{up},{-case.press}"] + ([f"FARU,1,1,{along}"] if case.clamped else [])
        text += ["*NODE PRINT, NSET=FARU, TOTALS=ONLY", "RF"]
        text += [] if contact == "tie" else ["*CONTACT FILE", "CDIS,CSTR"]
        text.append("*END STEP")
    return "\n".join(text) + "\n", bodies


def nodal_pressure(path):
    """Contact pressure at nodes, of the last step: {node: value}."""
    values, inside = {}, False
    with open(path, encoding="utf-8") as file:
        for text in file:
            if text.startswith(" -4"):
                inside = "CONTACT" in text
                values = {} if inside else values
            elif inside and text.startswith(" -1"):
                values[int(text[3:13])] = float(text[13 + 3 * 12:13 + 4 * 12])
            elif text.startswith(" -3"):
                inside = False
    return values


def samples(case, upper, nodal):
    """Samples of pressure.py: the nodal pressures, linear in each coordinate between nodes."""
    line = [0, 0] if upper.layered else [0]
    reach = range(upper.shape[0] - 1)
    found, parts = [], [(k + 0.5) / SAMPLES for k in range(SAMPLES)]

    def at(*index):
        return upper.nodes[upper.number[index]], nodal.get(upper.number[index], 0.0)

    for i in reach:
        if case.kind != "space":
            (p, left), (q, right) = at(i, *line), at(i + 1, *line)
            start, end = place(case, p), place(case, q)
            found += [(abs(start + t * (end - start)), (end - start) / SAMPLES, left + t * (right - left)) for t in parts]
            continue
        for j in reach:
            (p, a), (q, b), (_, c), (_, d) = at(i, j, 0), at(i + 1, j + 1, 0), at(i + 1, j, 0), at(i, j + 1, 0)
            area = (q[0] - p[0]) * (q[1] - p[1]) / SAMPLES**2
            for s, t in itertools.product(parts, parts):
                distance = math.hypot(p[0] + s * (q[0] - p[0]), p[1] + t * (q[1] - p[1]))
                found.append((distance, area, (1 - s) * ((1 - t) * a + t * d) + s * ((1 - t) * c + t * b)))
    return [sample for sample in found if sample[0] < 1.7 * case.a]


def iterations(path):
    """As 13, or as 21/2inc, from what CalculiX says of its convergence."""
    with open(path, encoding="utf-8") as file:
        rows = [text.split() for text in file if re.match(r"\s+\d+\s+\d+", text)]
    increments = len({tuple(row[:2]) for row in rows})
    return f"{len(rows)}/{increments}inc" if increments > 1 else str(len(rows))


def force(case, path):
    """Of all of the scene, from the reaction of the far side at the last step. CalculiX makes a wedge of two degrees of what is axisymmetric."""
    with open(path, encoding="utf-8") as file:
        *_, last = re.findall(r"^\s+(\S+)\s+(\S+)\s+(\S+)\s*$", file.read(), re.M)
    return max(map(abs, map(float, last[1:]))) * (180 if case.kind == "axisymmetric" else case.share)


class CalculiX:
    """What peers.py asks of a program."""

    name = "ccx2.20"
    # formulation: element, contact, its glued partner
    forms = {"f2f/CPE4": ("CPE4", "f2f", "tie/CPE4"), "f2f/CPE8": ("CPE8", "f2f", ""), "f2f/CAX4": ("CAX4", "f2f", "tie/CAX4"), "f2f/C3D8": ("C3D8", "f2f", "tie/C3D8"),
             "MORTAR/C3D8": ("C3D8", "mortar", "tie/C3D8"), "tie/CPE4": ("CPE4", "tie", ""), "tie/CAX4": ("CAX4", "tie", ""), "tie/C3D8": ("C3D8", "tie", "")}
    # case: rows
    lot = {"H2": {"f2f/CPE4": (20, 40, 80, 160), "MORTAR/C3D8": (20, 40, 80), "f2f/CPE8": (20,)}, "CM": {"f2f/CPE4": (20, 40, 80)}, "HA": {"f2f/CAX4": (40, 80)},
           "H3": {"f2f/C3D8": (8, 16), "MORTAR/C3D8": (8,)}, "PI": {"f2f/CPE4": (20, 40, 80), "MORTAR/C3D8": (20, 40, 80), "f2f/CPE8": (10, 20, 40)}}

    def missing(self):
        return "" if shutil.which("ccx") else "ccx is not installed"

    def run(self, case, formulation, N, folder, measured):
        element, contact, _ = self.forms[formulation]
        iterative = case.kind == "space" and contact == "f2f"  # in space it is three times as fast; for mortar's unsymmetric systems there is none
        text, bodies = deck(case, N, element, contact, "ITERATIVE CHOLESKY" if iterative else "SPOOLES")
        with open(os.path.join(folder, "scene.inp"), "w", encoding="utf-8") as file:
            file.write(text)
        row = measured(["ccx", "scene"])
        with open(os.path.join(folder, "log"), encoding="utf-8") as file:
            row["dofs"] = re.search(r"number of equations\s+(\d+)", file.read())[1]
        row["iterations"] = "1" if contact == "tie" else iterations(os.path.join(folder, "scene.cvg"))
        if contact != "tie":
            found = samples(case, bodies[0], nodal_pressure(os.path.join(folder, "scene.frd")))
            row["error"] = pressure.error(case, found, force(case, os.path.join(folder, "scene.dat")))
        row["note"] = "ITERATIVE CHOLESKY" if iterative else ""
        return row
