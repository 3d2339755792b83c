"""Cases of the scorecard (scorecard.py) without friction: round bodies and punches."""
import math

import scorecard_formulas as formulas
from scorecard_parts import Row, case, digits, section

ROUND, PUNCHES = "Round bodies without friction", "Punches without friction"
BLOCK = "finite block"
CIRCLE = "circle for parabola"
STEEL, ALUMINIUM = (210e3, 0.3), (70e3, 0.33)


def hertz(answer, a, p0, floors, origin, scale=1, dimension=2):
    """Size, peak and profile of a Hertz contact; floors: of a, of p0."""
    size, estimate, told = answer.size(), answer.estimate(), answer.pair()
    force = scale * answer.force()
    peak = 2 * force / (math.pi * size) if dimension == 2 else 3 * force / (2 * math.pi * size**2)
    name = "half-width a" if dimension == 2 else "radius a"
    rows = [
        Row(name, a, size, floors[0], origin, estimate),
        Row(name + ", of the integral", a, told["contact_size"], floors[0], origin, estimate),
        Row("p0 of force and a", p0, peak, floors[1], origin, estimate),
        Row("largest nodal pressure", p0, told["peak_pressure"], floors[1], origin, estimate),
    ]
    if answer.kind != "3D":
        weight = (lambda x: x) if answer.kind == "axisymmetric" else (lambda x: 1.0)
        off = answer.profile(lambda x: p0 * formulas.ellipse(x, a), 0, 1.3 * a, weight=weight)
    else:
        off = answer.summary["reference"]["errors"]["pressure_l2"]
    return rows + [error_row("pressure, L2 to 1.3 a", off, formulas.ellipse_change(floors[0], dimension == 3), origin, estimate)]


def error_row(quantity, off, floor, origin, estimate, published=""):
    """A norm of a difference: the reference is 0."""
    return Row(quantity, 0.0, off, floor, origin, estimate, published, scale=1.0)


def two_bodies(a, R, bodies, block):
    """Floors of bodies (Young's modulus, Poisson's ratio, radius) that end at their centre: the block's, each with its share of the compliance."""
    soft = [(1 - nu**2) / E for E, nu, _ in bodies]
    return sum(c / sum(soft) * block(a, r) for c, (_, _, r) in zip(soft, bodies)) if block else 0.0


def circles(a, R, radii, part):
    """Fourth-order term of circles of these radii against the parabola of radius R."""
    return part * a**2 * R * sum(r**-3 for r in radii)


@case("1a", "Rigid cylinder on a flat", ROUND, small=True)
def cylinder(run):
    a, p0 = formulas.hertz_line(1000, 10, formulas.modulus(200e3, 0.3))
    answer = run("hertz_cylinder.prm", "Refinement/Cycles=8", text=axis("block", a))
    floor, origin = formulas.block_line(a, 10) + formulas.circle_line(a, 10), f"{BLOCK}, {CIRCLE}"
    rows = hertz(answer, a, p0, (floor, floor), origin, scale=2)
    return rows + largest_shear(answer, a, p0, floor, origin)


def axis(body, a):
    return section("Probe axis", Body=body, From="0, 0", To=f"0, {-1.2 * a}", Points=121)


def largest_shear(answer, a, p0, floor, origin):
    """Below a Hertz line contact; the place by a parabola through three probes."""
    points = next(p for p in answer.summary["probes"] if p["name"] == "axis")["points"]
    shear = [abs(p["stress"]["xx"] - p["stress"]["yy"]) / 2 for p in points]
    k = max(range(1, 120), key=lambda k: shear[k])
    low, peak, high = shear[k - 1 : k + 2]
    z = (k + 0.5 * (low - high) / (low - 2 * peak + high)) * 0.01 * a
    return [
        Row("largest shear stress on the axis", 0.300283 * p0, peak, floor, origin, answer.bulk),
        Row("its depth", 0.78615 * a, z, floor + 0.01 / 0.78615, "step of the probes", answer.bulk),
    ]


@case("1b", "Cylinders of steel and aluminium", ROUND, small=True)
def cylinders(run):
    R = 20 / 3
    a, p0 = formulas.hertz_line(500, R, formulas.modulus(*STEEL, *ALUMINIUM))
    floor = two_bodies(a, R, [(*STEEL, 10), (*ALUMINIUM, 20)], formulas.block_line) + circles(a, R, (10, 20), 3 / 16)
    answer = run("verification/two_cylinders.prm", "Refinement/Cycles=8")
    return hertz(answer, a, p0, (floor, floor), f"{BLOCK} (H = R), {CIRCLE}", scale=2)


