"""Cases of the scorecard (scorecard.py) with uniform pressure, and the pin in a hole."""
import math

import scorecard_formulas as formulas
from scorecard_cases import error_row
from scorecard_parts import TOLERANCE, Row, case

PATCHES, CONFORMING = "Patch tests", "Rings, shrink fits, a pin in a hole"
BLOCKS = [(1000, 0.3, 1), (100, 0.2, 2)]
SLAVES = ["Contact interface/Slave=first", "Contact interface/Slave=second"]
EXACT = "the solver's tolerance"


def worst_of(run, scene, variants, value, **options):
    """Of the pressures of all nodes in all these runs, the one that is farthest from this."""
    worst = [run(scene, *sets).worst(value, **options) for sets in variants]
    return max(worst, key=lambda p: abs(p - value))


def exact(quantity, value, ours, **more):
    return Row(quantity, value, ours, TOLERANCE, EXACT, **more)


def both(*sets):
    return [[*sets, slave] for slave in SLAVES]


@case("patch", "Two blocks", PATCHES, small=True)
def patch(run):
    p, confined = (0.01 / formulas.compliance(BLOCKS, kind) for kind in ("plane strain", "confined"))
    degrees = [[*sets, f"Discretization/Degree={degree}"] for sets in both() for degree in (1, 2)]
    return [
        exact("plane strain, either slave and degree", p, worst_of(run, "patch_test.prm", degrees, p)),
        exact("confined, either slave", confined, worst_of(run, "verification/patch_confined.prm", both(), confined)),
    ]


@case("patch meshes", "Two blocks, other meshes and angles", PATCHES)
def patch_meshes(run):
    def row(name, scene, *sets):
        return exact(name + ", either slave", 5, worst_of(run, scene, both(*sets), 5))

    plain = "verification/patch_pressure.prm"
    rows = [
        row("1:1", plain, "Body upper/Cells=5,3", "Body lower/Cells=5,5"),
        row("1:10", plain, "Body upper/Cells=1,3", "Body lower/Cells=10,5"),
        row("10:1", plain, "Body upper/Cells=10,3", "Body lower/Cells=1,5"),
        row("hanging nodes", "verification/patch_hanging_nodes.prm"),
        row("irregular, in space", "verification/patch_3d_irregular.prm"),
        row("hanging nodes, in space", "verification/patch_3d_hanging_nodes.prm"),
    ]
    return rows + [row(f"turned by {angle}", plain, f"Body upper/Rotate={angle}", f"Body lower/Rotate={angle}") for angle in (17, 45)]


@case("patch 3D", "Two blocks in space", PATCHES)
def patch_3d(run):
    p = 0.01 / formulas.compliance(BLOCKS, "3D")
    return [exact("either slave", p, worst_of(run, "patch_test_3d.prm", both(), p))]


@case("punch", "Narrow block on a wide one, both pressed", PATCHES)
def patch_punch(run):
    def under(*sides):
        """Where the punch is: beyond it the pressure of the foundation's nodes is none of the contact."""
        return lambda row: all(low < row[c] < high for c, low, high in sides)

    plane = worst_of(run, "verification/patch_punch.prm", both(), 5, where=under(("X", 0.9, 2.13)))
    square = under(("X", 0.9, 2.13), ("Y", 0.7, 1.57))
    answers = [run("verification/patch_3d_punch.prm", *sets) for sets in both()]
    space = max((answer.worst(5, where=square) for answer in answers), key=lambda p: abs(p - 5))
    nodes = [answer.normal(row) / row["area"] for answer in answers for row in answer.nodes() if row["state"] != "open" and square(row)]
    forces = max(nodes, key=lambda p: abs(p - 5))
    return [exact("plane strain, either slave", 5, plane), exact("in space, either slave", 5, space), exact("in space, force over area", 5, forces)]


# ---- Rings


