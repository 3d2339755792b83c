"""The points of the failure atlas (atlas.py): families of small scenes, each with what mathematics knows about the answer.

A family is a function that takes a random generator of its own for each point, and returns a name, scenes, and a check; FAMILIES says how many points it has.
"""
import math
import random

from atlas_oracles import (
    Point, block, condition, confined_modulus, contact, estimated, extent, friction, near, number, plane, plane_modulus, probe, quadrilaterals,
    ring, same, scene, section, shear_modulus, sound, uniform,
)

NU = [0, 0.2, 0.3, 0.45, 0.49, 0.4999, 0.4999999]
MU = [0.01, 0.1, 0.3, 0.6, 1, 3, 10]
SLAVES = ["automatic", "first", "second"]


def power(r, low, high):
    """Ten to a random power, of four digits, so that scene and formula have the same number."""
    return float("%.4g" % 10 ** r.uniform(low, high))


def cells(r):
    """Numbers of faces of two sides: equal, not matching, up to 1:50."""
    pair = r.choice([(3, 3), (4, 5), (7, 4), (1, 6), (2, 20), (1, 50)])
    return pair if r.random() < 0.5 else pair[::-1]


def materials(r):
    """Two: Young's moduli up to 1e8 apart, Poisson's ratios to 0.4999999."""
    return 1000.0, float("%.4g" % (1000 * 10 ** r.choice([-8, -6, -3, -1, 0, 0, 1, 3, 6, 8]))), r.choice(NU), r.choice(NU)


def two_blocks(r, width=2.0, files=False):
    """Upper block on the lower one, joint at y = 0: sections and numbers."""
    (n1, n2), (E1, E2, nu1, nu2) = cells(r), materials(r)
    h1, h2 = power(r, -1, 0.5), power(r, -1, 0.5)
    rows = r.choice([1, 2, 3])
    text = block("upper", (0, 0), (width, h1), (n1, rows), E1, nu1) + block("lower", (0, -h2), (width, 0), (n2, rows), E2, nu2)
    name = f"{n1}to{n2} E1:{E2 / E1:g} nu{nu1}and{nu2} h{h1:g}and{h2:g}"
    return text, name, (h1, h2), (E1, E2), (nu1, nu2)


def patch(r):
    """Two blocks, free at a side, pressed by displacement, pressure, force or platen: the pressure is uniform (known), whatever the meshes."""
    text, name, h, E, nu = two_blocks(r)
    compliance = sum(a / plane_modulus(b, c) for a, b, c in zip(h, E, nu))
    p = float("%.6g" % (1e-3 * min(h) / compliance))
    load = r.choice(["displacement", "pressure", "total force", "obstacle"])
    top = {
        "displacement": lambda: condition("upper/top", "displacement", f"free; {-p * compliance!r}"),
        "pressure": lambda: condition("upper/top", "pressure", p),
        "total force": lambda: condition("upper/top", "total force", f"0; {-2 * p!r}"),
        "obstacle": lambda: plane("press", (1, h[0]), (0, -1), Force=f"0; {-2 * p!r}") + contact("upper/top", "press", name="top"),
    }[load]()
    slave, degree = r.choice(SLAVES), r.choice([1, 2])
    text += top + condition("lower/bottom", "displacement", "free; 0")
    text += condition("upper/left, lower/left", "symmetry") + contact("upper/bottom", "lower/top", Slave=slave) + probe("upper", (0, h[0]))

    def check(answers):
        (a,) = answers
        return uniform(a, p) + near("force", abs(a.force("c")[1]), 2 * p) + near("top", a.displacement()[1], -p * compliance) + sound(a)

    return f"{name} {load} {slave} Q{degree}", [scene(text, degree=degree)], check


