"""Grids of cases.py as nodes, cells and sides of CalculiX."""
import itertools
import math

from cases import CLEARANCE, grid, lifted


class Mesh:
    """Nodes and cells of one body, numbered from where the other ends."""

    def __init__(self, case, N, degree, lower, layer, first):
        lines = grid(case, N, lower)
        if layer:
            lines = [lines[0], [0.0, 1.0], lines[1]]
        self.number_all(case, lines, degree, lower, layer, first)

    def number_all(self, case, lines, degree, lower, layer, first):
        self.lines, self.lower = lines, lower
        dim = len(lines)
        if degree == 2:
            lines = [sorted(x + [(a + b) / 2 for a, b in zip(x, x[1:])]) for x in lines]
        shape = [len(x) for x in lines]
        self.nodes, self.number = {}, {}
        for index in itertools.product(*map(range, shape)):
            if degree == 2 and sum(k % 2 for k in index) > 1:
                continue  # serendipity: no node in the middle
            point = tuple(x[k] for x, k in zip(lines, index))
            bent = lifted(case, (point[0], point[2]) if layer else point, lower, CLEARANCE)
            point = (bent[0], point[1], bent[1]) if layer else bent
            number = first["node"] + len(self.nodes)
            self.nodes[number], self.number[index] = point, number
        self.cells = {}
        for index in itertools.product(*(range(len(x) - 1) for x in self.lines)):
            low = [degree * k for k in index]
            self.cells[first["cell"] + len(self.cells)] = [self.number[tuple(a + b for a, b in zip(low, step))] for step in steps(dim, degree)]
        self.shape, self.columns = shape, [len(x) - 1 for x in self.lines]

    def side(self, axis, end):
        """Nodes of one side of the block; `end` is 0 or -1."""
        at = 0 if end == 0 else self.shape[axis] - 1
        return [number for index, number in self.number.items() if index[axis] == at]

    def faces(self, test):
        """(cell, name of the face) of the side that touches, where the face's farthest corner passes the test of its distance to the axis."""
        last = len(self.lines) - 1
        row, name = (self.columns[last] - 1, "S3" if last == 1 else "S2") if self.lower else (0, "S1")
        found = []
        for index, cell in zip(itertools.product(*map(range, self.columns)), self.cells):
            if index[last] == row:
                corners = [x[k:k + 2] for x, k in zip(self.lines[:last], index)]
                if test(math.hypot(*(max(map(abs, c)) for c in corners[:1 if self.layered else None]))):
                    found.append((cell, name))
        return found

    @property
    def layered(self):
        return len(self.lines) == 3 and self.columns[1] == 1 and self.lines[1] == [0.0, 1.0]


class Plane(Mesh):
    """The rigid plane: cells that are held."""

    def __init__(self, case, dim, first):
        line = [0.25 * k * case.a for k in range(9)]
        if case.kind == "axisymmetric":
            line[0] = 1e-3 * case.a  # a face on the axis is a triangle in space, on which CalculiX finds no contact
        self.number_all(case, [line] * (dim - 1) + [[-case.a, 0.0]], 1, True, False, first)


def steps(dim, degree):
    """Nodes of a cell in CalculiX' order, as steps on the grid."""
    corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
    if dim == 3:
        return [(*c, z) for z in (0, 1) for c in corners]
    if degree == 1:
        return corners
    return [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)]


def slave_nodes(body, faces):
    return {n for cell, _ in faces for n in body.cells[cell]} & set(body.side(len(body.lines) - 1, 0))
