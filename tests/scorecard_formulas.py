"""Closed forms of the scorecard (scorecard.py), written anew: nothing here comes from the program. Units mm, N, MPa.

Johnson, Contact Mechanics (1985): Hertz, Cattaneo, Mindlin; Sneddon (1965): cone; Persson (1964): pin; tubes: Lame.
"""
import math
from math import pi


def modulus(E1, nu1, E2=math.inf, nu2=0.0):
    """E* of two half planes or half spaces."""
    return 1 / ((1 - nu1**2) / E1 + (1 - nu2**2) / E2)


def hertz_line(P, R, Es):
    """Half-width and peak pressure."""
    a = math.sqrt(4 * P * R / (pi * Es))
    return a, 2 * P / (pi * a)


def hertz_point(P, R, Es):
    """Radius, peak pressure, approach."""
    a = (3 * P * R / (4 * Es)) ** (1 / 3)
    return a, 3 * P / (2 * pi * a * a), a * a / R


def ellipse(x, a):
    return math.sqrt(max(1 - (x / a) ** 2, 0)) if a > 0 else 0.0


def integral(f, low, high, n=4000):
    """Midpoint rule; substitute away roots at the ends."""
    h = (high - low) / n
    return h * math.fsum(f(low + (k + 0.5) * h) for k in range(n))


def bisect(f, low, high):
    positive = f(high) > 0
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if (f(middle) > 0) == positive else (middle, high)
    return 0.5 * (low + high)


# ---- What bodies that are no half spaces change (references: measured for a rigid parabola on a block of half-width = height = H, far face fixed)


def block_line(a, H):
    """Of a and p0, plane."""
    return 0.38 * (a / H) ** 2


def block_point(a, H):
    """Of a and of p0, axisymmetric."""
    return 0.19 * (a / H) ** 3, 0.39 * (a / H) ** 3


def block_approach(P, Es, H):
    """By how much less a block of height H comes: 0.52 a/H of Hertz's approach a^2/R, whatever the indenter, since it depends on the force."""
    return 0.39 * P / (Es * H)


def circle_line(a, R):
    """Of a, where a circle stands for the parabola of the formula."""
    return 3 / 16 * (a / R) ** 2


def circle_point(a, R):
    return 2 / 15 * (a / R) ** 2


def ellipse_change(da, point=False):
    """Relative L2 norm of what a change of a by this part makes of the pressure of the same force: more than da, since the edge is steep."""
    outer = 1 + abs(da)
    scale, power = outer ** -(2 if point else 1), 1 if point else 0

    def square(of):
        return integral(lambda t: of(outer * math.sin(t)) ** 2 * math.sin(t) ** power * math.cos(t), 0, pi / 2)

    return math.sqrt(square(lambda x: ellipse(x, 1) - scale * ellipse(x, outer)) / square(lambda x: ellipse(x, 1)))


# ---- Uniform pressures


def compliance(bodies, kind):
    """Of stacked blocks (E, nu, height): the pressure is the shortening over this."""
    moduli = {
        "plane strain": lambda E, nu: E / (1 - nu * nu),
        "3D": lambda E, nu: E,
        "confined": lambda E, nu: E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)),
    }
    return sum(h / moduli[kind](E, nu) for E, nu, h in bodies)


def plane_constants(E, nu, kind):
    return (E / (1 - nu * nu), nu / (1 - nu)) if kind == "plane strain" else (E, nu)


def shrink_cylinders(inner, outer, r, delta, kind):
    """Pressure between tubes (E, nu) of radii r[0] < r[1] < r[2] with the interference delta."""
    (Ei, nui), (Eo, nuo) = plane_constants(*inner, kind), plane_constants(*outer, kind)
    ri, rc, ro = r
    ci = (rc**2 + ri**2) / (rc**2 - ri**2) - nui
    co = (ro**2 + rc**2) / (ro**2 - rc**2) + nuo
    return delta / (rc * (ci / Ei + co / Eo))


