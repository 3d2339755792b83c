"""Points of the failure atlas (atlas.py) that nothing but contact and friction holds, and those where these cannot: statics of rigid bodies says which.

Families whose names end in `_over` have no equilibrium: their check is None.
"""
import math

from atlas_parts import MU, NU, SLAVES, block, condition, contact, friction, near, plane, probe, scene, sound


def slab(r, over=False):
    """A slab, pressed and pushed: the floor carries both forces. Beyond mu N nothing holds it."""
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


def slab_3d(r, over=False):
    """The same in space, pushed at any angle."""
    mu, angle, increments = r.choice(MU), r.uniform(0, 2 * math.pi), r.choice([1, 4])
    f = r.choice([1.05, 2]) if over else r.choice([0.3, 0.9])
    h = min(1.0, 0.4 / mu)
    n, m, nu, degree = r.choice([1, 2, 3]), r.choice([1, 2, 3]), r.choice(NU), r.choice([1, 2])
    p = 0.1 / max(1, mu)
    qx, qy = f * mu * p * math.cos(angle), f * mu * p * math.sin(angle)
    text = plane("floor", (0, 0, 0), (0, 0, 1)) + block("slab", (0, 0, 0), (2, 2, h), (n, m, 1), 1000.0, nu)
    text += condition("slab/top", "traction", f"{qx!r}*table(0.5: 0, 1: 1); {qy!r}*table(0.5: 0, 1: 1); {-p!r}*table(0: 0, 0.5: 1)")
    text += contact("slab/bottom", "floor", **friction(mu))

    def check(answers):
        (a,) = answers
        return near("forces", a.force(), [-4 * qx, -4 * qy, 4 * p], 4 * p * max(mu, 1)) + sound(a, mu)

    name = f"mu{mu} f{f} {math.degrees(angle):.0f}deg {n}x{m} nu{nu} Q{degree} {increments}inc"
    return name, [scene(text, Kind="3D", degree=degree, Increments=increments)], None if over else check


def slab_3d_over(r):
    return slab_3d(r, over=True)


def incline(r, over=False):
    """A block on a slope: stays if the slope is below mu."""
    mu, nu, increments = r.choice(MU), r.choice(NU), r.choice([1, 2, 8])
    f = r.choice([1.05, 1.5, 5]) if over else r.choice([0.1, 0.7, 0.95])
    slope = math.atan(f * mu)
    h, n, m = min(1.0, 0.5 / math.tan(slope)), r.choice([1, 4, 8, 16]), r.choice([1, 3])
    W = 2 * h * 1.0
    text = block("block", (0, 0), (2, h), (n, m), 1e5, nu, Rotate=math.degrees(slope), Body_force="0; -t")
    on = r.choice(["obstacle", "body"])
    if on == "obstacle":
        text += plane("floor", (0, 0), (-math.sin(slope), math.cos(slope))) + contact("block/bottom", "floor", **friction(mu))
    else:
        text += block("floor", (-1, -1), (3, 0), (r.choice([2, 5, 12]), 1), 1e5, r.choice(NU), Rotate=math.degrees(slope))
        text += condition("floor/bottom", "displacement", "0; 0") + contact("block/bottom", "floor/top", Slave="first", **friction(mu))

    def check(answers):
        (a,) = answers
        return near("weight", a.force(), [0, W, 0], W) + sound(a, mu)

    return f"mu{mu} f{f} {on} {n}x{m} nu{nu} {increments}inc", [scene(text, Increments=increments)], None if over else check


def incline_over(r):
    return incline(r, over=True)


