"""Cases of the scorecard (scorecard.py) without closed form: benchmarks, finite strain, and scenes that other programs have solved.

Numbers of others are those of the project's references.md (digits "computed with independent small codes, mesh-converged") and peers.csv (CalculiX 2.20 and
GetFEM 5.4.2 on one core of a two-core machine), and where it is said, of Code_Aster.
"""
import math

import scorecard_formulas as formulas
from scorecard_cases import BLOCK, CIRCLE, error_row
from scorecard_parts import TOLERANCE, Row, case, digits
from scorecard_uniform import EXACT

BENCHMARKS, FINITE, PEERS = "Benchmarks", "Finite strain", "Scenes of other programs"


def known(quantity, reference, unit, ours, estimate, published=""):
    """A published number: half a unit of its last digit is its floor."""
    return Row(quantity, reference, ours, digits(reference, unit), "digits", estimate, published)


def edge(answer, states, low=-math.inf, pair=None):
    """Place and half distance of the last node in one of these states and the next one."""
    rows = sorted((row for row in answer.nodes(pair) if row["X"] > low), key=lambda row: row["X"])
    k = max(k for k, row in enumerate(rows) if row["state"] in states)
    return (rows[k]["X"] + rows[k + 1]["X"]) / 2, (rows[k + 1]["X"] - rows[k]["X"]) / 2


def edge_row(quantity, reference, unit, place):
    floor = digits(reference, unit) + place[1] / reference
    return Row(quantity, reference, place[0], floor, "digits, half a face")


# ---- Benchmarks


@case("GRECO", "Block on a rigid base, mu = 1 (Raous, Chabrand, Lebon)", BENCHMARKS)
def greco(run):
    answer, many = run("greco.prm"), run("greco.prm", "Increments=5")
    averages = "28.6 27.2 22.8 19.8 15.0".split()
    rows = []
    for k, (x, u) in enumerate(((0, 28.603), (1.25, 27.226), (5, 22.868), (7.5, 19.8075), (11.25, 15.414))):
        ours = 1e3 * answer.probe("base", round(x / 1.25))["displacement"][0]
        rows.append(known(f"u_x({x:g}), in 1e-3 mm", u, 1e-4 if x == 7.5 else 1e-3, ours, answer.bulk, averages[k] + " (average of programs)"))
    first, last = answer.probe("base")["displacement"][0], many.probe("base")["displacement"][0]
    return rows + [
        edge_row("open to x", 3.30, 0.01, edge(answer, ["open"])),
        edge_row("slips to x", 29.8, 0.1, edge(answer, ["slip"])),
        known("sum N", 2000, 0.01, answer.pair()["normal_force"][1], TOLERANCE),
        known("sum T", -1405.37, 0.01, answer.pair()["tangential_force"][0], answer.bulk),
        Row("u_x(0), 5 increments against 1", first, last, TOLERANCE, EXACT, (answer.summary["increments"]["shear"] or 0)),
    ]


@case("slab", "Floating slab, mu = 0.5", BENCHMARKS)
def slab(run):
    answer = run("floating_slab.prm", "Refinement/Strategy=uniform", "Refinement/Cycles=4")
    pair = answer.pair()
    rows = [
        Row("N", 800, pair["normal_force"][1], TOLERANCE, EXACT),
        Row("T", -120, pair["tangential_force"][0], TOLERANCE, EXACT),
    ]
    pressures = (1, 184.2, 0.1), (2, 186.45, 0.01), (3, 196.4, 0.1)
    return rows + [known(f"p({x})", p, unit, answer.at(x), answer.estimate("pressure")) for x, p, unit in pressures]


@case("roller mu", "NAFEMS R0094-1, mu = 0.1", BENCHMARKS)
def roller_friction(run):
    answer, one = run("nafems_roller_friction.prm", "Refinement/Cycles=6"), run("nafems_roller_friction.prm", "Increments=1", "Refinement/Cycles=8")
    shear = max(abs(row["tx"]) for row in answer.nodes("roller"))
    return [
        known("p(0), 20 increments", 3663, 1, answer.at(0, pair="roller"), answer.estimate("pressure")),
        edge_row("c, 20 increments", 2.15, 0.01, edge(answer, ["stick"], pair="roller")),
        known("largest shear, 20 increments", 339, 1, shear, answer.estimate("shear")),
        edge_row("c, one increment (known to be wrong)", 0.87, 0.01, edge(one, ["stick"], pair="roller")),
    ]


