"""Points of the failure atlas (atlas.py) with answers in closed form: uniform stress in blocks, columns, cross points, tubes, Hertz.

A family is a function that takes a random generator of its own for each point, and returns a name, scenes, and a check of their answers.
"""
import math

from atlas_parts import (
    MU, NU, SLAVES, block, condition, confined_modulus, contact, digits_left, faces, friction, materials, near, plane, plane_modulus, power, probe,
    quadrilaterals, ring, scene, section, shear_modulus, sound, uniform,
)


def two_blocks(r, low=-1.0, high=0.5, most=1e10):
    """Upper block on the lower one, joint at y = 0: sections, name, heights, E, nu."""
    (n1, n2), (E, nu) = faces(r), materials(r, most=most)
    h = power(r, low, high), power(r, low, high)
    rows = r.choice([1, 2, 3])
    text = block("upper", (0, 0), (2, h[0]), (n1, rows), E[0], nu[0]) + block("lower", (0, -h[1]), (2, 0), (n2, rows), E[1], nu[1])
    return text, f"{n1}to{n2} E1:{E[1] / E[0]:g} nu{nu[0]}and{nu[1]} h{h[0]:g}and{h[1]:g}", h, E, nu


def compliance(h, E, nu, modulus):
    return sum(a / modulus(b, c) for a, b, c in zip(h, E, nu))


def pressed(r, text, name, h, E, nu, **files):
    """Two blocks, free at a side, pressed by displacement, pressure, force or obstacle: the pressure is uniform (known), whatever the meshes."""
    soft = compliance(h, E, nu, plane_modulus)
    p = float("%.6g" % (1e-3 * min(h) / soft))
    loads = {
        "displacement": condition("upper/top", "displacement", f"free; {-p * soft!r}"),
        "pressure": condition("upper/top", "pressure", p),
        "total force": condition("upper/top", "total force", f"0; {-2 * p!r}"),
        "obstacle": plane("press", (1, h[0]), (0, -1), Force=f"0; {-2 * p!r}") + contact("upper/top", "press", name="top"),
    }
    load, slave, degree = r.choice(list(loads)), r.choice(SLAVES), r.choice([1, 2])
    text += loads[load] + condition("lower/bottom", "displacement", "free; 0")
    text += condition("upper/left, lower/left", "symmetry") + contact("upper/bottom", "lower/top", Slave=slave) + probe("upper", (0, h[0]))
    digits = digits_left(E, nu)

    def check(answers):
        (a,) = answers
        off = uniform(a, p, digits=digits) + near("force", abs(a.force("c")[1]), 2 * p, digits=digits)
        return off + near("top", a.displacement()[1], -p * soft, digits=digits) + sound(a, digits=digits)

    return f"{name} {load} {slave} Q{degree}", [scene(text, degree=degree, **files)], check


def patch(r):
    """Any two materials, heights and meshes."""
    return pressed(r, *two_blocks(r))


def thin(r):
    """Blocks of 2 x 0.002 to 2 x 0.02: cells up to 1000 times as long as high, or high as long."""
    return pressed(r, *two_blocks(r, -3.0, -2.0, 1e6))


def distorted(r):
    """Blocks of irregular quadrilaterals, up to nearly triangular ones."""
    (n1, n2), (E, nu), h = r.choice([(2, 3), (3, 3), (5, 4), (2, 9), (8, 3)]), materials(r), (1.0, power(r, -0.5, 0.5))
    by, text, files = r.choice([0.1, 0.2, 0.3, 0.4]), "", {}
    for name, n, E_, nu_, low, high in ("upper", n1, E[0], nu[0], 0.0, h[0]), ("lower", n2, E[1], nu[1], -h[1], 0.0):
        moves = {(i, j): (r.uniform(-by, by), r.uniform(-by, by)) for i in range(n + 1) for j in range(5)}
        files[name + ".msh"] = quadrilaterals((0.0, low), (2.0, high), (n, 4), lambda i, j, moves=moves: moves[i, j])
        text += section(f"Body {name}", Mesh=name + ".msh", Young_modulus=E_, Poisson_ratio=nu_)
    return pressed(r, text, f"{n1}to{n2} by{by} E1:{E[1] / E[0]:g} nu{nu[0]}and{nu[1]} h{h[1]:g}", h, E, nu, files=files)


