#!/usr/bin/env python3
"""The scene parameters/small_scene.prm by hand: small_scene.py [CONTACT_CSV]

The method of introduction.md for this one scene, in plain Python and without the program: what doc/tutorial.md follows. Numbers in brackets are equations of the
introduction. CONTACT_CSV, the table that the program writes, is compared with the result.
"""
import csv
import sys

MU, NU = 1.0, 0.3
BODIES = {"upper": dict(E=1000.0, cells=4, bottom=0.0), "lower": dict(E=2000.0, cells=3, bottom=-1.0)}
LENGTH, HEIGHT = 4.0, 1.0
N = (0.0, -1.0)  # outward normal of the slave, the bottom of the upper block
GAUSS = ((0.5 - 0.5 / 3**0.5, 0.5), (0.5 + 0.5 / 3**0.5, 0.5))


# ---- Unknowns: u of node (body, row, column), two components

def dof(body, row, column, component):
    first = 0 if body == "upper" else 2 * 2 * (BODIES["upper"]["cells"] + 1)
    return first + 2 * (row * (BODIES[body]["cells"] + 1) + column) + component


N_DOFS = 2 * 2 * (4 + 1) + 2 * 2 * (3 + 1)


def cell_matrix(E, h):
    """int eps(v) : C : eps(u) of a cell h x HEIGHT, with the mean of the dilatation: (1), (3), (29)."""
    lam, mu = E * NU / ((1 + NU) * (1 - 2 * NU)), E / (2 * (1 + NU))

    def strains(x, y):
        """By unknown: eps_xx, eps_yy, 2 eps_xy."""
        shapes = [(-(1 - y) / h, -(1 - x) / HEIGHT), ((1 - y) / h, -x / HEIGHT), (-y / h, (1 - x) / HEIGHT), (y / h, x / HEIGHT)]
        return [s for gx, gy in shapes for s in ((gx, 0.0, gy), (0.0, gy, gx))]

    mean = [a[0] + a[1] for a in strains(0.5, 0.5)]
    K = [[0.0] * 8 for _ in range(8)]
    for x, wx in GAUSS:
        for y, wy in GAUSS:
            e = []
            for k, (xx, yy, xy) in enumerate(strains(x, y)):
                more = (mean[k] - xx - yy) / 3
                e.append((xx + more, yy + more, more, xy))
            for i in range(8):
                for j in range(8):
                    normal = sum(a * b for a, b in zip(e[i][:3], e[j][:3]))
                    K[i][j] += wx * wy * h * HEIGHT * (lam * mean[i] * mean[j] + 2 * mu * normal + mu * e[i][3] * e[j][3])
    return K


def assemble():
    """K and f of both bodies: (3) without contact."""
    K, f = [[0.0] * N_DOFS for _ in range(N_DOFS)], [0.0] * N_DOFS
    for body, data in BODIES.items():
        h = LENGTH / data["cells"]
        k = cell_matrix(data["E"], h)
        for c in range(data["cells"]):
            dofs = [dof(body, row, c + column, d) for row in (0, 1) for column in (0, 1) for d in (0, 1)]
            for i in range(8):
                for j in range(8):
                    K[dofs[i]][dofs[j]] += k[i][j]
    for c in range(4):  # pressure x/2 on the top
        for x, w in GAUSS:
            for column, value in ((c, 1 - x), (c + 1, x)):
                f[dof("upper", 1, column, 1)] -= w * value * (c + x) / 2
    for row in (0, 1):  # pressure 2 on the left
        f[dof("upper", row, 0, 0)] += 2 * HEIGHT / 2
    return K, f


SUPPORTED = {dof("lower", 0, q, d) for q in range(4) for d in (0, 1)} | {dof("upper", r, 4, 0) for r in (0, 1)} | {dof("lower", 1, 3, 0)}


# ---- Coupling

def couple():
    """D and m of (5), from the segments between the ends of slave and master faces."""
    ends = sorted({float(i) for i in range(5)} | {LENGTH * q / 3 for q in range(4)})
    D, M = [0.0] * 5, [[0.0] * 4 for _ in range(5)]
    for a, b in zip(ends, ends[1:]):
        slave, master = int((a + b) / 2), int((a + b) / 2 * 3 / LENGTH)
        for x, w in GAUSS:
            x, w = a + x * (b - a), w * (b - a)
            s, t = x - slave, x * 3 / LENGTH - master
            # psi = D M^-1 B (8) of a face that is covered whole
            for i, B, psi in ((slave, 1 - s, 2 - 3 * s), (slave + 1, s, 3 * s - 1)):
                D[i] += w * B
                M[i][master] += w * psi * (1 - t)
                M[i][master + 1] += w * psi * t
    return D, [[value / D[i] for value in M[i]] for i in range(5)]


# ---- States to constraints