@case("1d", "NAFEMS R0094-1, roller on a block", ROUND)
def roller(run):
    answer = run("nafems_roller.prm", "Refinement/Cycles=8")
    a, p0 = formulas.hertz_line(35000, 50, formulas.modulus(210e3, 0.3, 70e3, 0.3))
    floor = two_bodies(a, 50, [(210e3, 0.3, 50), (70e3, 0.3, 100)], formulas.block_line) + formulas.circle_line(a, 50)
    size, estimate = answer.size("roller"), answer.estimate()
    peak = 4 * answer.force("roller") / (math.pi * size)
    return [
        Row("half-width a, half planes", a, size, floor, f"{BLOCK} (H = R and half the width), {CIRCLE}", estimate),
        Row("p0 of force and a, half planes", p0, peak, floor, f"{BLOCK} (H = R and half the width), {CIRCLE}", estimate),
        Row("half-width a, this block", 6.197, size, digits(6.197, 1e-3), "digits", estimate),
        Row("p0 of force and a, this block", 3595.5, peak, digits(3595.5, 0.1), "digits", estimate),
        Row("u_y of the block's top", -1.2812, answer.probe("block top")["displacement"][1], digits(1.2812, 1e-4), "digits", answer.bulk),
        Row("u_y of the cylinder's centre", -1.5686, answer.probe("cylinder centre")["displacement"][1], digits(1.5686, 1e-4), "digits", answer.bulk),
    ]


def approach_row(answer, exact, less, note=""):
    """Approach less what the block takes of it; its coefficient 0.52 has two digits."""
    ours = answer.summary["reference"]["values"]["approach"][0]
    origin = "two digits of the block's 0.52 a/H" + note
    return Row("approach, of such a block", exact - less, ours, 0.01 * less / (exact - less), origin, answer.estimate())


@case("2a", "Rigid sphere on a flat, axisymmetric", ROUND)
def sphere(run):
    return rigid_sphere(run("hertz_sphere_axisymmetric.prm", "Refinement/Cycles=8"), 1, "")


def rigid_sphere(answer, scale, note):
    Es = formulas.modulus(200e3, 0.3)
    a, p0, approach = formulas.hertz_point(1000, 10, Es)
    floors = [floor + part * formulas.circle_point(a, 10) for floor, part in zip(formulas.block_point(a, 10), (1, 2))]
    rows = hertz(answer, a, p0, floors, f"{BLOCK}, {CIRCLE}", scale=scale, dimension=3)
    return rows + [approach_row(answer, approach, formulas.block_approach(1000, Es, 10), note)]


@case("2a 3D", "Rigid sphere on a flat, in space", ROUND)
def sphere_3d(run):
    answer = run("hertz_sphere.prm", "Discretization/Degree=2", "Refinement/Cycles=4")
    return rigid_sphere(answer, 4, " (of a round block; this one is square)")


@case("2b", "Spheres of steel and aluminium", ROUND)
def spheres(run):
    R = 20 / 3
    Es = formulas.modulus(*STEEL, *ALUMINIUM)
    a, p0, approach = formulas.hertz_point(500, R, Es)
    bodies = [(*STEEL, 10), (*ALUMINIUM, 20)]
    floors = [two_bodies(a, R, bodies, lambda a, r, k=k: formulas.block_point(a, r)[k]) + circles(a, R, (10, 20), (k + 1) * 2 / 15) for k in (0, 1)]
    answer = run("two_spheres.prm")
    rows = hertz(answer, a, p0, floors, f"{BLOCK} (H = R), {CIRCLE}", scale=4, dimension=3)
    less = two_bodies(a, R, bodies, lambda a, r: formulas.block_approach(500, Es, r))
    ours = answer.summary["reference"]["values"]["approach"][0]
    return rows + [Row("approach, of half spaces", approach, ours, less / approach, f"{BLOCK} (H = R): 0.52 a/H", answer.estimate())]


@case("2c", "Crossed cylinders", ROUND)
def crossed(run):
    Es = formulas.modulus(*STEEL, *STEEL)
    a, p0, approach = formulas.hertz_point(1000, 10, Es)
    floors = [floor + (k + 1) * formulas.circle_point(a, 10) for k, floor in enumerate(formulas.block_point(a, 10))]
    answer = run("crossed_cylinders.prm")
    rows = hertz(answer, a, p0, floors, f"{BLOCK} (H = R), {CIRCLE}", scale=4, dimension=3)
    less = formulas.block_approach(1000, Es, 10)
    ours = answer.summary["reference"]["values"]["approach"][0]
    return rows + [Row("approach, of half spaces", approach, ours, less / approach, f"{BLOCK} (H = R): 0.52 a/H", answer.estimate())]