def patch_friction(r):
    """Two blocks under pressure and shear in uniform stress: the shear force is f mu p per length when all sticks, mu p once dragged on."""
    text, name, h, E, nu = two_blocks(r)
    mu, increments, slave = r.choice(MU), r.choice([1, 2, 5, 16]), r.choice(SLAVES)
    f = r.choice([0.1, 0.9, 0.999, 1.5 if mu <= 0.6 else 0.5])  # 1.5: dragged on; the sides carry the shear of the limit
    p = float("%.6g" % (1e-4 * min(E) / max(1, mu)))
    delta = p * sum(a / confined_modulus(b, c) for a, b, c in zip(h, E, nu))
    shear = mu * p * sum(a / shear_modulus(b, c) for a, b, c in zip(h, E, nu))
    q = min(f, 1.0) * mu * p
    text += condition("upper/top", "displacement", f"{f * shear!r}*t; {-delta!r}*table(0: 0, 0.5: 1)" if f < 1 else
                      f"{shear!r}*table(0: 0, 0.5: 0, 0.9: 0.999, 1: 1.2); {-delta!r}*table(0: 0, 0.5: 1)")
    if f < 1:
        text = text.replace(f"{f * shear!r}*t", f"{f * shear!r}*table(0.5: 0, 1: 1)")
    history = "table(0.5: 0, 1: 1)" if f < 1 else "table(0.5: 0, 0.9: 0.999, 1: 1)"
    text += condition("lower/bottom", "displacement", "0; 0")
    text += condition("upper/right, lower/right", "traction", f"0; {q!r}*{history}") + condition("upper/left, lower/left", "traction", f"0; {-q!r}*{history}")
    for body, v in zip(("upper", "lower"), nu):
        text += condition(f"{body}/left, {body}/right", "pressure", f"{v / (1 - v) * p!r}*table(0: 0, 0.5: 1)")
    text += contact("upper/bottom", "lower/top", Slave=slave, **friction(mu))

    def check(answers):
        (a,) = answers
        x, y, _ = a.force()
        return uniform(a, p) + near("pressing", abs(y), 2 * p) + near("shear", abs(x), 2 * q, 2 * p * max(mu, 1)) + sound(a, mu)

    return f"{name} mu{mu} f{f} {increments}inc {slave}", [scene(text, Increments=increments)], check


def interference(r):
    """Two confined blocks with an overlap or a gap (declared, or of the meshes), one of them moved: a uniform pressure, or none."""
    (n1, n2), (E1, E2, nu1, nu2) = cells(r), materials(r)
    h1, h2 = power(r, -1, 0.5), power(r, -1, 0.5)
    unit = 1e-3 * min(h1, h2)
    gap = unit * r.choice([-1, -1e-6, 0, 0.5, 1, 10])
    meshes = gap > 0 and r.random() < 0.5
    move = unit * r.choice([0, 0.5, 1, 1.5])
    slave, mu = r.choice(SLAVES), r.choice([0, 0, 0.3, 10])
    y = gap if meshes else 0.0
    text = block("upper", (0, y), (2, y + h1), (n1, 2), E1, nu1) + block("lower", (0, -h2), (2, 0), (n2, 2), E2, nu2)
    text += condition("upper/top", "displacement", f"free; {-move!r}*t")
    text += condition("upper/left, lower/left, upper/right, lower/right, lower/bottom", "symmetry")
    more = {} if meshes else {"Initial_gap": f"{gap!r}*t" if gap < 0 else gap}
    text += contact("upper/bottom", "lower/top", Slave=slave, **friction(mu), **more)
    p = max(move - gap, 0) / (h1 / confined_modulus(E1, nu1) + h2 / confined_modulus(E2, nu2))
    full = unit / (h1 / confined_modulus(E1, nu1) + h2 / confined_modulus(E2, nu2))

    def check(answers):
        (a,) = answers
        off = near("force", abs(a.force()[1]), 2 * p, 2 * max(p, 1e-2 * full))
        return off + near("shear", a.force()[0], 0, 2 * full) + (uniform(a, p) + sound(a, mu) if p > 1e-9 * full else [])

    name = f"{n1}to{n2} E1:{E2 / E1:g} nu{nu1}and{nu2} gap{gap / unit:g}{'meshed' if meshes else ''} move{move / unit:g} mu{mu} {slave}"
    return name, [scene(text)], check