def constraints(states, directions, m):
    """C and C~ of (16), as lines: dof -> {dof: factor}. Dirichlet values are all zero."""
    trial, test = {k: {} for k in SUPPORTED}, {k: {} for k in SUPPORTED}

    def master(i, component, factor):
        return {dof("lower", 1, q, component): factor * m[i][q] for q in range(4) if dof("lower", 1, q, component) not in SUPPORTED}

    for i, state in enumerate(states):
        x, y = dof("upper", 0, i, 0), dof("upper", 0, i, 1)
        if state in ("stick", "slip"):
            trial[y] = test[y] = master(i, 1, 1)
        if state == "stick" and x not in SUPPORTED:
            trial[x] = test[x] = master(i, 0, 1)
        if state == "slip":  # (n + mu d) . Delta(w) = 0
            test[y] = {**master(i, 1, 1), **master(i, 0, -MU * directions[i]), x: MU * directions[i]}
    return trial, test


def solve(K, f, trial, test):
    """C~^T K C u = C~^T f (16), by Gauss's method; returns u."""
    free = [k for k in range(N_DOFS) if k not in trial]
    place = {k: n for n, k in enumerate(free)}
    A = [[0.0] * (len(free) + 1) for _ in free]
    for i in range(N_DOFS):
        for r, a in (test[i].items() if i in test else [(i, 1.0)]):
            A[place[r]][-1] += a * f[i]
            for j in range(N_DOFS):
                if K[i][j]:
                    for c, b in (trial[j].items() if j in trial else [(j, 1.0)]):
                        A[place[r]][place[c]] += a * K[i][j] * b
    x = gauss(A)
    return [sum(b * x[place[c]] for c, b in trial[k].items()) if k in trial else x[place[k]] for k in range(N_DOFS)]


def gauss(A):
    """The solution of A x = b for rows (A b)."""
    n = len(A)
    for k in range(n):
        pivot = max(range(k, n), key=lambda r: abs(A[r][k]))
        A[k], A[pivot] = A[pivot], A[k]
        for r in range(k + 1, n):
            factor = A[r][k] / A[k][k]
            if factor:
                A[r] = [a - factor * b for a, b in zip(A[r], A[k])]
    x = [0.0] * n
    for k in reversed(range(n)):
        x[k] = (A[k][n] - sum(A[k][j] * x[j] for j in range(k + 1, n))) / A[k][k]
    return x


def project(forces):
    """The continuous pressure of (7), by node: int B_i B_j c_j = D_i p_i, but c >= 0."""
    held = set()
    while True:
        A = [[0.0] * 6 for _ in range(5)]
        for i in range(5):
            A[i][i] = (1 if i in (0, 4) else 2) / 3 if i not in held else 1.0
            A[i][5] = forces[i] if i not in held else 0.0
            for j in (i - 1, i + 1):
                if 0 <= j < 5 and i not in held:
                    A[i][j] = 1 / 6
        x = gauss(A)
        negative = {i for i in range(5) if x[i] < 0}
        if not negative:
            return x
        held |= negative


# ---- The iteration

def main():
    K, f = assemble()
    D, m = couple()
    print("node      D      m: weights of the four master nodes")
    for i in range(5):
        print(f"{i:4} {D[i]:6.3f}      " + " ".join(f"{value:8.5f}" for value in m[i]))
    c = BODIES["upper"]["E"] / (1 - NU**2)  # h = 1
    states, directions = ["stick"] * 5, [1.0] * 5
    for iteration in range(1, 20):
        trial, test = constraints(states, directions, m)
        u = solve(K, f, trial, test)
        print(f"\niteration {iteration}: {36 - len(trial)} equations")
        print("node  state        p        q        g        v   asks for")
        p, q, following = [], [], []
        for i, state in enumerate(states):
            r = [sum(K[k][j] * u[j] for j in range(N_DOFS)) - f[k] for k in (dof("upper", 0, i, 0), dof("upper", 0, i, 1))]
            jump = [u[dof("upper", 0, i, d)] - sum(m[i][b] * u[dof("lower", 1, b, d)] for b in range(4)) for d in (0, 1)]
            p.append(-(r[0] * N[0] + r[1] * N[1]) / D[i])
            q.append(0.0 if i == 4 else -r[0] / D[i])  # the support takes what node 4 carries
            g, v = -(N[0] * jump[0] + N[1] * jump[1]), jump[0]
            tried = q[i] + c * v
            following.append("open" if p[i] - c * g <= 0 else "slip" if abs(tried) > MU * p[i] else "stick")
            if following[i] == "slip":
                directions[i] = 1.0 if tried > 0 else -1.0
            numbers = " ".join(f"{value if abs(value) > 1e-12 else 0:8.5f}" for value in (p[i], q[i], g, v))
            print(f"{i:4}  {state:5} {numbers}   {following[i]}")
        if following == states:
            break
        states = following
    pressure = project([D[i] * p[i] for i in range(5)])
    print("\npressure to plot: " + " ".join(f"{value:.5f}" for value in pressure))
    if len(sys.argv) > 1:
        with open(sys.argv[1]) as table:
            rows = list(csv.DictReader(table))
        far = max(abs(float(row["fy"]) - D[i] * p[i]) + abs(float(row["fx"]) + D[i] * q[i]) for i, row in enumerate(rows))
        far = max([far] + [abs(float(row["pressure"]) - pressure[i]) for i, row in enumerate(rows)])
        same = [row["state"] for row in rows] == states
        print("the program has the same states" + (", forces and pressures" if far < 1e-9 else "") if same else "the program has other states")
        sys.exit(0 if same and far < 1e-9 else 1)


if __name__ == "__main__":
    main()
