"""Error of a pressure against that of the closed form (Hertz; of the pin Persson) for the same force, from samples: distance from the axis (of the pin: angle), weight (length or area),
pressure."""
import math
import pathlib
import sys

from cases import CLEARANCE, E, NU, RADIUS

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))


def hertz(case, force):
    """Half-width or radius, and peak pressure; `force` is that of all of the scene."""
    modulus = E / (1 - NU**2) / (1 if case.rigid else 2)
    if case.kind == "plane":
        a = math.sqrt(4 * force * RADIUS / (math.pi * modulus))
        return a, 2 * force / (math.pi * a)
    a = (3 * force * RADIUS / (4 * modulus)) ** (1 / 3)
    return a, 3 * force / (2 * math.pi * a * a)


def closed_form(case, force):
    """How far the contact reaches, and its pressure as a function of the distance."""
    if case.kind != "pin":
        a, peak = hertz(case, force)
        return a, lambda r: peak * math.sqrt(max(1 - (r / a) ** 2, 0))
    import scorecard_formulas

    b = scorecard_formulas.persson(E / (1 - NU**2) * CLEARANCE / force)
    reach = 2 * math.atan(b)
    return reach, lambda angle: force * scorecard_formulas.persson_pressure(angle, b) if abs(angle) < reach else 0.0


def error(case, samples, force=None):
    """Relative, in L2 over r < 1.3 a; `force` is that of all of the scene, or found from the pressure. Of the axisymmetric case, weights are lengths of the meridian."""
    if case.kind == "axisymmetric":
        samples = [(r, w * 2 * math.pi * r, p) for r, w, p in samples]
    along = math.cos if case.kind == "pin" else lambda r: 1.0  # the part of the pressure that carries the load
    force = force or case.share * math.fsum(w * p * along(r) for r, w, p in samples)
    a, function = closed_form(case, force)
    exact = [(w, p, function(r)) for r, w, p in samples if r < 1.3 * a]
    return math.sqrt(math.fsum(w * (p - q) ** 2 for w, p, q in exact) / math.fsum(w * q * q for w, _, q in exact))