def column(r):
    """A confined pile of blocks that nothing but contact holds, under gravity: each joint carries the weight above it."""
    count = r.choice([2, 3, 4])
    heights = [power(r, -1, 0.3) for _ in range(count)]
    E = [1000 * 10.0 ** r.choice([-4, -2, 0, 0, 2, 4]) for _ in range(count)]
    nu = [r.choice(NU) for _ in range(count)]
    mu, slave, degree = r.choice([0, 0, 0.1, 1]), r.choice(SLAVES), r.choice([1, 2])
    density = float("%.4g" % (1e-3 * min(E) / sum(heights)))
    text, y = plane("floor", (0, 0), (0, 1)), 0.0
    for k in range(count):
        text += block(f"b{k}", (0, y), (1.5, y + heights[k]), (r.choice([1, 2, 3, 5, 8, 20]), 2), E[k], nu[k], Body_force=f"0; {-density!r}*t")
        below = ("floor",) if k == 0 else (f"b{k - 1}/top",)
        text += contact(f"b{k}/bottom", *below, name=f"j{k}", Slave=slave if k else "automatic", **friction(mu))
        text += condition(f"b{k}/left, b{k}/right", "symmetry")
        y += heights[k]

    def check(answers):
        (a,) = answers
        off = sound(a, mu)
        for k in range(count):
            off += near(f"joint {k}", abs(a.force(f"j{k}")[1]), 1.5 * density * sum(heights[k:]))
        return off

    name = f"{count} E{','.join('%g' % v for v in E)} nu{nu} mu{mu} {slave} Q{degree}"
    return name.replace(" ", "_"), [scene(text, degree=degree)], check


def slab(r, over=False):
    """A slab that nothing but contact and friction holds, pressed and pushed: the floor carries both forces. Beyond mu N nothing holds it."""
    mu, increments = r.choice(MU), r.choice([1, 3, 10])
    f = r.choice([1.02, 1.2, 3]) if over else r.choice([0.1, 0.5, 0.9, 0.98])
    h = min(1.0, 0.5 / mu)
    n, m, E, nu = r.choice([2, 5, 8, 20]), r.choice([1, 2, 4]), 10.0 ** r.choice([3, 6]), r.choice(NU)
    p = 1e-4 * E / max(1, mu)
    q = f * mu * p * 2 / h
    text = plane("floor", (0, 0), (0, 1)) + block("slab", (0, 0), (2, h), (n, m), E, nu)
    text += condition("slab/top", "pressure", f"{p!r}*table(0: 0, 0.5: 1)") + condition("slab/left", "pressure", f"{q!r}*table(0.5: 0, 1: 1)")
    text += contact("slab/bottom", "floor", **friction(mu))

    def check(answers):
        (a,) = answers
        moment = -q * h * h / 2 - p * 2  # about the origin, of both pressures
        off = near("forces", a.force(), [-q * h, 2 * p, 0], 2 * p * max(mu, 1)) + near("moment", a.moment() + moment, 0, 2 * p * max(mu, 1))
        return off + sound(a, mu)

    return f"mu{mu} f{f} {n}x{m} nu{nu} E{E:g} {increments}inc", [scene(text, Increments=increments)], None if over else check


def slab_over(r):
    return slab(r, over=True)


def tipping(r, over=False):
    """A block on the edge of a shorter support, its weight to the left or right of it: stands, or tips over and nothing holds it."""
    centre = r.choice([1.05, 1.2, 1.9] if over else [0, 0.5, 0.8, 0.9]) * r.choice([-1, 1])
    n, m, nu, mu = r.choice([3, 6, 10]), r.choice([1, 3]), r.choice(NU), r.choice([0.1, 0.6, 3])
    E = 1e6
    text = block("block", (centre - 1.5, 0), (centre + 1.5, 1), (n, m), E, nu, Body_force=f"0; {-20.0!r}*t")
    text += block("base", (-1, -1), (1, 0), (r.choice([2, 5, 9]), 2), E, 0.3) + condition("base/bottom", "displacement", "0; 0")
    slave = r.choice(SLAVES)
    text += contact("block/bottom", "base/top", Slave=slave, **friction(mu))

    def check(answers):
        (a,) = answers
        sign = -1 if a.force()[1] < 0 else 1  # the slave may be the base
        off = near("weight", [sign * v for v in a.force()], [0, 60, 0], 60) + near("moment", sign * a.moment(), 60 * centre, 60)
        return off + sound(a, mu, applied=(0, -60), moment=-60 * centre)

    return f"at{centre:g} {n}x{m} nu{nu} mu{mu} {slave}", [scene(text, Increments=r.choice([1, 4]))], None if over else check


def tipping_over(r):
    return tipping(r, over=True)