def tubes(run, scene, p, *sets):
    """The mean of the pressure, and its L2 difference."""
    answer = run(scene, *sets)
    rows = [row for row in answer.nodes() if row["area"] > 0]
    area = math.fsum(row["area"] for row in rows)
    mean = math.fsum(row["area"] * row["pressure"] for row in rows) / area
    if answer.kind == "3D":
        off = math.sqrt(math.fsum(row["area"] * (row["pressure"] / p - 1) ** 2 for row in rows) / area)
    else:
        off = answer.profile(lambda phi: p, 0, math.pi / 2, coordinate=lambda row: math.atan2(row["Y"], row["X"]))
    return [
        Row("mean pressure", p, mean, 0, "none", answer.estimate()),
        error_row("pressure, L2", off, 0, "none", answer.estimate()),
    ]


@case("rings", "Concentric rings, plane stress", CONFORMING)
def rings(run):
    return tubes(run, "verification/rings.prm", formulas.rings(1e6, 1e9, 0.2, 1, 0.6, 0.2))


def shrink(run, kind):
    p = formulas.shrink_cylinders((210e3, 0.3), (70e3, 0.33), (20, 40, 60), 0.02, kind)
    return tubes(run, "verification/shrink_fit.prm", p, f"Kind={kind}", "Refinement/Cycles=3")


@case("shrink strain", "Shrink fit, plane strain", CONFORMING)
def shrink_strain(run):
    return shrink(run, "plane strain")


@case("shrink stress", "Shrink fit, plane stress", CONFORMING)
def shrink_stress(run):
    return shrink(run, "plane stress")


@case("shrink spheres", "Shrink fit of spheres, axisymmetric and in space", CONFORMING)
def shrink_spheres(run):
    p = formulas.shrink_spheres((210e3, 0.3), (70e3, 0.33), (20, 40, 60), 0.02)
    plane = tubes(run, "verification/shrink_fit_spheres.prm", p, "Refinement/Cycles=3")
    space = tubes(run, "verification/shrink_fit_spheres_3d.prm", p)
    for row in space:
        row.quantity += ", in space"
    return plane + space


# ---- Pin in a hole (identical bodies, Q = 1, R = 1)


def semi_angle(answer):
    """From the spread of nodal forces: the last node in contact is only known to a face."""
    rows = answer.nodes()
    weights = [sum(answer.normal(row) * math.atan2(row["X"], -row["Y"]) ** n for row in rows) for n in (0, 2)]
    spread = math.sqrt(weights[1] / weights[0])
    return math.degrees(2 * math.atan(formulas.bisect(lambda b: formulas.persson_spread(b) - spread, 0.05, 0.99)))


@case("pin", "Pin in a hole (Persson)", CONFORMING)
def pin(run):
    rows = []
    for load in (10, 5, 1, 0.5, 0.2):
        b = formulas.persson(load)
        gap = f"Contact hole/Initial gap={load * 0.91 / 1000!r}"
        answer = run("verification/pin_in_hole.prm", gap, "Refinement/Cycles=7")
        floor, origin, estimate = 1 / 30**2, "plate of 30 radii", answer.estimate()
        steep = formulas.ellipse_change(floor)
        eps = 2 * math.atan(b)

        def angle(row):
            return math.atan2(row["X"], -row["Y"])

        off = answer.profile(lambda phi: formulas.persson_pressure(phi, b) if abs(phi) < eps else 0.0, 0, 1.3 * eps, coordinate=angle)
        rows += [
            Row(f"semi-angle, E1* dR/Q = {load:g}", math.degrees(eps), semi_angle(answer), floor, origin, estimate),
            Row(f"p(0) R/Q, {load:g}", formulas.persson_pressure(0, b), answer.at(0, coordinate=angle), floor, origin, estimate),
            error_row(f"pressure, L2 to 1.3 eps, {load:g}", off, steep, origin, estimate),
        ]
    return rows