def patch_friction(r):
    """Two blocks under pressure and shear in uniform stress: the shear traction is f mu p while all sticks, mu p once dragged on."""
    text, name, h, E, nu = two_blocks(r)
    mu, increments, slave = r.choice(MU), r.choice([1, 2, 5, 16]), r.choice(SLAVES)
    f = r.choice([0.1, 0.9, 0.999, 1.0 if mu <= 0.6 else 0.5])  # 1: dragged on, past the limit
    p = float("%.6g" % (1e-4 * min(E) / max(1, mu)))
    delta, shear = compliance(h, E, nu, confined_modulus) * p, compliance(h, E, nu, shear_modulus) * mu * p
    history = r.choice(["table(0.5: 0, 1: 1)", "table(0.5: 0, 0.75: -1, 1: 1)"]) if f < 1 else "table(0.5: 0, 0.9: 0.999, 1: 1)"
    way = f"{f * shear!r}*{history}" if f < 1 else f"{shear!r}*table(0.5: 0, 0.9: 0.999, 1: 1.2)"
    text += condition("upper/top", "displacement", f"{way}; {-delta!r}*table(0: 0, 0.5: 1)") + condition("lower/bottom", "displacement", "0; 0")
    q = f * mu * p
    text += condition("upper/right, lower/right", "traction", f"0; {q!r}*{history}") + condition("upper/left, lower/left", "traction", f"0; {-q!r}*{history}")
    for body, v in zip(("upper", "lower"), nu):
        text += condition(f"{body}/left, {body}/right", "pressure", f"{v / (1 - v) * p!r}*table(0: 0, 0.5: 1)")
    text += contact("upper/bottom", "lower/top", Slave=slave, **friction(mu))
    digits = digits_left(E, nu)

    def check(answers):
        (a,) = answers
        x, y, _ = a.force()
        off = uniform(a, p, digits=digits) + near("pressing", abs(y), 2 * p, digits=digits) + sound(a, mu, digits=digits)
        return off + near("shear", abs(x), 2 * q, 2 * p * max(mu, 1), digits)

    name += f" mu{mu} f{f} {'reversed' if '-1' in history else 'straight'} {increments}inc {slave}"
    return name, [scene(text, Increments=increments)], check


def interference(r):
    """Two confined blocks with an overlap or a gap (declared, or of the meshes), one of them moved: a uniform pressure, or none."""
    (n1, n2), (E, nu) = faces(r), materials(r)
    h = power(r, -1, 0.5), power(r, -1, 0.5)
    soft = compliance(h, E, nu, confined_modulus)
    full = float("%.6g" % (1e-3 * min(E)))
    unit = full * soft
    gap, move = unit * r.choice([-1, -1e-6, 0, 0.5, 1, 10]), unit * r.choice([0, 0.5, 1, 1.5])
    meshes = gap > 0 and r.random() < 0.5
    slave, mu = r.choice(SLAVES), r.choice([0, 0, 0.3, 10])
    y = gap if meshes else 0.0
    text = block("upper", (0, y), (2, y + h[0]), (n1, 2), E[0], nu[0]) + block("lower", (0, -h[1]), (2, 0), (n2, 2), E[1], nu[1])
    text += condition("upper/top", "displacement", f"free; {-move!r}*t")
    text += condition("upper/left, lower/left, upper/right, lower/right, lower/bottom", "symmetry")
    more = {} if meshes else {"Initial_gap": f"{gap!r}*t" if gap < 0 else gap}
    text += contact("upper/bottom", "lower/top", Slave=slave, **friction(mu), **more)
    p, digits = max(move - gap, 0) / soft, max(digits_left(E, nu), 1e-14 / unit if meshes else 0)

    def check(answers):
        (a,) = answers
        off = near("force", abs(a.force()[1]), 2 * p, 2 * full, digits) + near("shear", a.force()[0], 0, 2 * full, digits)
        return off + (uniform(a, p, digits=digits) + sound(a, mu, digits=digits) if p > 1e-2 * full else [])

    name = f"{n1}to{n2} E1:{E[1] / E[0]:g} nu{nu[0]}and{nu[1]} gap{gap / unit:g}{'meshed' if meshes else ''} move{move / unit:g} mu{mu} {slave}"
    return name, [scene(text)], check