# ---- Half planes and half spaces that are cut out: no floor


@case("box", "Half planes, cut out, quadratic elements", ROUND, small=True)
def half_planes(run):
    a, R, E = 1, 50, formulas.modulus(1, 0.3, 1, 0.3)
    P = math.pi * E * a * a / (4 * R)
    answer = run("half_plane_box.prm", "Refinement/Cycles=8", text=axis("lower", a))
    p0, estimate = 2 * P / math.pi, answer.estimate()
    off = answer.profile(lambda x: p0 * formulas.ellipse(x, a), -1.3, 1.3)
    return [
        Row("force P", P, answer.force(), 0, "none", estimate, "1.5e-6 (another code, graded mesh)"),
        Row("half-width a", a, answer.size(), 0, "none", estimate, "6e-6 (another code, graded mesh)"),
        error_row("pressure, L2 to 1.3 a", off, 0, "none", estimate, "1.7e-3 (another code, 96 elements over 1.5 a)"),
    ] + largest_shear(answer, a, p0, 0, "none")


def point_box(answer, scale):
    a, R, Es = 1, 50, formulas.modulus(1, 0.3, 1, 0.3)
    P = 4 * Es * a**3 / (3 * R)
    estimate = answer.estimate()
    return [
        Row("force P", P, scale * answer.force(), 0, "none", estimate),
        Row("radius a", a, answer.size(), 0, "none", estimate),
        error_row("pressure, L2 (by the program)", answer.summary["reference"]["errors"]["pressure_l2"], 0, "none", estimate),
    ]


@case("box axi", "Half spaces, cut out, axisymmetric", ROUND)
def half_spaces(run):
    return point_box(run("verification/half_space_box_axisymmetric.prm", "Refinement/Cycles=8"), 1)


@case("box 3D", "Half spaces, cut out, in space", ROUND)
def half_spaces_3d(run):
    return point_box(run("half_space_box.prm"), 4)


# ---- Punches


@case("3a", "Sharp flat punch, plane", PUNCHES)
def flat_punch(run):
    P, a = 1e4, 10
    answer = run("verification/flat_punch_line.prm", "Refinement/Cycles=10")
    floor, estimate = formulas.block_line(a, 630), answer.bulk  # the square of this pressure has no integral: the program's estimate of it means nothing

    def p(x):
        return P / (math.pi * math.sqrt(a * a - x * x))

    rows = [Row(f"p({x})", p(x), answer.at(x), floor, BLOCK, estimate) for x in (0, 9)]
    return rows + [error_row("pressure, L2 to 0.9 a", answer.profile(p, 0, 0.9 * a), floor, BLOCK, estimate)]


@case("3b", "Sharp flat punch, axisymmetric", PUNCHES)
def round_punch(run):
    a, delta, Es, H = 10, 0.01, formulas.modulus(200e3, 0.3), 10230
    P = 2 * Es * a * delta
    answer = run("verification/flat_punch_axisymmetric.prm", "Refinement/Cycles=10")
    floor, estimate = formulas.block_approach(P, Es, H) / delta, answer.bulk  # as above

    def p(r):
        return P / (2 * math.pi * a * math.sqrt(a * a - r * r))

    return [
        Row("force P", P, answer.force(), floor, BLOCK, estimate),
        error_row("pressure, L2 to 0.9 a", answer.profile(p, 0, 0.9 * a, weight=lambda r: r), floor, BLOCK, estimate),
    ]


@case("3c", "Cone, flank of 5 degrees", PUNCHES)
def cone(run):
    P, slope, Es = 1000, math.tan(math.radians(5)), formulas.modulus(200e3, 0.3)
    delta = math.sqrt(P * math.pi * slope / (2 * Es))
    a = 2 * delta / (math.pi * slope)
    answer = run("verification/cone.prm", "Refinement/Cycles=9")
    size = answer.size() * math.sqrt(3 / 2.5)  # the mean of r^2 under the pressure of a cone is a^2/3, under Hertz's 2/5 a^2
    floor, estimate = formulas.block_point(a, 10), answer.estimate()

    def p(r):
        return 0.5 * Es * slope * math.acosh(max(a / r, 1))

    return [
        Row("radius a", a, size, floor[0], BLOCK, estimate),
        error_row("pressure, L2 to 1.3 a", answer.profile(p, 0, 1.3 * a, weight=lambda r: r), floor[1], BLOCK, estimate),
        approach_row(answer, delta, formulas.block_approach(P, Es, 10)),
    ]
