"""Error of a pressure against Hertz's for the same force, from samples: distance from the axis, weight (length or area), pressure."""
import math

from cases import E, NU, RADIUS


def hertz(case, force):
    """Half-width or radius, and peak pressure; `force` is that of all of the scene."""
    modulus = E / (1 - NU**2) / (1 if case.rigid else 2)
    if case.kind == "plane":
        a = math.sqrt(4 * force * RADIUS / (math.pi * modulus))
        return a, 2 * force / (math.pi * a)
    a = (3 * force * RADIUS / (4 * modulus)) ** (1 / 3)
    return a, 3 * force / (2 * math.pi * a * a)


def error(case, samples, force=None):
    """Relative, in L2 over r < 1.3 a; `force` is that of all of the scene, or found from the pressure. Of the axisymmetric case, weights are lengths of the meridian."""
    if case.kind == "axisymmetric":
        samples = [(r, w * 2 * math.pi * r, p) for r, w, p in samples]
    force = force or case.share * math.fsum(w * p for _, w, p in samples)
    a, peak = hertz(case, force)
    exact = [(w, p, peak * math.sqrt(max(1 - (r / a) ** 2, 0))) for r, w, p in samples if r < 1.3 * a]
    return math.sqrt(math.fsum(w * (p - q) ** 2 for w, p, q in exact) / math.fsum(w * q * q for w, _, q in exact))