def column(r):
    """A confined pile of blocks that nothing but contact holds, under gravity: each joint carries the weight above it."""
    count = r.choice([2, 3, 4])
    heights, (E, nu) = [power(r, -1, 0.3) for _ in range(count)], materials(r, count)
    mu, slave, degree = r.choice([0, 0, 0.1, 1]), r.choice(SLAVES), r.choice([1, 2])
    density = float("%.4g" % (1e-3 * min(E) / sum(heights)))
    text, y = plane("floor", (0, 0), (0, 1)), 0.0
    for k in range(count):
        text += block(f"b{k}", (0, y), (1.5, y + heights[k]), (r.choice([1, 2, 3, 5, 8, 20]), 2), E[k], nu[k], Body_force=f"0; {-density!r}*t")
        below = "floor" if k == 0 else f"b{k - 1}/top"
        text += contact(f"b{k}/bottom", below, name=f"j{k}", Slave=slave if k else "automatic", **friction(mu))
        text += condition(f"b{k}/left, b{k}/right", "symmetry")
        y += heights[k]
    digits = digits_left(E, nu)

    def check(answers):
        (a,) = answers
        weights = [1.5 * density * sum(heights[k:]) for k in range(count)]
        off = [text for k in range(count) for text in near(f"joint {k}", abs(a.force(f"j{k}")[1]), weights[k], digits=digits)]
        return off + sound(a, mu, digits=digits)

    return f"{count} E{','.join('%g' % v for v in E)} nu{','.join(str(v) for v in nu)} mu{mu} {slave} Q{degree}", [scene(text, degree=degree)], check


def brought(r):
    """Two confined blocks with gaps below them, pressed by a force: nothing holds them until all has come to touch."""
    (n1, n2), (E, nu) = faces(r), materials(r, most=1e5)
    gaps, mu = [r.choice([0.0, 1e-6, 0.01, 0.01, 1.0]) for _ in range(2)], r.choice([0, 0.3])
    kind = r.choice(["small strain", "small strain", "finite strain"])
    p, y1 = float("%.6g" % (1e-4 * min(E))), gaps[0] + 1 + gaps[1]
    load, slave = r.choice(["traction", "platen", "obstacle"]), r.choice(SLAVES)
    text = plane("floor", (0, 0), (0, 1)) + block("lower", (0, gaps[0]), (2, gaps[0] + 1), (n1, 2), E[0], nu[0])
    text += block("upper", (0, y1), (2, y1 + 1), (n2, 2), E[1], nu[1]) + condition("lower/left, lower/right, upper/left, upper/right", "symmetry")
    text += contact("lower/bottom", "floor", name="floor", **friction(mu)) + contact("upper/bottom", "lower/top", Slave=slave, **friction(mu))
    text += {
        "traction": condition("upper/top", "traction", f"0; {-p!r}*t"),
        "platen": condition("upper/top", "platen", Displacement="0; free", Force=f"0; {-2 * p!r}*t"),
        "obstacle": plane("press", (1, y1 + 1), (0, -1), Force=f"0; {-2 * p!r}*t") + contact("upper/top", "press", name="press"),
    }[load]
    digits = max(digits_left(E, nu), 1e-3 if kind == "finite strain" else 1e-4)  # of displacements 1e4 times as large as strains need

    def check(answers):
        (a,) = answers
        off = near("floor", a.force("floor")[1], 2 * p, digits=digits) + near("joint", abs(a.force("c")[1]), 2 * p, digits=digits)
        return off + uniform(a, p, digits=digits) + sound(a, mu, digits=digits)

    name = f"{n1}to{n2} E1:{E[1] / E[0]:g} nu{nu[0]}and{nu[1]} gaps{gaps[0]:g}and{gaps[1]:g} mu{mu} {load} {slave}"
    return f"{name} {kind}", [scene(text, Kinematics=kind)], check


