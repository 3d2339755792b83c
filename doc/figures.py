#!/usr/bin/env python3
"""Makes the figures of introduction.md and walk.md: python3 doc/figures.py writes doc/pictures/figure_*.svg. Curves are computed, not drawn."""
import math
import pathlib

FOLDER = pathlib.Path(__file__).resolve().parent / "pictures"
INK, GREY, BLUE, RED, GREEN = "#222", "#888", "#1f5fa8", "#b8322a", "#2d7a3a"
LIGHT_BLUE, LIGHT_RED, LIGHT_GREY = "#e3edf8", "#fae6e3", "#f1f1f1"


class Figure:
    """Lines, arrows and text in a drawing whose y points down."""

    def __init__(self, name, width, height):
        self.path, self.parts = FOLDER / f"figure_{name}.svg", []
        self.head = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
                     'font-family="Helvetica, Arial, sans-serif" font-size="14">\n<rect width="100%" height="100%" fill="white"/>\n')

    def add(self, text):
        self.parts.append(text)

    def line(self, points, colour=INK, width=1.5, dash="", fill="none", close=False):
        text = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        dashes = f' stroke-dasharray="{dash}"' if dash else ""
        shape = "polygon" if close else "polyline"
        self.add(f'<{shape} points="{text}" fill="{fill}" stroke="{colour}" stroke-width="{width}" stroke-linejoin="round"{dashes}/>')

    def area(self, points, fill):
        self.line(points, "none", 0, fill=fill, close=True)

    def dot(self, x, y, colour=INK, radius=4, hollow=False):
        self.add(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" fill="{"white" if hollow else colour}" stroke="{colour}" stroke-width="1.5"/>')

    def arrow(self, x0, y0, x1, y1, colour=INK, width=1.8, both=False, dash=""):
        self.line([(x0, y0), (x1, y1)], colour, width, dash)
        for a, b, c, d in [(x0, y0, x1, y1)] + ([(x1, y1, x0, y0)] if both else []):
            angle = math.atan2(d - b, c - a)
            self.area([(c, d)] + [(c - 9 * math.cos(angle + s), d - 9 * math.sin(angle + s)) for s in (0.38, -0.38)], colour)

    def text(self, x, y, words, colour=INK, anchor="start", size=14, bold=False):
        """_{..} lowers, *..* slants."""
        out, slant = "", False
        k = 0
        while k < len(words):
            if words[k] == "*":
                out += "</tspan>" if slant else '<tspan font-style="italic" font-family="Georgia, serif">'
                slant = not slant
            elif words.startswith("_{", k):
                end = words.index("}", k)
                out += f'<tspan dy="4" font-size="{size * 0.72:.0f}">{words[k + 2:end]}</tspan><tspan dy="-4">&#8203;</tspan>'
                k = end
            else:
                out += {"<": "&lt;", ">": "&gt;", "&": "&amp;"}.get(words[k], words[k])
            k += 1
        weight = ' font-weight="bold"' if bold else ""
        self.add(f'<text x="{x:.1f}" y="{y:.1f}" fill="{colour}" text-anchor="{anchor}" font-size="{size}"{weight}>{out}</text>')

    def save(self):
        self.path.write_text(self.head + "\n".join(self.parts) + "\n</svg>\n")


def hatch(figure, x0, x1, y, below=True):
    figure.line([(x0, y), (x1, y)], INK, 2)
    x = x0 + 4
    while x < x1:
        figure.line([(x, y), (x - 7, y + (8 if below else -8))], GREY, 1)
        x += 10


def bodies():
    f = Figure("bodies", 640, 400)
    # master: a block; slave: a body with a round lower side
    f.line([(60, 260), (580, 260), (580, 350), (60, 350)], INK, 1.5, fill=LIGHT_GREY, close=True)
    hatch(f, 60, 580, 350)

    def arc(x):
        return 232 - (180 - math.sqrt(max(0.0, 260**2 - (x - 320) ** 2)) + 80)

    xs = [130 + 380 * k / 60 for k in range(61)]
    lower = [(x, arc(x)) for x in xs]
    f.line([(130, 60)] + lower + [(510, 60)], INK, 1.5, fill=LIGHT_BLUE, close=True)
    surface = [p for p in lower if 165 <= p[0] <= 475]
    f.line(surface, BLUE, 4)
    f.line([(150, 260), (490, 260)], RED, 4)
    for x in range(170, 500, 40):
        f.arrow(x, 24, x, 57, GREEN)
    f.text(518, 45, "loads *ℓ*", GREEN)
    f.text(146, 92, "Ω^1: *u*, σ = *C* ε(*u*)".replace("^1", "¹"), INK)
    f.text(76, 335, "Ω²", INK)
    f.text(578, 372, "supports", GREY, "end", 12)
    # n, chi, gap at a point
    x = 420
    y = arc(x)
    slope = (arc(x + 1) - arc(x - 1)) / 2
    n = (-slope / math.hypot(1, slope), 1 / math.hypot(1, slope))
    t = (260 - y) / n[1]
    foot = (x + t * n[0], 260)
    f.line([(x, y), foot], INK, 1.2, "4 3")
    f.arrow(x, y, x + 0.55 * t * n[0], y + 0.55 * t * n[1], INK)
    f.dot(x, y, BLUE)
    f.dot(*foot, RED)
    f.text(x - 6, y - 10, "*x*", INK, "end")
    f.text(x + 0.5 * t * n[0] - 8, y + 0.55 * t * n[1] + 4, "*n*", INK, "end")
    f.text(foot[0] + 2, 282, "χ(*x*)")
    f.text(x + 0.8 * t * n[0] + 12, y + 0.72 * t * n[1], "gap *g* = *g*_{0} − *n*·[*u*]")
    # pressure at the middle
    for d in (-36, -18, 0, 18, 36):
        length = 30 * math.sqrt(max(0.0, 1 - (d / 44) ** 2))
        f.arrow(320 + d, 262 + length, 320 + d, 263, RED, 1.3) if length > 12 else None
    f.text(320, 312, "pressure *p* where *g* = 0", RED, "middle")
    f.text(122, 178, "slave Γ", BLUE, "end")
    f.line([(126, 174), (168, 184)], BLUE, 1)
    f.text(110, 246, "master", RED, "end")
    f.line([(114, 242), (152, 257)], RED, 1)
    f.text(320, 386, "[*u*] = *u* at *x* less *u* at χ(*x*).  *g* ≥ 0,  *p* ≥ 0,  *p g* = 0", INK, "middle")
    f.save()


def bernstein(p, k, x):
    return math.comb(p, k) * x**k * (1 - x) ** (p - k)


def gauss_jordan(a):
    """The inverse."""
    n = len(a)
    m = [row[:] + [float(i == j) for j in range(n)] for i, row in enumerate(a)]
    for k in range(n):
        pivot = max(range(k, n), key=lambda r: abs(m[r][k]))
        m[k], m[pivot] = m[pivot], m[k]
        m[k] = [v / m[k][k] for v in m[k]]
        for r in range(n):
            if r != k:
                m[r] = [v - m[r][k] * w for v, w in zip(m[r], m[k])]
    return [row[n:] for row in m]


def dual(p, end):
    """psi = D M^-1 B on [0, end], introduction.md, (8): the matrix D M^-1, and D."""
    nodes = [0.04691007703, 0.23076534495, 0.5, 0.76923465505, 0.95308992297]
    weights = [0.118463442528, 0.239314335249, 0.284444444444, 0.239314335249, 0.118463442528]
    D, M = [0.0] * (p + 1), [[0.0] * (p + 1) for _ in range(p + 1)]
    for x, w in zip(nodes, weights):
        b = [bernstein(p, k, x * end) for k in range(p + 1)]
        for i in range(p + 1):
            D[i] += w * end * b[i]
            for j in range(p + 1):
                M[i][j] += w * end * b[i] * b[j]
    return [[D[i] * v for v in row] for i, row in enumerate(gauss_jordan(M))], D


def dual_basis():
    f = Figure("dual_basis", 740, 568)
    colours = (BLUE, RED, GREEN)
    for row, p in enumerate((1, 2)):
        for column, end in enumerate((1.0, 0.6)):
            left, top, width, unit = 70 + 360 * column, 46 + 260 * row, 280, 30

            def place(x, y, left=left, top=top, width=width, unit=unit):
                return left + width * x, top + 118 - unit * y

            f.area([place(0, -2.6), place(end, -2.6), place(end, 3.6), place(0, 3.6)], LIGHT_BLUE)
            if end < 1:
                f.text(*place(0.8, -2.2), "not covered", GREY, "middle", 12)
            f.line([place(0, 0), place(1, 0)], INK, 1.2)
            f.line([place(0, -2.6), place(0, 3.6)], INK, 1.2)
            for y in (-2, -1, 1, 2, 3):
                f.line([place(0, y), (place(0, y)[0] - 4, place(0, y)[1])], INK, 1)
                f.text(left - 8, place(0, y)[1] + 4, str(y).replace("-", "−"), GREY, "end", 11)
            A, D = dual(p, end)
            grid = [k / 80 for k in range(81)]
            for i in range(p + 1):
                f.line([place(x, bernstein(p, i, x)) for x in grid if x <= end + 1e-9], colours[i], 1.4, "5 3")
                curve = [(x * end, sum(A[i][j] * bernstein(p, j, x * end) for j in range(p + 1))) for x in grid]
                part = []
                for c in curve + [(0, 99)]:  # what lies in the picture, piece by piece
                    if -2.6 <= c[1] <= 3.6:
                        part.append(place(*c))
                    elif part:
                        f.line(part, colours[i], 2.2)
                        part = []
            for i in range(p + 1):
                f.dot(*place(i / p, 0), colours[i], 4)
                f.text(place(i / p, 0)[0], top + 118 + 30 * 2.6 + 20, f"*D*_{{{i}}} = {D[i]:.3f}", colours[i], ("start", "middle", "end")[i if p == 2 else 2 * i], 12)
            f.text(left, top - 6 - 0, ("linear" if p == 1 else "quadratic") + (", covered whole" if end == 1 else ", covered to 0.6"), INK, "start", 14, True)
    f.line([(70, 548), (100, 548)], INK, 1.4, "5 3")
    f.text(108, 553, "traces *B*_{i}")
    f.line([(200, 548), (230, 548)], INK, 2.2)
    f.text(238, 553, "dual functions ψ_{i}, on the covered part, of sum 1;  ∫ψ_{i} *B*_{j} = δ_{ij} *D*_{i}")
    f.save()


def cone():
    f = Figure("cone", 660, 390)
    x0, y0, unit, mu = 230, 200, 100, 0.55

    def place(p, q):
        return x0 + unit * p, y0 - unit * q

    f.area([place(-1.6, 1.65), place(0, 1.65), place(0, -1.5), place(-1.6, -1.5)], LIGHT_GREY)
    f.area([place(0, 0), place(1.65 / mu, 1.65), place(3.4, 1.65), place(3.4, -1.5), place(1.5 / mu, -1.5)], LIGHT_BLUE)
    f.arrow(*place(-1.65, 0), *place(3.75, 0), INK)
    f.arrow(*place(0, -1.55), *place(0, 1.8), INK)
    f.text(*place(3.5, -0.22), "*p* − *c g*", INK)
    f.text(place(0, 0)[0] + 10, place(0, 1.68)[1], "*q* + *c v*", INK)
    f.line([place(0, 0), place(1.65 / mu, 1.65)], BLUE, 2.5)
    f.line([place(0, 0), place(1.5 / mu, -1.5)], BLUE, 2.5)
    f.text(*place(1.78, 1.34), "|*q*| = φ(*p*) = μ *p*", BLUE, "end")
    f.dot(*place(0, 0), BLUE, 4)

    # stick: stays; slip: back at the same p; open: to the tip
    f.dot(*place(1.3, 0.3), GREEN)
    f.text(place(1.3, 0)[0] + 9, place(0, 0.3)[1] + 4, "stick: *q* stays, *v* = 0", GREEN, "start", 13)
    f.dot(*place(1.5, -1.35), RED, hollow=True)
    f.arrow(*place(1.5, -1.29), *place(1.5, -mu * 1.5 - 0.03), RED)
    f.dot(*place(1.5, -mu * 1.5), RED)
    f.text(place(1.5, 0)[0] - 10, place(0, -1.1)[1] + 4, "slip: *q* = φ *d*", RED, "end", 13)
    f.dot(*place(-1.0, 0.9), INK, hollow=True)
    f.arrow(*place(-0.95, 0.855), *place(-0.05, 0.045), INK)
    f.text(place(-1.55, 0)[0], place(0, 1.2)[1], "open: *p* = 0, *q* = 0", INK, "start", 13)
    f.text(place(-1.55, 0)[0], place(0, -1.35)[1], "*p* − *c g* ≤ 0", GREY, "start", 13)
    f.text(330, 378, "hollow: the trial traction (11), (15);  full: the traction that the state gives", GREY, "middle", 13)
    f.save()


def trial_and_test():
    f = Figure("trial_and_test", 760, 424)
    mu = 0.5
    for k, title in enumerate(("open", "slip", "stick")):
        x = 130 + 250 * k
        f.text(x, 28, title, INK, "middle", 16, True)
        for row, y in enumerate((120, 290)):
            f.area([(x - 95, y + 12), (x + 95, y + 12), (x + 95, y + 52), (x - 95, y + 52)], LIGHT_GREY)
            f.line([(x - 95, y + 12), (x + 95, y + 12)], INK, 1.5)
            colour = (BLUE, RED)[row]
            if title == "open":
                for a in range(0, 360, 45):
                    c, s = math.cos(math.radians(a)), math.sin(math.radians(a))
                    f.arrow(x + 8 * c, y - 14 + 8 * s, x + 26 * c, y - 14 + 26 * s, colour, 1.4)
                f.dot(x, y - 14, colour)
            elif title == "slip" and row == 0:
                f.arrow(x - 60, y + 8, x + 60, y + 8, colour, 2, both=True)
                f.dot(x, y + 8, colour)
            elif title == "slip":
                # test functions along s with (n + mu d) . s = 0, n down, d to the right
                norm = math.hypot(1, mu)
                s = (1 / norm, -mu / norm)
                f.line([(x - 72, y + 8), (x + 72, y + 8)], GREY, 1, "3 3")
                f.arrow(x - 66 * s[0], y + 8 + 66 * mu / norm, x + 66 * s[0], y + 8 - 66 * mu / norm, colour, 2, both=True)
                f.arrow(x, y + 8, x - 52 * mu / norm, y + 8 - 52 / norm, GREEN, 2)
                f.text(x - 32, y - 44, "−(*n* + μ *d*)", GREEN, "middle", 13)
                f.text(x + 58, y + 3, "ϱ", INK, "start", 13)
                f.dot(x, y + 8, colour)
            else:
                f.dot(x, y + 8, colour, 6)
    f.text(18, 80, "trial", BLUE, "start", 14, True)
    f.text(18, 250, "test", RED, "start", 14, True)
    for row, (y, words) in enumerate(((196, ("none", "*n*·Δ = *ḡ*", "Δ = what it was, *g* = 0")), (366, ("none", "(*n* + μ *d*)·Δ(*w*) = 0", "Δ(*w*) = 0")))):
        for k, text in enumerate(words):
            f.text(130 + 250 * k, y, text, (BLUE, RED)[row], "middle", 14)
    f.text(380, 394, "The force of a slipping node lies along −(*n* + μ *d*), at the angle of friction, tan ϱ = μ, to the normal:", GREY, "middle", 13)
    f.text(380, 413, "test functions across it do not see it, and the multiplier leaves the system.", GREY, "middle", 13)
    f.save()


def loops():
    f = Figure("nested_iteration", 760, 430)
    boxes = [
        (10, 10, 740, 410, "increments of the load", "LoadStepping::run_load_program", "commit, or go back and halve the increment"),
        (35, 66, 690, 338, "meshes", "LoadStepping::solve_increment", "estimate, mark, refine; carry u, p and the states over"),
        (60, 122, 640, 266, "Newton's iteration, geometry and states at once", "Newton::iterate", "until the set of states repeats and the residual is small"),
        (85, 178, 590, 194, "one turn", "Newton::turn", ""),
    ]
    for (x, y, w, h, title, name, note), fill in zip(boxes, ("#f7f7f7", "#eef4fb", "#dfeaf7", "white")):
        f.line([(x, y), (x + w, y), (x + w, y + h), (x, y + h)], INK, 1.2, fill=fill, close=True)
        f.text(x + 12, y + 21, title, INK, "start", 14, True)
        f.text(x + w - 12, y + 21, name, BLUE, "end", 12)
        f.text(x + 12, y + 42, note, GREY, "start", 12)
    steps = [("linearise", "K, surfaces, states to constraints C, C̃"), ("solve", "C̃ᵀ K C δu = C̃ᵀ (f − K u)"), ("advance", "u + δu, halved if a cell turns inside out"),
             ("recover_contact", "p, q from the rows that the test functions left"), ("StatusUpdate", "open, slip or stick, from p − c g and q + c v")]
    for k, (name, what) in enumerate(steps):
        y = 226 + 30 * k
        f.text(112, y, f"{k + 1}", GREY, "start", 13)
        f.text(132, y, name, BLUE, "start", 13)
        f.text(272, y, what, INK, "start", 13)
    f.arrow(655, 346, 655, 222, INK, 1.6)
    f.save()


def lug():
    f = Figure("lug_sketch", 700, 380)
    x0, y0, unit = 440, 180, 6.0

    def place(x, y):
        return x0 + unit * x, y0 - unit * y

    outline = [place(-60, -20), place(-60, 20), place(0, 20)] + [place(20 * math.sin(a), 20 * math.cos(a)) for a in [math.pi * k / 40 for k in range(41)]]
    f.line(outline, INK, 1.5, fill=LIGHT_BLUE, close=True)
    circle = [(10 * math.cos(a), 10 * math.sin(a)) for a in [2 * math.pi * k / 60 for k in range(60)]]
    f.line([place(x, y) for x, y in circle], INK, 1.5, fill="white", close=True)
    f.line([place(0.4 + 0.955 * x, 0.955 * y) for x, y in circle], INK, 1.2, fill=LIGHT_RED, close=True)
    # the part that is meshed
    f.line([place(-64, 0), place(26, 0)], GREY, 1, "9 4 2 4")
    f.text(*place(-30, 8), "lug, aluminium, E = 70 000, ν = 0.33", INK, "middle", 13)
    f.text(*place(0.4, 3.5), "pin, steel", INK, "middle", 12)
    f.arrow(*place(0.4, -1.6), *place(17, -1.6), GREEN, 2.2)
    f.text(*place(21, -3), "1000 N/mm", GREEN, "start", 13)
    y = place(0, -20)[1]
    x = place(-60, 0)[0]
    f.line([(x, place(0, -22)[1]), (x, place(0, 22)[1])], INK, 2)
    for k in range(24):
        f.line([(x, place(0, 21 - 1.8 * k)[1]), (x - 8, place(0, 21 - 1.8 * k)[1] + 8)], GREY, 1)
    # dimensions
    f.arrow(x, y + 34, x0, y + 34, GREY, 1, both=True)
    f.text((x + x0) / 2, y + 29, "60", GREY, "middle", 12)
    f.line([(x0, y0 + 62), (x0, y + 38)], GREY, 0.7)
    f.arrow(x0, y + 34, place(20, 0)[0], y + 34, GREY, 1, both=True)
    f.text(place(10, 0)[0], y + 29, "20", GREY, "middle", 12)
    f.line([(place(20, 0)[0], y0), (place(20, 0)[0], y + 38)], GREY, 0.7)
    f.line([place(7.1, 7.1), place(12, 23)], GREY, 1)
    f.text(*place(9, 24), "hole ⌀ 20, pin ⌀ 19.9, μ = 0.2", GREY, "start", 12)
    f.arrow(place(-52, 0)[0], place(0, -20)[1], place(-52, 0)[0], place(0, 20)[1], GREY, 1, both=True)
    f.text(place(-51, 0)[0], place(0, -8)[1], "40", GREY, "start", 12)
    f.save()


if __name__ == "__main__":
    for make in (bodies, dual_basis, cone, trial_and_test, loops, lug):
        make()