def tipping(r, over=False):
    """A block on a shorter support, its weight to the left or right of it: stands, or tips over and nothing holds it."""
    centre = r.choice([1.05, 1.2, 1.9] if over else [0, 0.5, 0.8, 0.9]) * r.choice([-1, 1])
    n, m, nu, mu = r.choice([3, 6, 10]), r.choice([1, 3]), r.choice(NU[:6]), r.choice([0.1, 0.6, 3])
    E, slave = 1e6, r.choice(SLAVES)
    text = block("block", (centre - 1.5, 0), (centre + 1.5, 1), (n, m), E, nu, Body_force="0; -20*t")
    text += block("base", (-1, -1), (1, 0), (r.choice([2, 5, 9]), 2), E, 0.3) + condition("base/bottom", "displacement", "0; 0")
    text += contact("block/bottom", "base/top", Slave=slave, **friction(mu))

    def check(answers):
        (a,) = answers
        sign = -1 if a.force()[1] < 0 else 1  # the slave may be the base
        off = near("weight", [sign * v for v in a.force()], [0, 60, 0], 60) + near("moment", sign * a.moment(), 60 * centre, 60)
        return off + sound(a, mu, applied=(0, -60), moment=-60 * centre)

    return f"at{centre:g} {n}x{m} nu{nu} mu{mu} {slave}", [scene(text, Increments=r.choice([1, 4]))], None if over else check


def tipping_over(r):
    return tipping(r, over=True)


def pulled_over(r):
    """A block that lies on something and is pulled away, or dragged flatter than friction holds."""
    angle, mu = r.choice([(90, 0), (90, 1), (90, 10), (60, 0.1), (120, 1), (89, 10), (-60, 0.1), (-60, 0), (-89, 0)])
    x, y, nu, n = math.cos(math.radians(angle)), math.sin(math.radians(angle)), r.choice(NU), r.choice([1, 4, 9])
    by, on, kinematics = r.choice(["body force", "total force"]), r.choice(["obstacle", "body"]), r.choice(["small strain", "finite strain"])
    more = {"Body_force": f"{x!r}*t; {y!r}*t"} if by == "body force" else {}
    text = block("block", (0, 0), (2, 1), (n, 2), 1000.0, nu, **more)
    text += "" if more else condition("block/top", "total force", f"{x!r}*t; {y!r}*t")
    if on == "body":
        text += block("base", (-1, -1), (3, 0), (5, 2)) + condition("base/bottom", "displacement", "0; 0") + contact("block/bottom", "base/top", **friction(mu))
    else:
        text += plane("floor", (0, 0), (0, 1)) + contact("block/bottom", "floor", **friction(mu))
    return f"{on} {by} {angle}deg mu{mu} nu{nu} {n} {kinematics}", [scene(text, Kinematics=kinematics)], None


def groove(r):
    """A turned block in a groove of two planes at right angles: where smooth they carry W cos and W sin, and always all of W. Its corner is in both pairs."""
    angle, mu, nu = r.choice([1, 10, 30, 45, 60, 80]), r.choice([0, 0, 0, 0.1, 0.5, 3]), r.choice(NU)
    n, m, c, s = r.choice([1, 3, 8]), r.choice([1, 3, 8]), math.cos(math.radians(angle)), math.sin(math.radians(angle))
    text = block("block", (0, 0), (1, 1), (n, m), 1e4, nu, Rotate=angle, Body_force="0; -t")
    text += plane("floor", (0, 0), (-s, c)) + plane("wall", (0, 0), (c, s))
    text += contact("block/bottom", "floor", name="floor", **friction(mu)) + contact("block/left", "wall", name="wall", **friction(mu))

    def check(answers):
        (a,) = answers
        off = near("weight", a.force(), [0, 1, 0], 1) + sound(a, mu)
        if not mu:
            off += near("floor", math.hypot(*a.force("floor")), c, 1) + near("wall", math.hypot(*a.force("wall")), s, 1)
        return off

    return f"{angle}deg mu{mu} {n}x{m} nu{nu}", [scene(text)], check