def tied_pile(r):
    """Three confined blocks, joints tied or not, shortened or pulled apart: uniform pressure or tension, or nothing where an untied joint opens."""
    (E, nu), h = materials(r, 3), [power(r, -0.5, 0.3) for _ in range(3)]
    tied, sign = r.choice([(1, 1), (1, 0), (0, 1)]), r.choice([-1, 1])
    p = sign * float("%.6g" % (1e-3 * min(E)))
    move, mu, text, y = -p * compliance(h, E, nu, confined_modulus), r.choice([0, 0.3]), "", 0.0
    for k in range(3):
        text += block(f"b{k}", (0, y), (2, y + h[k]), (r.choice([1, 2, 3, 7, 30]), 2), E[k], nu[k]) + condition(f"b{k}/left, b{k}/right", "symmetry")
        y += h[k]
    slaves = [r.choice(SLAVES), r.choice(SLAVES)]
    for k in range(2):
        more = {"Tied": "true"} if tied[k] else friction(mu)
        text += contact(f"b{k + 1}/bottom", f"b{k}/top", name=f"j{k}", Slave=slaves[k], **more)
    text += condition("b0/bottom", "symmetry") + condition("b2/top", "displacement", f"free; {move!r}*t")
    digits, expected = digits_left(E, nu), p if p > 0 or all(tied) else 0

    def check(answers):
        (a,) = answers
        top = [reaction["force"][1] for reaction in a.summary["reactions"] if reaction["boundary"] == "b2/top"]
        off = near("top", top, [-2 * expected], 2 * abs(p), digits)
        return off + sound(a, {f"j{k}": None if tied[k] else mu for k in range(2)}, digits=digits)

    name = f"tied{tied[0]}{tied[1]} {'pressed' if p > 0 else 'pulled'} E{','.join('%g' % v for v in E)} nu{','.join(str(v) for v in nu)}"
    return f"{name} mu{mu} {'and'.join(slaves)}", [scene(text)], check


def shortened(r, bodies, joints, edges):
    """Blocks of one material under an affine displacement, the joints tied, rough or smooth: the stress is uniform, and nothing slides."""
    E, nu = 1000.0, r.choice(NU)
    ex, ey = (1 - 2 * nu) * 1e-3 * r.choice([0.1, 1, 1]), (1 - 2 * nu) * 1e-3 * r.choice([0.1, 1])
    first, second = E / ((1 + nu) * (1 - 2 * nu)) * (1 - nu), E / ((1 + nu) * (1 - 2 * nu)) * nu
    px, py = first * ex + second * ey, first * ey + second * ex
    text, name, mu = "", "", {}
    for body, (low, high) in bodies.items():
        text += block(body, low, high, (r.choice([1, 2, 3, 5, 10]), r.choice([1, 2, 3, 5])), E, nu)
    for joint, sides in joints.items():
        kind, slave = r.choice(["smooth", "smooth", "rough", "tied"]), r.choice(SLAVES)
        mu[joint] = {"smooth": 0, "rough": 0.3, "tied": None}[kind]
        text += contact(*sides, name=joint, Slave=slave, **({"Tied": "true"} if kind == "tied" else friction(mu[joint])))
        name += f"{joint}-{kind}-{slave} "
    moves = {"top": f"free; {-2 * ey!r}*t", "bottom": "free; 0", "left": f"{2 * ex!r}*t; free", "right": "0; free"}
    for side, boundaries in edges.items():
        text += condition(boundaries, "displacement", moves[side])

    def check(answers):
        (a,) = answers
        off = sound(a, mu)
        for side, d, value in ("top", 1, -2 * py), ("bottom", 1, 2 * py), ("left", 0, 2 * px), ("right", 0, -2 * px):
            forces = [reaction["force"][d] for reaction in a.summary["reactions"] if reaction["boundary"] in edges[side]]
            off += near(side, sum(forces), value, 2 * max(px, py))
        return off

    return f"{name}nu{nu} ex{ex:g} ey{ey:g}", [scene(text)], check


