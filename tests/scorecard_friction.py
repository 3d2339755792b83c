"""Cases of the scorecard (scorecard.py) with Coulomb friction: closed forms."""
import math

import scorecard_formulas as formulas
from scorecard_cases import BLOCK, error_row
from scorecard_parts import TOLERANCE, Row, case, section
from scorecard_uniform import EXACT, both

PARTIAL, HELD = "Partial slip", "Friction that holds or drags"
# cattaneo_mindlin.prm: R1 = R2 = 20, E = 200e3, nu = 0.3
P, R, MU, H = 1000, 10, 0.3, 20
MATERIAL = (200e3, 0.3, 200e3, 0.3)


def sheared(s, sign="table(1: 0, 2: 1, 3: -1, 4: 1)"):
    return f"Boundary condition load/Force={s * MU * P!r}*{sign}; -1000*table(0: 0, 1: 1)"


def shear(answer, exact, estimate, quantity, floor):
    """Relative to the norm of mu p, which does not vanish with Q."""
    a, p0 = formulas.hertz_line(P, R, formulas.modulus(*MATERIAL))
    off = answer.profile(exact, -1.3 * a, 1.3 * a, key="tx", scale=lambda x: MU * p0 * formulas.ellipse(x, a))
    return error_row(quantity, off, formulas.ellipse_change(floor), BLOCK, estimate)


def once(run, s):
    """First loading: what its end has."""
    a, p0 = formulas.hertz_line(P, R, formulas.modulus(*MATERIAL))
    answer = run("cattaneo_mindlin.prm", sheared(s), "End time=2", "Increments=2", "Output times=", "Reference/Solution=")
    floor = formulas.block_line(a, H)
    slip = formulas.cattaneo_slip(a, a, s, R, MU)
    exact = lambda x: formulas.cattaneo_shear(x, P, MU, a, s)  # noqa: E731
    return answer, [
        Row("half-width a", a, answer.size(), floor, BLOCK, answer.estimate()),
        Row("half-width a, of the integral", a, answer.pair()["contact_size"], floor, BLOCK, answer.estimate()),
        Row("c/a", math.sqrt(1 - s), stick_size(answer, a) / a, floor, BLOCK, answer.estimate("stick_size")),
        shear(answer, exact, answer.estimate("shear"), "shear, L2 (of mu p)", floor),
        Row("slip at x = a, in 1e-3 mm", 1e3 * slip, 1e3 * abs(answer.at(a, "slip_x")), 2 * floor, f"{BLOCK}: it goes with a^2", answer.estimate("shear")),
    ]


def stick_size(answer, a):
    """From int q x^2 = mu P a^2/4 (1 - (c/a)^4), with nodal forces and the a of the same forces."""
    moment = math.fsum(abs(row["fx"]) * row["X"] ** 2 for row in answer.nodes())
    size = answer.size()
    return a * max(1 - 4 * moment / (MU * answer.force() * size**2), 0) ** 0.25


def cycle(run, s):
    """A whole cycle, t = 2 to 4."""
    a, _ = formulas.hertz_line(P, R, formulas.modulus(*MATERIAL))
    answer = run("cattaneo_mindlin.prm", sheared(s), "Output times=", "Reference/Solution=")
    work = answer.finest(4)["dissipation"] - answer.finest(2)["dissipation"]
    c = answer.pair()["stick_size"]
    floor = formulas.block_line(a, H)
    return [
        Row("c/a after a cycle, of the integral", math.sqrt(1 - s), c / a, floor, BLOCK, answer.estimate("stick_size")),
        Row("work of a cycle", formulas.cattaneo_cycle(P, a, s, R, MU), work, 2 * floor, f"{BLOCK}: it goes with a^2", answer.estimate("dissipation")),
    ]


def cattaneo(run, s):
    return once(run, s)[1] + cycle(run, s)


@case("CM .25", "Cattaneo-Mindlin, cylinders, Q = 0.25 mu P", PARTIAL)
def cattaneo_25(run):
    return cattaneo(run, 0.25)


@case("CM .5", "Cattaneo-Mindlin, cylinders, Q = 0.5 mu P", PARTIAL)
def cattaneo_50(run):
    return cattaneo(run, 0.5)


@case("CM .75", "Cattaneo-Mindlin, cylinders, Q = 0.75 mu P", PARTIAL)
def cattaneo_75(run):
    return cattaneo(run, 0.75)


@case("CM .9", "Cattaneo-Mindlin, cylinders, Q = 0.9 mu P", PARTIAL)
def cattaneo_90(run):
    return cattaneo(run, 0.9)


