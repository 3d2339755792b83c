"""One run of GetFEM (Debian's python3-getfem), a process of its own: getfem_run.py CASE N DEGREE contact|linear ANSWER.

Elements of degree 1 or 2 with all tensor products (Q1, Q2), a multiplier of the same degree on the lower side of the curved body, as far as contact can come (1.38 a).
"""
import json
import sys

import getfem as gf
import numpy as np
from cases import CASES, CLEARANCE, E, NU, grid, lifted, place

GAMMA = E  # of the augmented Lagrangian, N/mm^3: of the order of E over a length of the contact. It changes the iterations, not the answer
HELD = 1e4 * E  # stiffness of supports, N/mm^3: a block gives E / 48
TOP, BOTTOM, AXIS, OTHER_AXIS, CONTACT, GLUED = range(1, 7)


class Body:
    """Mesh, elements and integration of one block."""

    def __init__(self, case, N, degree, lower):
        lines = grid(case, N, lower)
        self.dim = len(lines)
        cells = [len(x) - 1 for x in lines]
        curve = degree if case.kind == "pin" else 1  # of the cells
        self.mesh = gf.Mesh("import", "structured", f'GT="GT_QK({self.dim},{curve})";SIZES={cells};NOISED=0;NSUBDIV={cells}')
        points = np.array([np.interp(row, range(len(lines[k])), lines[k]) for k, row in enumerate(self.mesh.pts())])
        self.mesh.set_pts(points)
        self.top, self.bottom = (max(lines[-1]), min(lines[-1]))
        marks = self.regions(points, case, lower)
        self.mesh.set_pts(np.array([lifted(case, point, lower) for point in points.T]).T)
        for number, faces in marks.items():
            self.mesh.set_region(number, faces)
        self.u = gf.MeshFem(self.mesh, self.dim)
        self.u.set_classical_fem(degree)
        self.p = gf.MeshFem(self.mesh, 1)
        self.p.set_classical_fem(degree)
        order = 2 * degree + 1
        self.mim = gf.MeshIm(self.mesh, gf.Integ(f"IM_GAUSS_PARALLELEPIPED({self.dim}, {order})"))
        # Nodes of both sides do not match: with the points of the cells alone, sides jump between points, and the error is up to twice as large.
        self.fine = gf.MeshIm(self.mesh, gf.Integ(f"IM_STRUCTURED_COMPOSITE(IM_GAUSS_PARALLELEPIPED({self.dim}, 5), 4)"))

    def regions(self, points, case, lower):
        """Faces of each side, found on the grid before it is bent."""
        faces = self.mesh.outer_faces()
        corners = [points[:, self.mesh.pid_in_faces(faces[:, k:k + 1])] for k in range(faces.shape[1])]

        def where(test):
            return faces[:, [k for k, c in enumerate(corners) if test(c)]]

        def radius(c):
            return np.sqrt((c[:-1] ** 2).sum(axis=0)).max()

        tiny = 1e-9
        touching = self.top if lower else self.bottom
        marks = {
            TOP: where(lambda c: (c[-1] > self.top - tiny).all()), BOTTOM: where(lambda c: (c[-1] < self.bottom + tiny).all()),
            CONTACT: where(lambda c: (abs(c[-1] - touching) < tiny).all() and radius(c) < 1.38 * case.a),
            GLUED: where(lambda c: (abs(c[-1] - touching) < tiny).all() and radius(c) < case.a + tiny)}
        if not case.whole:
            marks[AXIS] = where(lambda c: (abs(c[0]) < tiny).all() or case.kind == "pin" and (c[0] > case.lengths(lower)[0] - tiny).all())
            marks[OTHER_AXIS] = where(lambda c: self.dim == 3 and (abs(c[1]) < tiny).all())
        return marks


def elasticity(case, u):
    """The weak form; in the axisymmetric case of a radian."""
    if case.kind == "axisymmetric":
        return (f"X(1)*(la*(Div_{u}+{u}(1)/X(1))*(Div_Test_{u}+Test_{u}(1)/X(1))+2*mu*(Sym(Grad_{u}):Grad_Test_{u}+{u}(1)*Test_{u}(1)/sqr(X(1))))")
    return f"(la*Div_{u}*Id(meshdim)+2*mu*Sym(Grad_{u})):Grad_Test_{u}"


def hold(md, body, u, region, axis, value=""):
    """What moves is no source term: GetFEM would measure its residual by it."""
    add = md.add_nonlinear_term if value else md.add_linear_term
    add(body.mim, f"{HELD}*({u}({axis}){value})*Test_{u}({axis})", region, True)