def corner_3d(r):
    """A box in the corner of three planes, its weight slanted: each smooth plane carries its component."""
    load, nu, degree = [float("%.3g" % r.uniform(0.1, 1)) for _ in range(3)], r.choice(NU), r.choice([1, 2])
    n = [r.choice([1, 2, 3]) for _ in range(3)]
    text = block("box", (0, 0, 0), (1, 1, 1), n, 1e4, nu, Body_force="; ".join(f"{-v!r}*t" for v in load))
    for d, (side, normal) in enumerate((("left", (1, 0, 0)), ("front", (0, 1, 0)), ("bottom", (0, 0, 1)))):
        text += plane(f"p{d}", (0, 0, 0), normal) + contact(f"box/{side}", f"p{d}", name=f"c{d}")

    def check(answers):
        (a,) = answers
        return [text for d in range(3) for text in near(f"plane {d}", math.hypot(*a.force(f"c{d}")), load[d], 1)] + near("all", a.force(), load, 1) + sound(a)

    return f"{'x'.join(str(v) for v in n)} nu{nu} Q{degree} {load}".replace(", ", "and"), [scene(text, Kind="3D", degree=degree)], check


def bar(r, over=False):
    """A bar on a rough base (strength tau), pulled at its end, back, and again: u = F^2/(2 EA tau) on first loading; beyond tau L nothing holds it."""
    tau, n, kind = r.choice([0.5, 1, 2]), r.choice([20, 40]), r.choice(["Tresca", "Coulomb"])
    pull = tau * 20 * (r.choice([1.05, 2]) if over else r.choice([0.2, 0.5, 0.9]))
    steps = r.choice([1, 4])
    cycle = r.choice(["first", "reversed"])
    program = "table(0: 0, 0.5: 0, 1: 1)" if cycle == "first" else "table(0: 0, 0.5: 0, 0.65: 1, 0.85: -1, 1: 1)"
    text = block("bar", (0, 0), (20, 0.2), (n, 1), 5000.0, 0) + plane("base", (0, 0), (0, 1))
    text += condition("bar/top", "pressure", "100*table(0: 0, 0.5: 1)") + condition("bar/right", "total force", f"{pull!r}*{program}; 0")
    text += contact("bar/bottom", "base", **({"Tresca_bound": tau} if kind == "Tresca" else friction(tau / 100))) + probe("bar", (20, 0.1))

    def check(answers):
        (a,) = answers
        end = pull**2 / (2 * 1000 * tau)
        bound = {"bound": 1.01 * tau, "mu": math.inf} if kind == "Tresca" else {"mu": tau / 100}
        return near("pull", a.force(), [-pull, 2000, 0], 2000) + near("end", a.displacement()[0], end, digits=5e-2) + sound(a, **bound)

    return f"tau{tau} F{pull:g} {n} {kind} {cycle} {steps}", [scene(text, Kind="plane stress", Increments=4 * steps)], None if over else check


def bar_over(r):
    return bar(r, over=True)


def dragged(r):
    """At finite strain, a block under a platen with a force is dragged along a plane or a longer block: all of it slides, and the shear force is mu N."""
    mu, nu, steps, on = r.choice([0.01, 0.1, 0.3, 0.6]), r.choice(NU[:6]), r.choice([5, 12]), r.choice(["obstacle", "body"])
    n, m, way, push = r.choice([2, 4, 7]), r.choice([1, 2]), r.choice([0.3, 1.5]) * r.choice([-1, 1]), 5.0
    text = block("block", (0, 0), (2, 1), (n, m), 1e4, nu)
    text += condition("block/top", "platen", Displacement=f"{way!r}*table(0.3: 0, 1: 1); free", Force=f"0; {-push!r}*table(0: 0, 0.3: 1)")
    if on == "obstacle":
        text += plane("base", (0, 0), (0, 1)) + contact("block/bottom", "base", **friction(mu))
    else:
        text += block("base", (-2, -1), (4, 0), (r.choice([5, 9]), 2), 1e4, nu) + condition("base/bottom", "displacement", "0; 0")
        text += contact("block/bottom", "base/top", Slave="first", **friction(mu))

    def check(answers):
        (a,) = answers
        exact = on == "obstacle"  # between bodies the normals are not quite upright
        off = near("forces", a.force(), [-math.copysign(mu * push, way), push, 0], push, 1e-5 if exact else 1e-2)
        return off + near("pressing", a.force()[1], push) + sound(a, mu)

    return f"{on} mu{mu} nu{nu} {n}x{m} by{way:g} {steps}inc", [scene(text, Kinematics="finite strain", Increments=steps)], check