@case("CM back", "Cattaneo-Mindlin, cylinders, reversal from 0.5 mu P", PARTIAL)
def reversal(run):
    a, _ = formulas.hertz_line(P, R, formulas.modulus(*MATERIAL))
    floor, rows = formulas.block_line(a, H), []
    for t, q, name in (2.5, 0.0, "shear on the way back at Q = 0, L2 (of mu p)"), (3, -0.5, "shear at -Q, L2 (of mu p)"):
        answer = run("cattaneo_mindlin.prm", sheared(0.5), f"End time={t}", "Increments=3", "Output times=2", "Reference/Solution=")
        exact = lambda x, q=q: formulas.cattaneo_shear(x, P, MU, a, 0.5, q)  # noqa: E731
        rows.append(shear(answer, exact, answer.estimate("shear"), name, floor))
    rows.append(Row("sum of the shear at -Q", -150, math.fsum(row["fx"] for row in answer.nodes()), TOLERANCE, EXACT))
    return rows


@case("CM box", "Cattaneo-Mindlin, half planes, cut out", PARTIAL, small=True)
def friction_box(run):
    a, s, Es = 1, 0.6, formulas.modulus(1, 0.3, 1, 0.3)
    force = math.pi * Es / 200
    answer = run("half_plane_box_friction.prm")
    exact = lambda x: formulas.cattaneo_shear(x, force, MU, a, s)  # noqa: E731
    off = answer.profile(exact, -1.3, 1.3, key="tx", scale=lambda x: MU * 2 * force / math.pi * formulas.ellipse(x, a))
    work = formulas.cattaneo_cycle(force, a, s, 50, MU) / 4
    return [
        Row("force P", force, answer.force(), 0, "none", answer.estimate()),
        Row("half-width a", a, answer.size(), 0, "none", answer.estimate()),
        Row("c/a", math.sqrt(1 - s), answer.pair()["stick_size"], 0, "none", answer.estimate("stick_size")),
        error_row("shear, L2 (of mu p)", off, 0, "none", answer.estimate("shear")),
        Row("work of the first loading", work, answer.finest(2)["dissipation"], 0, "none", answer.estimate("dissipation")),
    ]


# ---- Spheres


def spheres(run, nu):
    E, s = 200e3, 0.5
    Es = formulas.modulus(E, nu, E, nu)
    a, p0, _ = formulas.hertz_point(P, 10, Es)
    whole, work = formulas.mindlin(P, MU, a, s, E, nu)
    bent = whole - 10 * formulas.mindlin(P, MU, a, s / 10, E, nu)[0]
    sets = [f"Body upper/Poisson ratio={nu}", f"Body lower/Poisson ratio={nu}", "Reference/Solution="]
    top = section("Probe top", Body="upper", Point="0, 0, 6")
    answer = run("mindlin_sphere.prm", *sets, "Output times=1.1", text=top)
    start, first, end = (answer.finest(t)["top.u_x"] for t in (1, 1.1, 2))
    ours = end - start - 10 * (first - start)  # what is linear in Q, as that of the blocks, is not in this
    floors = formulas.block_point(a, 6)
    told, size, estimate = answer.pair(), answer.pair()["contact_size"], answer.estimate()
    dissipated = 2 * (answer.finest(4)["dissipation"] - answer.finest(2)["dissipation"])
    return [
        Row("radius a, of the integral", a, size, floors[0], BLOCK, estimate),
        Row("p0 of force and a", p0, 3 * 2 * answer.force() / (2 * math.pi * size**2), floors[1], BLOCK, estimate),
        Row("c/a", (1 - s) ** (1 / 3), told["stick_size"] / a, floors[0], BLOCK, answer.estimate("stick_size")),
        Row("delta_t(Q) - 10 delta_t(Q/10), in 1e-3 mm", 1e3 * bent, 1e3 * ours, floors[1], BLOCK, answer.estimate("shear")),
        Row("work of a cycle", work, dissipated, 2 * floors[1], BLOCK, answer.estimate("dissipation")),
    ]


@case("Mindlin 0", "Mindlin, spheres, nu = 0, Q = 0.5 mu P", PARTIAL)
def spheres_0(run):
    return spheres(run, 0)


@case("Mindlin .3", "Mindlin, spheres, nu = 0.3, Q = 0.5 mu P", PARTIAL)
def spheres_3(run):
    return spheres(run, 0.3)


# ---- Friction that holds or drags