def cross(r):
    """Four blocks at a point, where nodes lie on two surfaces each."""
    bodies = {name: ((x, y), (x + 1, y + 1)) for name, x, y in (("a", 0, 0), ("b", 1, 0), ("c", 0, -1), ("d", 1, -1))}
    joints = {"u": ("a/right", "b/left"), "l": ("c/right", "d/left"), "m": ("a/bottom", "c/top"), "n": ("b/bottom", "d/top")}
    return shortened(r, bodies, joints, {"top": "a/top, b/top", "bottom": "c/bottom, d/bottom", "left": "a/left, c/left", "right": "b/right, d/right"})


def tee(r):
    """Two blocks side by side on a third."""
    bodies = {"a": ((0, 0), (1, 1)), "b": ((1, 0), (2, 1)), "c": ((0, -1), (2, 0))}
    joints = {"u": ("a/right", "b/left"), "m": ("a/bottom", "c/top"), "n": ("b/bottom", "c/top")}
    return shortened(r, bodies, joints, {"top": "a/top, b/top", "bottom": "c/bottom", "left": "a/left, c/left", "right": "b/right, c/right"})


def patch_3d(r):
    """Two boxes, free at two sides: uniform pressure."""
    (E, nu), h = materials(r), (power(r, -0.5, 0.3), power(r, -0.5, 0.3))
    n1, n2 = r.choice([((2, 2, 1), (3, 3, 1)), ((1, 1, 1), (4, 3, 1)), ((1, 2, 2), (3, 1, 1)), ((4, 4, 1), (1, 1, 2)), ((1, 6, 1), (6, 1, 1))])
    slave, degree, mu = r.choice(SLAVES), r.choice([1, 2]), 0
    text = block("upper", (0, 0, 0), (2, 1.5, h[0]), n1, E[0], nu[0]) + block("lower", (0, 0, -h[1]), (2, 1.5, 0), n2, E[1], nu[1])
    p = float("%.6g" % (1e-3 * min(E)))
    soft = sum(a / b for a, b in zip(h, E))
    load = r.choice(["displacement", "pressure"])
    text += condition("upper/top", load, f"free; free; {-p * soft!r}" if load == "displacement" else p) + condition("lower/bottom", "symmetry")
    text += condition("upper/left, lower/left, upper/front, lower/front", "symmetry") + contact("upper/bottom", "lower/top", Slave=slave)
    digits = digits_left(E, nu)

    def check(answers):
        (a,) = answers
        return uniform(a, p, digits=digits) + near("force", abs(a.force()[2]), 3 * p, digits=digits) + sound(a, mu, digits=digits)

    name = f"{n1}to{n2} E1:{E[1] / E[0]:g} nu{nu[0]}and{nu[1]} {load} {slave} Q{degree}"
    return name.replace(", ", "x"), [scene(text, Kind="3D", degree=degree)], check


def cylinders(r):
    """Two cylinders (or tubes) end on end, free outside, in an axisymmetric scene: uniform pressure."""
    text, name, h, E, nu = two_blocks(r)
    inner, slave = r.choice([0.0, 0.0, 3.0]), r.choice(SLAVES)
    text = text.replace("corner = 0, ", f"corner = {inner!r}, ").replace("corner = 2, ", f"corner = {inner + 2!r}, ")
    p = float("%.6g" % (1e-3 * min(E)))
    soft = sum(a / b for a, b in zip(h, E))
    load = r.choice(["displacement", "pressure"])
    text += condition("upper/top", load, f"free; {-p * soft!r}" if load == "displacement" else p) + condition("lower/bottom", "symmetry")
    text += contact("upper/bottom", "lower/top", Slave=slave)
    digits, area = digits_left(E, nu), math.pi * ((inner + 2) ** 2 - inner**2)

    def check(answers):
        (a,) = answers
        return uniform(a, p, digits=digits) + near("force", abs(a.force()[1]), area * p, digits=digits) + sound(a, digits=digits)

    return f"{name} inner{inner:g} {load} {slave}", [scene(text, Kind="axisymmetric")], check


