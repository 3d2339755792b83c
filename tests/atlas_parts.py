"""What the points of the failure atlas (atlas.py) are made of: text of scenes, answers of runs, and checks that are written without the program's own.

A check takes a list of answers, one per scene of the point, and returns complaints; none: right.
"""
import csv
import json
import math
import os
import sys
from dataclasses import dataclass, field

DIGITS = 1e-5  # relative: the solver's tolerance is 1e-9; bodies up to 1e8 times as stiff as others, or with nu = 0.4999999, lose digits


NU = [0, 0.2, 0.3, 0.45, 0.49, 0.4999, 0.4999999]
MU = [0.01, 0.1, 0.3, 0.6, 1, 3, 10]
SLAVES = ["automatic", "first", "second"]


@dataclass
class Scene:
    text: str
    files: dict = field(default_factory=dict)


@dataclass
class Point:
    family: str
    name: str
    scenes: list
    check: object = None  # None: there is no equilibrium


class Answer:
    """What a run left in its folder."""

    def __init__(self, folder, code, output, seconds):
        self.code, self.output, self.seconds = code, output, seconds
        self.summary, self.rows = {}, []
        path = os.path.join(folder, "summary.json")
        if os.path.exists(path):
            with open(path) as file:
                self.summary = json.load(file)
        path = os.path.join(folder, "contact.csv")
        if os.path.exists(path):
            with open(path) as file:
                self.rows = [{key: value if key in ("pair", "state") else float(value) for key, value in row.items()} for row in csv.DictReader(file)]
        self.converged = code == 0 and self.summary.get("status") == "converged"
        self.iterations = sum(solve["iterations"] for solve in self.summary.get("newton", []))
        self.increments = len(self.summary.get("meshes", []))

    def force(self, pair=None):
        """Sum of the nodal forces on the slave, of one pair or all."""
        return [sum(row[key] for row in self.rows if pair in (None, row["pair"])) for key in ("fx", "fy", "fz")]

    def moment(self):
        return sum(row["X"] * row["fy"] - row["Y"] * row["fx"] for row in self.rows)

    def size(self):
        """Of all forces, to compare others with."""
        nodal = sum(math.hypot(row["fx"], row["fy"], row["fz"]) for row in self.rows)
        return max([nodal] + [math.hypot(*reaction["force"]) for reaction in self.summary["reactions"]])

    def displacement(self, probe=0):
        return self.summary["probes"][probe]["points"][0]["displacement"]


# ---- Text of scenes


def number(value):
    if isinstance(value, (tuple, list)):
        return ", ".join(number(v) for v in value)
    return value if isinstance(value, str) else repr(value)


def section(title, **entries):
    lines = [f"  set {name.replace('_', ' ')} = {number(value)}" for name, value in entries.items()]
    return "\n".join([f"subsection {title}"] + lines + ["end", ""])


def block(name, lower, upper, cells, E=1000.0, nu=0.3, **more):
    return section(f"Body {name}", Mesh="block", Lower_corner=lower, Upper_corner=upper, Cells=cells, Young_modulus=E, Poisson_ratio=nu, **more)


def ring(name, inner, outer, refinements, E=1000.0, nu=0.3, **more):
    return section(f"Body {name}", Mesh="quarter ring", Radius=outer, Inner_radius=inner, Refinements=refinements, Young_modulus=E, Poisson_ratio=nu, **more)


def plane(name, centre, normal, **more):
    return section(f"Obstacle {name}", Surface="plane", Centre=centre, Normal=normal, **more)


def condition(boundaries, kind, value=None, **more):
    if value is not None:
        more = {"Value": value if isinstance(value, str) else repr(value), **more}
    name = (boundaries + " " + kind).replace("/", " ").replace(",", "")
    return section(f"Boundary condition {name}", Boundaries=boundaries, Type=kind, **more)


def contact(first, second, name="c", **more):
    return section(f"Contact {name}", First=first, Second=second, **more)


def friction(mu):
    return {"Friction_coefficient": mu} if mu else {}


def probe(body, point):
    return section(f"Probe {body}", Body=body, Point=point)


def scene(*sections, files=None, degree=2, refinements=0, **top):
    top = {"Kind": "plane strain", "Kinematics": "small strain", **top}
    head = "".join(f"set {name.replace('_', ' ')} = {number(value)}\n" for name, value in top.items())
    fixed = section("Discretization", Degree=degree) + section("Refinement", Initial_refinements=refinements, Target_error=0)
    fixed += section("Output", VTU="false", Report="false")
    return Scene(head + "\n" + "\n".join(sections) + "\n" + fixed, files or {})


def quadrilaterals(lower, upper, cells, move):
    """A block as a gmsh 2.2 file; move(i, j) are the shifts of vertices in cell sizes."""
    n, m = cells
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "5", '1 1 "bottom"', '1 2 "top"', '1 3 "left"', '1 4 "right"', '2 5 "body"']
    lines += ["$EndPhysicalNames", "$Nodes", str((n + 1) * (m + 1))]
    for j in range(m + 1):
        for i in range(n + 1):
            a, b = move(i, j)
            x = lower[0] + (upper[0] - lower[0]) * (i + (a if 0 < i < n else 0)) / n
            y = lower[1] + (upper[1] - lower[1]) * (j + (b if 0 < j < m else 0)) / m
            lines.append(f"{1 + i + (n + 1) * j} {x!r} {y!r} 0")

    def vertex(i, j):
        return 1 + i + (n + 1) * j

    elements = [(1, 1, vertex(i, 0), vertex(i + 1, 0)) for i in range(n)] + [(1, 2, vertex(i, m), vertex(i + 1, m)) for i in range(n)]
    elements += [(1, 3, vertex(0, j), vertex(0, j + 1)) for j in range(m)] + [(1, 4, vertex(n, j), vertex(n, j + 1)) for j in range(m)]
    elements += [(3, 5, vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)) for i in range(n) for j in range(m)]
    lines += ["$EndNodes", "$Elements", str(len(elements))]
    for k, (kind, group, *vertices) in enumerate(elements):
        lines.append(f"{k + 1} {kind} 2 {group} {group} " + " ".join(str(v) for v in vertices))
    return "\n".join(lines + ["$EndElements", ""])