def model(case, N, degree, kind):
    md = gf.Model("real")
    md.add_initialized_data("la", [E * NU / ((1 + NU) * (1 - 2 * NU))])
    md.add_initialized_data("mu", [E / (2 * (1 + NU))])
    md.add_initialized_data("drive", [case.press])
    md.add_initialized_data("step", [0.0])
    bodies = {"u": Body(case, N, degree, False)}
    if not case.rigid:
        bodies["w"] = Body(case, N, degree, True)
    for name, body in bodies.items():
        md.add_fem_variable(name, body.u)
        md.add_linear_term(body.mim, elasticity(case, name), -1, True, True)
        up = body.dim
        hold(md, body, name, TOP if name == "u" else BOTTOM, up, "+drive" if name == "u" else "")
        if case.clamped:
            hold(md, body, name, TOP if name == "u" else BOTTOM, 1, "-step" if name == "u" else "")
        if not case.whole:
            hold(md, body, name, AXIS, 1)
            if up == 3:
                hold(md, body, name, OTHER_AXIS, 2)
    upper = bodies["u"]
    weight = "X(1)*" if case.kind == "axisymmetric" else ""
    up = upper.dim
    if not case.rigid:  # opposite of a point is the one below it, or the same one of the round surface, moved by a hair into the body: small strain
        opposite = "(1+1e-7)/Norm(X)*X" if case.kind == "pin" else "[X(1); 0]"
        md.add_interpolate_transformation_from_expression("below", upper.mesh, bodies["w"].mesh, opposite)

    def relative(k, prefix="", suffix=""):
        """Component k of the motion against the other side."""
        return f"({prefix}u{suffix}({k})" + ("" if case.rigid else f"-Interpolate({prefix}w{suffix},below)({k})") + ")"

    def away(prefix=""):
        """The motion away from the other side, along its normal."""
        return f"(-({prefix}u-Interpolate({prefix}w,below)).X/Norm(X))" if case.kind == "pin" else relative(up, prefix)

    if kind == "linear":  # glued to the other side where contact will be
        for k in range(1, up + 1) if not case.rigid else [up]:
            md.add_linear_term(upper.fine, f"{weight}{GAMMA}*{relative(k)}*{relative(k, 'Test_')}", GLUED, True)
        return md, bodies
    # Without friction: the saddle point of half of 1/gamma ([p - gamma g]_+^2 - p^2), g the gap.
    md.add_filtered_fem_variable("p", upper.p, CONTACT)
    curve = "50-sqrt(2500-sqr(X(1))" + ("-sqr(X(2)))" if up == 3 else ")")  # of the curve: with that of the facets Q2 is no better than Q1
    gap = f"{CLEARANCE}" if case.kind == "pin" else curve
    trial = f"pos_part(p-gamma*({away()}+{gap}))"
    md.add_initialized_data("gamma", [GAMMA])
    md.add_nonlinear_term(upper.fine, f"-{weight}{trial}*{away('Test_')}+{weight}1/gamma*({trial}-p)*Test_p", CONTACT, case.friction == 0)
    if case.friction:  # q: traction along x on the curved body; what it would be if it stuck, cut at the cone
        md.add_filtered_fem_variable("q", upper.p, CONTACT)
        md.add_fem_data("u0", upper.u)
        md.add_fem_data("w0", bodies["w"].u)
        md.add_initialized_data("friction", [case.friction])
        cone = f"friction*{trial}"
        stick = f"(q-gamma*({relative(1)}-{relative(1, suffix='0')}))"
        cut = f"(pos_part({stick}+{cone})-pos_part({stick}-{cone})-{cone})"
        md.add_nonlinear_term(upper.fine, f"-{cut}*{relative(1, 'Test_')}+1/gamma*({cut}-q)*Test_q", CONTACT, False)
    return md, bodies


def samples(md, case, body):
    """Distance from the axis (of the pin: angle), weight and pressure at the points of integration. GetFEM's weights are of the unit face."""
    faces = body.mesh.region(CONTACT)
    nodes = body.fine.im_nodes(faces)
    sizes = []
    for k in range(faces.shape[1]):
        corners = body.mesh.pts()[:, body.mesh.pid_in_faces(faces[:, k:k + 1])]
        corners = corners[:-1] if case.kind != "pin" else np.array([[place(case, point) for point in corners.T]])
        sizes.append(np.prod(corners.max(axis=1) - corners.min(axis=1)))
    each = nodes.shape[1] // len(sizes)
    weights = nodes[-1] / nodes[-1, :each].sum() * np.repeat(sizes, each)
    pressure = md.interpolation("p", nodes[:-1], body.mesh, -1, 1)
    places = np.array([place(case, point) for point in nodes[:-1].T]) if case.kind == "pin" else np.sqrt((nodes[:-2] ** 2).sum(axis=0))
    return np.array([places, weights, pressure]).T.tolist()


def main():
    case, N, degree, kind, path = CASES[sys.argv[1]], int(sys.argv[2]), int(sys.argv[3]), sys.argv[4], sys.argv[5]
    gf.util_trace_level(0)
    gf.util_warning_level(0)
    md, bodies = model(case, N, degree, kind)
    iterations = []
    for step in range(2 if case.shear and kind == "contact" else 1):
        md.set_variable("step", [step * case.shear])
        answer = md.solve("max_res", 1e-8 * E * case.a * case.press, "max_iter", 60, "noisy")
        iterations.append(answer[0])
        if case.shear and kind == "contact":
            md.set_variable("u0", md.variable("u"))
            md.set_variable("w0", md.variable("w"))
    result = {"iterations": "+".join(str(k) for k in iterations), "dofs": md.nbdof()}
    if kind == "contact":
        result["samples"] = samples(md, case, bodies["u"])
    with open(path, "w", encoding="utf-8") as file:
        json.dump(result, file)


if __name__ == "__main__":
    main()