def fit_pressure(delta, a, b, c, E, nu, plane_stress=False):
    """Lame: tubes a..b in b..c with the interference delta."""
    if plane_stress:
        outer, inner = (b * b + c * c) / (c * c - b * b) + nu[1], (b * b + a * a) / (b * b - a * a) - nu[0]
    else:
        outer = (1 + nu[1]) * ((1 - 2 * nu[1]) * b * b + c * c) / (c * c - b * b)
        inner = (1 + nu[0]) * ((1 - 2 * nu[0]) * b * b + a * a) / (b * b - a * a)
    return delta / b / (outer / E[1] + inner / E[0])


def shrink(r):
    """A tube or shaft in a tube (axisymmetric, long) with interference, or a gap that nothing closes: Lame's pressure, to what six cells give."""
    (E, nu), b = materials(r), 2.0
    a, c = r.choice([0.0, 1.0, 1.5]), r.choice([2.5, 3.0, 4.0])
    n1, n2 = faces(r)
    mu, slave, delta = r.choice([0, 0, 0.3]), r.choice(SLAVES), 1e-3 * r.choice([1, 1, 0.01, -1])
    text = block("inner", (a, 0), (b, 2), (6, n1), E[0], nu[0]) + block("outer", (b, 0), (c, 2), (6, n2), E[1], nu[1])
    text += condition("inner/bottom, outer/bottom, inner/top, outer/top", "symmetry")
    text += contact("inner/right", "outer/left", Slave=slave, Initial_gap=f"{-delta!r}*t" if delta > 0 else -delta, **friction(mu))
    p = fit_pressure(max(delta, 0), a, b, c, E, nu)

    def check(answers):
        (answer,) = answers
        return uniform(answer, p, digits=5e-3) + sound(answer, mu, digits=5e-3) if p else near("force", answer.force(), [0, 0, 0], 1e-300)

    name = f"{a:g}-{b:g}-{c:g} {n1}to{n2} E1:{E[1] / E[0]:g} nu{nu[0]}and{nu[1]} delta{delta:g} mu{mu} {slave}"
    return name, [scene(text, Kind="axisymmetric")], check


def rings(r):
    """The same in the plane, with curved surfaces."""
    (E, nu), kind = materials(r), r.choice(["plane strain", "plane stress"])
    a, c = r.choice([1.0, 1.4]), r.choice([2.6, 3.0, 4.0])
    n1, n2, mu, slave, delta = r.choice([2, 3]), r.choice([2, 3]), r.choice([0, 0, 0.3]), r.choice(SLAVES), 1e-3 * r.choice([1, 0.01])
    text = ring("inner", a, 2.0, n1, E[0], nu[0]) + ring("outer", 2.0, c, n2, E[1], nu[1])
    text += condition("inner/cut x, inner/cut y, outer/cut x, outer/cut y", "symmetry")
    text += contact("inner/outer", "outer/inner", Slave=slave, Initial_gap=f"{-delta!r}*t", **friction(mu))
    p = fit_pressure(delta, a, 2.0, c, E, nu, kind == "plane stress")

    def check(answers):
        (answer,) = answers
        force = [abs(v) for v in answer.force()[:2]]
        return uniform(answer, p, digits=2e-2) + near("force", force, [2 * p, 2 * p], digits=1e-2) + sound(answer, mu, digits=1e-2)

    return f"{kind} {a:g}-2-{c:g} {n1}to{n2} E1:{E[1] / E[0]:g} nu{nu[0]}and{nu[1]} delta{delta:g} mu{mu} {slave}", [scene(text, Kind=kind)], check