def patch_rows(run, scene, p, direction, name):
    """All sticks at 0.9 mu p; dragged, all has mu p."""
    tau, rows = MU * p, []
    for text, sets, value in ("sticks at .9 mu p", ["End time=1", "Output times="], 0.9 * tau), ("dragged", [], tau):
        worst, slip, sticking = value, 0.0, False
        for variant in both(*sets, "Contact solver/Tolerance=1e-12"):
            answer = run(scene, *variant)
            nodes = [row for row in answer.nodes() if row["state"] != "open"]
            values = [abs(row["tx"] * direction[0] + row["ty"] * direction[1]) for row in nodes]
            worst = max(values + [worst], key=lambda v: abs(v - value))
            slip = max([slip] + [math.hypot(row["slip_x"], row["slip_y"]) for row in nodes])
            sticking = sticking or any(row["state"] == "stick" for row in nodes)
        rows.append(Row(f"{name}: shear of the worst node, {text}", value, worst, TOLERANCE, EXACT))
        if value < tau:
            rows.append(Row(f"{name}: largest slip, {text}", 0.0, slip, TOLERANCE, EXACT, scale=0.06831))
        else:
            rows.append(Row(f"{name}: a node sticks, {text}", 0.0, float(sticking), 0, EXACT, scale=1.0))
    return rows


@case("friction patch", "Frictional patch", HELD)
def friction_patch(run):
    rows = patch_rows(run, "verification/patch_friction.prm", 5, (1, 0), "plane")
    return rows + patch_rows(run, "verification/patch_friction_3d.prm", 5, (math.cos(math.pi / 6), 0.5), "space")


@case("incline", "Block on an incline, NAFEMS CGS-4", HELD, small=True)
def incline(run):
    rows = []
    for mu in (0.1, 0.2, 0.3):
        limit = (0.1 + mu) / (1 - 0.1 * mu)
        force = f"Body block/Body force={1.25 * limit / 2!r}*table(1: 0, 2: 1); -0.5*table(0: 0, 1: 1)"
        answer = run("incline.prm", f"Contact base/Friction coefficient={mu}", force, fails=True)
        held = 1.25 * limit * (answer.history[-1]["t"] - 1) if "cannot hold" in answer.summary["message"] else math.nan
        step = 2 * 1e-4 * 1.25  # twice the shortest increment, of the end time 2
        rows.append(Row(f"F/G that is just held, mu = {mu}", limit, held, step, "shortest increment"))
    weight = "Body block/Body force=0; -0.5*table(0: 0, 1: 1)"
    stop = section("Boundary condition stop", Boundaries="block/left", Type="symmetry")
    answer = run("incline.prm", "Contact base/Friction coefficient=", weight, text=stop)
    fx, fy = answer.summary["reactions"][0]["force"][:2]
    return rows + [Row("F/G in place of a stop, mu = 0", 0.1, math.hypot(fx, fy) * math.hypot(1, 0.1), TOLERANCE, EXACT)]


@case("bar", "Bar on a plane, microslip", HELD, small=True)
def bar(run):
    force, EA, tau = 10, 1000, 1
    answer = run("microslip_bar.prm")
    work = answer.finest(3)["dissipation"] - answer.finest(1)["dissipation"]
    slipping = 20 - max(row["X"] for row in answer.nodes() if row["state"] == "stick")
    # (h/L)^2 with L = F/tau: stresses decay over the height of the bar
    floor, origin = (0.2 / 10) ** 2, "height of the bar, (h tau/F)^2"
    spacing = min(abs(a["X"] - b["X"]) for a, b in zip(answer.nodes(), answer.nodes()[1:]))
    return [
        Row("u at the end", force**2 / (2 * EA * tau), answer.probe("end")["displacement"][0], floor, origin, answer.bulk),
        Row("slip length", force / tau, slipping, spacing / 10 + 0.02, "a node, height of the bar"),
        Row("work of a cycle", 2 * force**3 / (3 * EA * tau), work, 2 * floor, origin, answer.bulk + (answer.summary["increments"]["dissipation"] or 0)),
    ]


@case("capstan", "Capstan, a quarter of a turn", HELD)
def capstan(run):
    rows = []
    for mu in (0.1, 0.3):
        at_mu = f"Contact drum/Friction coefficient={mu}"
        for t, sign, name in (1, -1, "held"), (2, 1, "pulled"):
            answer = run("capstan.prm", at_mu, f"End time={t}", f"Increments={t}")
            pull = abs(answer.summary["reactions"][0]["force"][1])
            rows.append(Row(f"T2/T1, mu = {mu}, {name}", math.exp(sign * mu * math.pi / 2), pull, 0.01, "thickness of the strip, h/(2 R)", answer.bulk))
    return rows