# ---- Moduli


def plane_modulus(E, nu):
    return E / (1 - nu * nu)


def confined_modulus(E, nu):
    return E * (1 - nu) / ((1 + nu) * (1 - 2 * nu))


def shear_modulus(E, nu):
    return E / (2 * (1 + nu))


# ---- Parameters


def power(r, low, high):
    """Ten to a random power, of four digits, so that scene and formula have the same number."""
    return float("%.4g" % 10 ** r.uniform(low, high))


def faces(r):
    """Numbers of faces of two sides: equal, not matching, up to 1:50."""
    pair = r.choice([(3, 3), (4, 5), (7, 4), (1, 6), (2, 20), (1, 50)])
    return pair if r.random() < 0.5 else pair[::-1]


def materials(r, count=2, most=1e10):
    """E and nu: Young's moduli up to 1e8 apart, Poisson's ratios to 0.4999999, but not so much of both that double precision cannot hold the answer."""
    while True:
        E = [1000.0] + [1000 * 10.0 ** r.choice([-8, -6, -3, -1, 0, 0, 1, 3, 6, 8]) for _ in range(count - 1)]
        nu = [r.choice(NU) for _ in range(count)]
        if contrast(E, nu) <= most:
            return E, nu


def contrast(E, nu):
    """Largest over smallest stiffness: so much is lost of the digits of a soft body's forces."""
    return max(a / (1 - 2 * b) for a, b in zip(E, nu)) / min(E)


def digits_left(E, nu):
    return max(DIGITS, 1000 * sys.float_info.epsilon * contrast(E, nu))


# ---- Checks


def near(what, value, expected, scale=None, digits=DIGITS):
    """Numbers or vectors agree, relative to `scale` (their own size)."""
    a, b = (v if isinstance(v, (list, tuple)) else [v] for v in (value, expected))
    scale = scale if scale is not None else max([abs(v) for v in b])
    off = max(abs(x - y) for x, y in zip(a, b))
    if math.isfinite(off) and off <= digits * scale:
        return []
    return [f"{what}: {', '.join('%.9g' % v for v in a)} instead of {', '.join('%.9g' % v for v in b)} (off by {off:.2e}, scale {scale:.2e})"]


def sound(answer, mu=0.0, bound=math.inf, applied=None, moment=None, digits=DIGITS, least=0.0):
    """Of any answer: no tension, the cone, no penetration, and balance of reactions with the applied force (and moment about the origin).
    mu: of all pairs or by pair, None where tied. least: a force that is not small in the scene, where in the end none is left."""
    result, size = [], max(answer.size(), least)
    length = max([abs(row[key]) for row in answer.rows for key in ("X", "Y", "Z")] + [0])
    for row in answer.rows:
        limit = mu[row["pair"]] if isinstance(mu, dict) else mu
        f, n = [row[k] for k in ("fx", "fy", "fz")], [row[k] for k in ("nx", "ny", "nz")]
        where = f"at {row['pair']} ({row['X']:g}, {row['Y']:g}, {row['Z']:g})"
        if limit is None:
            continue
        normal = sum(a * b for a, b in zip(f, n))
        shear = math.hypot(*[a - normal * b for a, b in zip(f, n)])
        if not normal <= digits * size:
            result.append(f"tension {normal:.3e} of {size:.3e} {where}")
        if not shear <= min(limit * abs(normal), bound * row["area"]) + digits * size:
            result.append(f"shear {shear:.3e} at force {normal:.3e} of {size:.3e} {where}")
        if row["gap"] < -digits * length:
            result.append(f"penetration {row['gap']:.3e} {where}")
        if row["state"] == "open" and max(abs(v) for v in f) > digits * size:
            result.append(f"force at open node {where}")
    if applied is not None:
        result += balance(answer, applied, moment, size, digits)
    return result


def balance(answer, applied, moment, size, digits):
    reactions = answer.summary["reactions"]
    rest = [a + sum(reaction["force"][d] for reaction in reactions) for d, a in enumerate(applied)]
    result = near("reactions and loads", rest, [0] * len(rest), max(size, math.hypot(*applied)), digits)
    if moment is not None:
        rest = moment + sum(reaction["moment"][-1] for reaction in reactions)
        result += near("moments of reactions and loads", rest, 0, max(size, math.hypot(*applied)) * extent(answer), digits)
    return result


def extent(answer):
    return max([abs(row[key]) for row in answer.rows for key in ("X", "Y", "Z")] + [1e-300])


def uniform(answer, pressure, pair=None, digits=DIGITS):
    """All pressures of the pair are this."""
    values = [row["pressure"] for row in answer.rows if pair in (None, row["pair"])]
    if not values:
        return ["no contact nodes"]
    worst = max(values, key=lambda p: abs(p - pressure) if math.isfinite(p) else math.inf)
    return near("pressure", worst, pressure, digits=digits)


def estimated(answer):
    """What the program says that its answer is off by."""
    return max(value for key, value in answer.summary["error_estimate"].items() if not key.endswith("kinematics"))
