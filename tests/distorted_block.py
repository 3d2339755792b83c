#!/usr/bin/env python3
"""Writes a block of hexahedra with irregular quadrilaterals on one side, as a gmsh mesh:
distorted_block.py FILE.msh --lower x,y,z --upper x,y,z --cells n,n,n --irregular bottom|top --by 0.3 [--seed 1]

Inner vertices of that side move by up to `by` of the cell size in x and in y, those on its edges along them; the layers below or above follow
less and less. Boundaries are left, right, front, back, bottom, top, as of built-in blocks.
"""
import argparse
import random


def numbers(text):
    return [float(word) for word in text.split(",")]


def make_vertices(lower, upper, cells, irregular, by, seed):
    generator = random.Random(seed)
    moves = {(i, j): (generator.uniform(-by, by), generator.uniform(-by, by)) for i in range(cells[0] + 1) for j in range(cells[1] + 1)}
    vertices = []
    for k in range(cells[2] + 1):
        fade = (k if irregular == "top" else cells[2] - k) / cells[2]
        for j in range(cells[1] + 1):
            for i in range(cells[0] + 1):
                p = [i, j, k]
                for d in range(2):
                    if 0 < p[d] < cells[d]:
                        p[d] += fade * moves[i, j][d]
                vertices.append([a + (b - a) * q / n for a, b, q, n in zip(lower, upper, p, cells)])
    return vertices


def make_elements(cells):
    """(gmsh type, physical group, vertices): quadrilaterals of the groups 1 to 6, hexahedra of group 7."""

    def vertex(i, j, k):
        return 1 + i + (cells[0] + 1) * (j + (cells[1] + 1) * k)

    elements = []
    for d in range(3):
        e, f = [axis for axis in range(3) if axis != d]
        for side in range(2):
            for a in range(cells[e]):
                for b in range(cells[f]):
                    corners = []
                    for u, v in (0, 0), (1, 0), (1, 1), (0, 1):
                        p = [0, 0, 0]
                        p[d], p[e], p[f] = side * cells[d], a + u, b + v
                        corners.append(vertex(*p))
                    elements.append((3, 1 + 2 * d + side, corners))
    for k in range(cells[2]):
        for j in range(cells[1]):
            for i in range(cells[0]):
                square = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
                elements.append((5, 7, [vertex(*p, k) for p in square] + [vertex(*p, k + 1) for p in square]))
    return elements


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("file")
    parser.add_argument("--lower", type=numbers, default=[0, 0, 0])
    parser.add_argument("--upper", type=numbers, default=[1, 1, 1])
    parser.add_argument("--cells", type=lambda text: [int(word) for word in text.split(",")], default=[2, 2, 2])
    parser.add_argument("--irregular", choices=["bottom", "top"], default="top")
    parser.add_argument("--by", type=float, default=0.3)
    parser.add_argument("--seed", type=int, default=1)
    a = parser.parse_args()
    vertices = make_vertices(a.lower, a.upper, a.cells, a.irregular, a.by, a.seed)
    elements = make_elements(a.cells)
    names = ["left", "right", "front", "back", "bottom", "top"]
    with open(a.file, "w") as file:
        file.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n7\n")
        for i, name in enumerate(names):
            file.write(f'2 {i + 1} "{name}"\n')
        file.write(f'3 7 "block"\n$EndPhysicalNames\n$Nodes\n{len(vertices)}\n')
        for i, p in enumerate(vertices):
            file.write(f"{i + 1} " + " ".join(f"{x:.12g}" for x in p) + "\n")
        file.write(f"$EndNodes\n$Elements\n{len(elements)}\n")
        for i, (kind, group, corners) in enumerate(elements):
            file.write(f"{i + 1} {kind} 2 {group} {group} " + " ".join(map(str, corners)) + "\n")
        file.write("$EndElements\n")


if __name__ == "__main__":
    main()