def shrink_spheres(inner, outer, r, delta):
    def pressed(E, nu, a, b):  # inward at the outer radius b, per pressure there
        return b / E * ((1 - 2 * nu) * b**3 + (1 + nu) * a**3 / 2) / (b**3 - a**3)

    def blown(E, nu, a, b):  # outward at the inner radius a
        return a / E * ((1 - 2 * nu) * a**3 + (1 + nu) * b**3 / 2) / (b**3 - a**3)

    return delta / (pressed(*inner, r[0], r[1]) + blown(*outer, r[1], r[2]))


def rings(p, E, nu, R1, R2, R3):
    """Tubes R1 > R2 > R3 of one material in plane stress, p from outside: pressure at R2."""
    a = 2 * R1**2 / (R1**2 - R2**2)
    b = (R1**2 + R2**2) / (R1**2 - R2**2) + nu + (R2**2 + R3**2) / (R2**2 - R3**2) - nu
    return p * a / b


# ---- Friction


def cattaneo_shear(x, P, mu, a, s, reversed_to=None):
    """Shear traction where |Q| = s mu P was reached first; reversed_to: and Q = this times mu P on the way back."""
    p0 = 2 * P / (pi * a)

    def part(size):
        return size / a * ellipse(x, size) if size > 0 else 0.0

    c = a * math.sqrt(1 - s)
    if reversed_to is None:
        return mu * p0 * (part(a) - part(c))
    return mu * p0 * (-part(a) + 2 * part(a * math.sqrt(1 - (s - reversed_to) / 2)) - part(c))


def cattaneo_slip(x, a, s, R, mu):
    """At x, between the stick zone and the edge."""
    c = a * math.sqrt(1 - s)
    return mu / (2 * R) * (x * math.sqrt(x * x - c * c) - c * c * math.acosh(x / c))


def cattaneo_cycle(P, a, s, R, mu):
    """Work of a whole cycle: four slips times traction on either side (x = a sin t)."""
    c, p0 = a * math.sqrt(1 - s), 2 * P / (pi * a)

    def density(t):
        x = a * math.sin(t)
        return p0 * math.cos(t) * cattaneo_slip(x, a, s, R, mu) * a * math.cos(t)

    return 8 * mu * integral(density, math.asin(c / a), pi / 2)


def mindlin(P, mu, a, s, E, nu):
    """Equal spheres, Q = s mu P: tangential approach, work of a cycle."""
    k = 2 * (2 - nu) * 2 * (1 + nu) / E
    whole = 3 * mu * P / (16 * a) * k * (1 - (1 - s) ** (2 / 3))
    work = 9 * (mu * P) ** 2 / (10 * a) * k * (1 - (1 - s) ** (5 / 3) - 5 * s / 6 * (1 + (1 - s) ** (2 / 3)))
    return whole, work


# ---- Pin in a hole


def persson_load(b):
    """E1* dR/Q of the contact with b = tan(eps/2)."""
    return (2 - math.log(b * b + 1) - 2 * b**4) / (pi * b * b * (b * b + 1))


def persson(load):
    return math.exp(bisect(lambda v: persson_load(math.exp(v)) - load, math.log(1e-6), math.log(1e3)))


def persson_pressure(phi, b):
    """p R/Q at the angle phi."""
    y, h = math.tan(phi / 2), math.sqrt(b * b + 1)
    s = math.sqrt(max(b * b - y * y, 0))
    return 2 / (pi * h) * s / (1 + y * y) + math.log((h + s) / (h - s)) / (2 * pi * b * b * (1 + b * b))


def persson_spread(b):
    """Root of the mean of phi^2 under the pressure."""
    eps = 2 * math.atan(b)
    weights = [integral(lambda t, n=n: persson_pressure(eps * math.sin(t), b) * (eps * math.sin(t)) ** n * math.cos(t), 0, pi / 2, 500) for n in (0, 2)]
    return math.sqrt(weights[1] / weights[0])