def finite_patch(r):
    """Two confined neo-Hookean blocks at finite strain, shortened by up to a half: with M = K + 4/3 G, p = M/2 (1/s - s), and the heights add up."""
    (n1, n2), (E, nu) = faces(r), ([1000.0, 1000 * 10.0 ** r.choice([-6, -3, -1, 0, 1, 3, 6])], [r.choice(NU[:5]), r.choice(NU[:5])])
    h, short, increments, slave = (1.0, power(r, -0.5, 0.5)), r.choice([1e-4, 0.01, 0.1, 0.3, 0.5]), r.choice([1, 2, 5]), r.choice(SLAVES)
    M, mu = [confined_modulus(*v) for v in zip(E, nu)], r.choice([0, 0, 0.3])
    delta = float("%.6g" % (short * min(h)))

    def height(p):
        return sum(a * (math.hypot(p / m, 1) - p / m) for a, m in zip(h, M))

    low, high = 0.0, 1e12
    for _ in range(200):
        p = (low + high) / 2
        low, high = (p, high) if height(p) > sum(h) - delta else (low, p)
    text = block("upper", (0, 0), (2, h[0]), (n1, 2), E[0], nu[0]) + block("lower", (0, -h[1]), (2, 0), (n2, 2), E[1], nu[1])
    text += condition("upper/top", "displacement", f"free; {-delta!r}*t")
    text += condition("upper/left, lower/left, upper/right, lower/right, lower/bottom", "symmetry")
    text += contact("upper/bottom", "lower/top", Slave=slave, **friction(mu))

    def check(answers):
        (a,) = answers
        return uniform(a, p, digits=1e-4) + near("force", abs(a.force()[1]), 2 * p, digits=1e-4) + sound(a, mu)

    name = f"{n1}to{n2} E1:{E[1] / E[0]:g} nu{nu[0]}and{nu[1]} h{h[1]:g} by{short:g} mu{mu} {increments}inc {slave}"
    return name, [scene(text, Kinematics="finite strain", Increments=increments)], check


def hertz(r):
    """A rigid circle on a block, or a half disk on a rigid plane: Hertz's half-width to 6 % (15 % with friction), and the force exactly. Half models."""
    E, nu, mu = 10.0 ** r.choice([-3, 3, 8]), r.choice(NU[:6]), r.choice([0, 0, 0.1, 1])
    a, finer = r.choice([(1.0, 3), (1.0, 4), (0.5, 4), (0.5, 5)])
    force = math.pi * plane_modulus(E, nu) * a * a / (4 * 10.0) / 2  # of the half model, R = 10
    if r.random() < 0.6:
        shape = "circle"
        text = block("body", (0, -20), (20, 0), (4, 4), E, nu) + condition("body/bottom", "displacement", "0; 0") + condition("body/left", "symmetry")
        text += section("Obstacle tool", Surface="circle", Centre=(0, 10), Radius=10, Force=f"0; {-force!r}*t") + contact("body/top", "tool", **friction(mu))
    else:
        shape = "disk"
        text = section("Body body", Mesh="quarter disk", Centre=(0, 10), Radius=10, Young_modulus=E, Poisson_ratio=nu, Refinements=1)
        text += condition("body/cut", "total force", f"0; {-force!r}*t") + condition("body/axis", "symmetry") + plane("tool", (0, 0), (0, 1))
        text += contact("body/arc", "tool", **friction(mu))

    def check(answers):
        (answer,) = answers
        width = near("half-width", answer.summary["pairs"][0]["contact_size"], a, digits=0.15 if mu else 0.06)
        return near("force", abs(answer.force()[1]), force) + width + sound(answer, mu)

    return f"{shape} E{E:g} nu{nu} mu{mu} a{a:g} finer{finer}", [scene(text, refinements=finer)], check