@case("punch NAFEMS", "NAFEMS R0094-2, frictionless", BENCHMARKS)
def nafems_punch(run):
    answer = run("nafems_punch.prm", "Refinement/Cycles=7")
    estimate = answer.estimate()
    pressures = (0, 87.25, 0.01), (20, 96.34, 0.01), (35, 153.5, 0.1)
    rows = [known("u_y, centre of the foundation", -0.13396, 1e-5, answer.probe("middle")["displacement"][1], answer.bulk)]
    rows += [known(f"p({x})", p, unit, answer.at(x), estimate) for x, p, unit in pressures]
    return rows + [edge_row("contact ends at r", 40.40, 0.01, edge(answer, ["slip", "stick"]))]


@case("punch mu", "NAFEMS R0094-2, mu = 0.1", BENCHMARKS)
def nafems_punch_friction(run):
    answer = run("nafems_punch_friction.prm", "Increments=10")
    uniform = run("nafems_punch_friction.prm", "Increments=1", "Refinement/Strategy=uniform", "Refinement/Cycles=2")  # finer at the edge of the stick zone
    return [
        known("u_y, centre of the foundation", -0.13178, 1e-5, answer.probe("middle")["displacement"][1], answer.bulk),
        edge_row("sticks to r", 16.9, 0.1, edge(uniform, ["stick"])),
    ]


@case("MOOSE", "Quarter of a cylinder on a stiff plate (MOOSE hertz_cyl)", BENCHMARKS)
def quarter_cylinder(run):
    answer = run("verification/quarter_cylinder.prm", "Refinement/Cycles=12")
    return [known("half force", 344.9185, 1e-4, answer.pair()["normal_force"][1], answer.estimate())]


# ---- Finite strain


def confined_stretches(bodies, whole):
    """Stretches of stacked neo-Hookean blocks (E, nu, height) in uniaxial strain, p = M/2 (1/s - s): pressure of the sum `whole` of their heights."""
    moduli = [E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) for E, nu, _ in bodies]

    def height(p):
        return sum(h * (math.sqrt((p / M) ** 2 + 1) - p / M) for M, (_, _, h) in zip(moduli, bodies))

    return formulas.bisect(lambda p: height(p) - whole, 0, 1e5)


@case("finite patch", "Two blocks shortened by 30 %", FINITE)
def finite_patch(run):
    p = confined_stretches([(1000, 0.3, 1), (800, 0.2, 2)], 2.1)
    rows = []
    for name, sets in ("as it is", []), ("turned by 40 degrees", ["turned"]):
        scene = "verification/patch_finite_turned.prm" if sets else "verification/patch_finite.prm"
        worst = max((run(scene, f"Contact interface/Slave={slave}").worst(p) for slave in ("first", "second")), key=lambda v: abs(v - p))
        rows.append(Row(f"pressure, {name}, either slave", p, worst, TOLERANCE, EXACT))
    return rows


@case("finite press", "Block of nu = 0.4999 between planes, to 0.7", FINITE, small=True)
def finite_press(run):
    E, nu, s = 1, 0.4999, 0.7
    shear, lame = E / (2 * (1 + nu)), E * nu / ((1 + nu) * (1 - 2 * nu))
    m = (shear + lame / 2) / (shear + lame / 2 * s * s)
    p = shear * (m - s * s) / (s * math.sqrt(m))
    answer = run("verification/press_finite.prm")
    ours = max((answer.worst(p, pair=name) for name in ("above", "below")), key=lambda v: abs(v - p))
    return [
        Row("pressure of the worst node", p, ours, TOLERANCE, EXACT),
        Row("lateral displacement", math.sqrt(m) - 1, answer.probe("corner")["displacement"][0], TOLERANCE, EXACT),
    ]


@case("finite roller", "NAFEMS R0094-1, large displacements, St. Venant-Kirchhoff", FINITE)
def finite_roller(run):
    answer = run("nafems_roller_finite.prm")
    note = "Code_Aster ssnp154: -1.3069 (linear), -1.3080 (quadratic)"
    return [known("u_y of the block's top", -1.3080, 1e-4, answer.probe("block top")["displacement"][1], answer.bulk, note)]