def cross(r):
    """Four blocks at a point, shortened both ways, any of the joints tied, with friction or without: the stress is uniform (known)."""
    E, nu = 1000.0, r.choice(NU)
    ex, ey = 1e-3 * r.choice([0.1, 1, 1]), 1e-3 * r.choice([0.1, 1])
    # Stress in plane strain under the strains -ex, -ey.
    first, second = E / ((1 + nu) * (1 - 2 * nu)) * (1 - nu), E / ((1 + nu) * (1 - 2 * nu)) * nu
    px, py = first * ex + second * ey, first * ey + second * ex
    text = ""
    for name, x, y in ("a", 0, 0), ("b", 1, 0), ("c", 0, -1), ("d", 1, -1):
        text += block(name, (x, y), (x + 1, y + 1), (r.choice([1, 2, 3, 5, 10]), r.choice([1, 2, 3, 5])), E, nu)
    text += condition("a/top, b/top", "displacement", f"free; {-2 * ey!r}*t") + condition("c/bottom, d/bottom", "displacement", "free; 0")
    text += condition("a/left, c/left", "displacement", f"{2 * ex!r}*t; free") + condition("b/right, d/right", "displacement", "0; free")
    joints, mu, name = {"u": ("a/right", "b/left"), "l": ("c/right", "d/left"), "m": ("a/bottom", "c/top"), "n": ("b/bottom", "d/top")}, {}, ""
    for joint, sides in joints.items():
        kind, slave = r.choice(["smooth", "smooth", "rough", "tied"]), r.choice(SLAVES)
        more = {"smooth": {}, "rough": friction(0.3), "tied": {"Tied": "true"}}[kind]
        text += contact(*sides, name=joint, Slave=slave, **more)
        mu[joint] = {"smooth": 0, "rough": 0.3, "tied": None}[kind]
        name += f"{joint}{kind}{slave} "

    def check(answers):
        (a,) = answers
        off = sound(a, mu)
        # Equal strains on both sides of a joint: the points do not slide, so all joints may be tied.
        reactions = {reaction["boundary"]: reaction["force"] for reaction in a.summary["reactions"]}
        for boundary, d, value in ("a/top", 1, -py), ("d/bottom", 1, py), ("a/left", 0, px), ("d/right", 0, -px):
            off += near(boundary, reactions[boundary][d], value, max(px, py), 10 * 1e-6)
        return off

    return f"{name}nu{nu} ex{ex:g} ey{ey:g}", [scene(text)], check


def pulled(r):
    """A block that lies on something, and is pulled away, upwards or at an angle: nothing holds it."""
    mu, nu, angle = r.choice([0, 0.1, 1, 10]), r.choice(NU), math.radians(r.choice([90, 60, 120, 89]))
    n = r.choice([1, 4, 9])
    text = block("block", (0, 0), (2, 1), (n, 2), 1000.0, nu)
    force = f"{math.cos(angle)!r}*t; {math.sin(angle)!r}*t"
    text += condition("block/top", "total force", force) if r.random() < 0.5 else ""
    if "total force" not in text:
        text = text.replace("Poisson_ratio", "Poisson_ratio").replace("end\n", f"  set Body force = {math.cos(angle)!r}; {math.sin(angle)!r}\nend\n", 1)
    on = r.choice(["obstacle", "body"])
    if on == "body":
        text += block("base", (-1, -1), (3, 0), (5, 2)) + condition("base/bottom", "displacement", "0; 0") + contact("block/bottom", "base/top", **friction(mu))
    else:
        text += plane("floor", (0, 0), (0, 1)) + contact("block/bottom", "floor", **friction(mu))
    kinematics = r.choice(["small strain", "finite strain"])
    return f"{on} mu{mu} nu{nu} {math.degrees(angle):g}deg {n} {kinematics}", [scene(text, Kinematics=kinematics)], None


NOTHING_HOLDS = r"hold|held|nothing|balance|support"

# Family, number of points.
FAMILIES = [
    (patch, 120), (patch_friction, 120), (interference, 80), (column, 60), (slab, 60), (slab_over, 30), (tipping, 30), (tipping_over, 20), (cross, 60),
    (pulled, 30),
]


def points():
    """All of them, kinds mixed so that each N-th takes from all families."""
    result = []
    for family, count in FAMILIES:
        for k in range(count):
            name, scenes, check = family(random.Random(f"{family.__name__} {k}"))
            name = f"{k} {name}".replace(" ", "_")
            result.append(Point(family.__name__, name, scenes, check, NOTHING_HOLDS))
    return result
