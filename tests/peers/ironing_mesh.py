"""Shallow ironing as parameters/ironing.prm has it: material, places of nodes of the block and of the die, its path."""
import math

BLOCK, DIE, NU, FRICTION = 68.96, 689.6, 0.32, 0.3
PRESS = 1.0


def graded(low, high, cells, ratio):
    """Places of cells whose last is `ratio` times as large as the first."""
    q = ratio ** (1 / (cells - 1))
    sizes = [q**k for k in range(cells)]
    return [low + (high - low) * sum(sizes[:k]) / sum(sizes) for k in range(cells + 1)]


def arc(centre, radius, start, end, cells):
    angles = [start + (end - start) * k / cells for k in range(cells + 1)]
    return [(centre[0] + radius * math.cos(t), centre[1] + radius * math.sin(t)) for t in angles]


def die():
    """Its nodes [i][j], i along the bottom (fillet, arc, fillet) and j upwards: transfinite, as parameters/ironing.geo has it."""
    fillet, radius = 0.15, 0.75
    dx = 0.6 - fillet
    dy = math.sqrt((radius - fillet) ** 2 - dx**2)
    meet = math.atan2(-dy, dx)  # of the right fillet and the arc, seen from either centre
    left = arc((1 - dx, radius - dy), fillet, math.pi, math.pi - meet, 2)
    right = arc((1 + dx, radius - dy), fillet, meet, 0, 2)
    bottom = left + arc((1, radius), radius, math.pi - meet, 2 * math.pi + meet, 10)[1:] + right[1:]
    top = [(0.4 + 1.2 * k / 14, 1.2) for k in range(15)]
    nodes = []
    for i, (low, high) in enumerate(zip(bottom, top)):
        s = i / 14
        column = []
        for t in (j / 6 for j in range(7)):
            sides = [(1 - t) * a + t * b for a, b in zip(bottom[0], top[0])], [(1 - t) * a + t * b for a, b in zip(bottom[14], top[14])]
            corners = [(1 - s) * a + s * b for a, b in zip(*sides)]
            column.append(tuple((1 - t) * low[d] + t * high[d] + (1 - s) * sides[0][d] + s * sides[1][d] - corners[d] for d in (0, 1)))
        nodes.append(column)
    return nodes