@case("ironing", "Shallow ironing (IR2), 48 x 8 cells", FINITE)
def ironing(run):
    answer = run("ironing.prm", "End time=1.7", "Increments=170", "Body block/Cells=48,8")
    rows = [row for row in answer.history if 1.3 < row["t"] < 1.7]

    def mean(axis):
        kinds = "normal", "tangential"
        return abs(sum(row[f"ironing.{kind}_force_{axis}"] for row in rows for kind in kinds)) / len(rows)

    others = "GetFEM {} (71 s); CalculiX face to face {} (166 s), others of its methods do not end"
    return [
        known("vertical force, 3 < slide < 7", 51.39, 0.01, mean("y"), answer.estimate(), others.format(51.27, 51.12)),
        known("horizontal force, 3 < slide < 7", 18.27, 0.01, mean("x"), answer.estimate(), others.format(18.37, 24.81)),
    ]


# ---- Scenes of other programs: the pressure against Hertz's for the force that was found


def compared(answer, share, floors, origin, published, point=False):
    Es = formulas.modulus(210e3, 0.3) if point else formulas.modulus(210e3, 0.3, 210e3, 0.3)
    a, p0 = (formulas.hertz_point if point else formulas.hertz_line)(share * answer.force(), 50, Es)[:2]
    floor = floors(a)
    if answer.kind == "3D":
        off = area_norm(answer, a, p0)
    else:
        weight = (lambda r: r) if point else (lambda r: 1.0)
        off = answer.profile(lambda x: p0 * formulas.ellipse(x, a), -1.3 * a, 1.3 * a, weight=weight)
    ours = f"ours {answer.summary['dofs']} DoFs; {published}"
    return [error_row("pressure, L2 to 1.3 a", off, floor, origin, answer.estimate(), ours)]


def area_norm(answer, a, p0):
    """In space: of nodal values, weighted by area."""
    rows = [(row["area"], row["pressure"], p0 * formulas.ellipse(answer.distance(row), a)) for row in answer.nodes() if answer.distance(row) < 1.3 * a]
    return math.sqrt(math.fsum(w * (p - exact) ** 2 for w, p, exact in rows) / math.fsum(w * exact**2 for w, _, exact in rows))


def line_floor(a):
    return formulas.ellipse_change(formulas.block_line(a, 48) + formulas.circle_line(a, 50))


def point_floor(a):
    return formulas.ellipse_change(formulas.block_point(a, 30)[0] + formulas.circle_point(a, 50), point=True)


@case("H2", "Cylinder on a flat", PEERS)
def peers_cylinder(run):
    others = "GetFEM Q1 31542: 5.3e-3, 2.6 s, Q2 47583: 5.7e-3, 5.0 s; CalculiX face to face 92100: 3.2e-3, 23 s, mortar 62348: 4.1e-3, 14 s"
    return compared(run("verification/peers_cylinder.prm"), 2, line_floor, f"{BLOCK}, {CIRCLE}", others)


@case("CM peers", "Cylinder on a flat with friction", PEERS)
def peers_shear(run):
    others = "GetFEM Q1 63044: 7.8e-3, 9.3 s, Q2 41502: 9.4e-3, 9.3 s; CalculiX face to face 61630: 8.5e-3, 24 s"
    return compared(run("verification/peers_shear.prm"), 1, line_floor, f"{BLOCK}, {CIRCLE}", others)


@case("HA", "Sphere on a rigid plane, axisymmetric", PEERS)
def peers_sphere(run):
    others = "GetFEM Q1 48470: 4.7e-3, 3.4 s, Q2 60473: 4.3e-3, 6.3 s; CalculiX face to face 15064: 2.2e-2, 2.4 s"
    return compared(run("verification/peers_sphere.prm"), 1, point_floor, f"{BLOCK}, {CIRCLE}", others, point=True)


@case("H3", "Sphere on a rigid plane, in space", PEERS)
def peers_sphere_3d(run):
    others = "GetFEM Q1 62620: 3.3e-2, 46 s; CalculiX face to face 59760: 5.1e-2, 18 s, mortar 21069: 5.4e-2, 12 s"
    return compared(run("verification/peers_sphere_3d.prm"), 4, point_floor, f"{BLOCK}, {CIRCLE}", others, point=True)
