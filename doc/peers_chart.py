#!/usr/bin/env python3
"""Error against seconds, of Amontons and beside other programs: draws doc/pictures/peers*.svg from doc/peers.csv, which tests/peers/peers.py --write doc/peers.csv and tests/peers/ironing.py --lot
--write doc/peers.csv measure."""
import csv
import dataclasses
import math
import pathlib

from figures import BLUE, FOLDER, GREEN, GREY, INK, RED, Figure

TABLE = pathlib.Path(__file__).resolve().parent / "peers.csv"
ORANGE, VIOLET = "#c98a1b", "#7a4fa3"
# program, formulations, colour, dashes, label; hollow dots where there are dashes
CURVES = [
    ("Amontons", ["degree 1"], BLUE, "5 3", "Amontons, linear"), ("Amontons", ["degree 2"], BLUE, "", "Amontons, quadratic"),
    ("GetFEM5.4.2", ["ALM-Q1/Q1"], GREEN, "5 3", "GetFEM, linear"), ("GetFEM5.4.2", ["ALM-Q2/Q2"], GREEN, "", "GetFEM, quadratic"),
    ("ccx2.20", ["f2f/CPE4", "f2f/CAX4", "f2f/C3D8"], RED, "5 3", "CalculiX, face to face, linear"), ("ccx2.20", ["MORTAR/C3D8"], ORANGE, "5 3", "CalculiX, mortar, linear")]
PIN = CURVES[:5] + [("ccx2.20", ["f2f/CPE8"], RED, "", "CalculiX, face to face, quadratic")] + CURVES[5:]


IRONING_FLOOR = 0.005  # by which two programs differ on the finest mesh


def ours(form, *look):
    return "Amontons", [form], *look


PIN_OURS = [
    ours("degree 1", BLUE, "5 3", "linear, adaptive"), ours("degree 2", BLUE, "", "quadratic, adaptive"), ours("degree 1 uniform", GREY, "5 3", "linear, uniform"),
    ours("degree 2 uniform", GREY, "", "quadratic, uniform"), ours("degree 2 targets", INK, "", "quadratic, targets"), ours("degree 2 penalty 10", ORANGE, "5 3", "penalty, factor 10"),
    ours("degree 2 penalty 1000", ORANGE, "", "penalty, factor 1000"), ours("degree 2 augmented Lagrangian", GREEN, "", "augmented Lagrangian"),
    ours("degree 2 node-to-segment", RED, "", "node-to-segment"), ours("degree 2 seed", VIOLET, "5 3", "seed")]
IRONING = [
    ours("degree 1 mortar", BLUE, "5 3", "Amontons, linear"), ("GetFEM5.4.2", ["ray-tracing Q1 r=10E"], GREEN, "5 3", "GetFEM, ray tracing, linear"),
    ("ccx2.20", ["f2f K=10E"], RED, "5 3", "CalculiX, face to face, 10 E"), ("ccx2.20", ["f2f K=100E"], ORANGE, "5 3", "CalculiX, face to face, 100 E")]
IRONING_OURS = [
    ours("degree 1 mortar", BLUE, "5 3", "linear, dual mortar"), ours("degree 2 mortar", BLUE, "", "quadratic, dual mortar"), ours("degree 1 mortar adaptive", INK, "", "linear, adaptive"),
    ours("degree 1 penalty 10", ORANGE, "5 3", "penalty, factor 10"), ours("degree 1 penalty 1000", ORANGE, "", "penalty, factor 1000"),
    ours("degree 1 augmented Lagrangian", GREEN, "", "augmented Lagrangian")]


@dataclasses.dataclass(frozen=True)
class Panel:
    case: str
    title: str
    seconds: tuple
    errors: tuple
    curves: list
    floor: float = 0.0  # what is known no better: smaller errors are drawn there


def pictures():
    """Panels of each picture, and what its errors are of."""
    pressure = "error of the pressure"
    return {
        "peers": (pressure, [Panel("H2", "cylinder, without friction", (0.2, 40), (7e-4, 0.1), CURVES), Panel("CM", "cylinder, with friction", (0.3, 40), (7e-4, 0.1), CURVES)]),
        "peers_sphere": (pressure, [Panel("HA", "sphere, axisymmetric", (0.1, 15), (1e-3, 0.1), CURVES), Panel("H3", "sphere, in space", (0.3, 50), (3e-3, 0.2), CURVES)]),
        "peers_pin": (pressure, [Panel("PI", "pin with clearance: Amontons", (0.3, 20), (1e-3, 0.2), PIN_OURS), Panel("PI", "the same beside other programs", (0.2, 20), (1e-3, 0.6), PIN)]),
        "peers_ironing": ("error of the forces", [Panel("IR2", "ironing: Amontons", (2, 200), (3e-3, 0.6), IRONING_OURS, IRONING_FLOOR), Panel("IR2", "the same beside other programs", (2, 200), (3e-3, 0.6), IRONING, IRONING_FLOOR)])}


MARKS = [a * 10**k for k in range(-4, 3) for a in (1, 3)]
UPPER, WIDTH, HEIGHT = 52, 310, 262


def read():
    with open(TABLE, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def rows_of(rows, panel, curve):
    return [row for row in rows if (row["program"], row["case"]) == (curve[0], panel.case) and row["formulation"] in curve[1]]


def points_of(rows, panel, curve):
    """Seconds and errors, by seconds."""
    return sorted((float(row["cpu"]), max(float(row["error"]), panel.floor)) for row in rows_of(rows, panel, curve) if row["error"])


def draw_panel(f, rows, panel, left):
    (low, high), (bottom, top) = panel.seconds, panel.errors

    def place(x, y):
        return left + WIDTH * math.log(x / low) / math.log(high / low), UPPER + HEIGHT * math.log(top / y) / math.log(top / bottom)

    f.text(left + WIDTH / 2, 22, panel.title, INK, "middle", 14, True)
    for x in (x for x in MARKS if low * 0.999 <= x <= high * 1.001):
        f.line([place(x, top), place(x, bottom)], "#e4e7ea", 1)
        f.text(*map(sum, zip(place(x, bottom), (0, 17))), f"{x:g}", INK, "middle", 12)
    for y in (y for y in MARKS if bottom * 0.999 <= y <= top * 1.001):
        f.line([place(low, y), place(high, y)], "#e4e7ea", 1)
        f.text(left - 6, place(low, y)[1] + 4, f"{100 * y:g} %", INK, "end", 12)
    f.line([place(low, top), place(low, bottom), place(high, bottom)], GREY, 1)
    f.text(left + WIDTH / 2, UPPER + HEIGHT + 36, "processor seconds of the whole process", INK, "middle", 13)
    if panel.floor:
        f.line([place(low, panel.floor), place(high, panel.floor)], GREY, 1.2, "2 3")
        f.text(left + 6, place(low, panel.floor)[1] + 15, "known no better", GREY, "start", 11)
    for curve in panel.curves:
        colour, dash = curve[2:4]
        points = [place(*point) for point in points_of(rows, panel, curve) if bottom <= point[1] <= top and low <= point[0] <= high]
        f.line(points, colour, 2, dash) if len(points) > 1 else None
        for point in points:
            f.dot(*point, colour, 3.5, hollow=bool(dash))


def legend(f, rows, panel, left, step, lines):
    for k, curve in enumerate(panel.curves):
        _, _, colour, dash, label = curve
        here = rows_of(rows, panel, curve)
        label += ": reaches no end" if here and all("not finished" in row["note"] for row in here) else ""
        x, y = left + step * (k // lines), 384 + 24 * (k % lines)
        f.line([(x, y), (x + 34, y)], colour, 2, dash)
        f.dot(x + 17, y, colour, 3.5, hollow=bool(dash))
        f.text(x + 42, y + 5, label, INK, "start", 13)


def draw(rows, name, what, panels):
    shared = all(panel.curves is panels[0].curves for panel in panels)
    lines = 2 if shared else max(len(panel.curves) if len(panel.curves) < 8 else 5 for panel in panels)
    f = Figure(name, 760, 384 + 24 * lines)
    f.path = FOLDER / f"{name}.svg"
    for column, panel in enumerate(panels):
        left = 62 + 370 * column
        draw_panel(f, rows, panel, left)
    f.text(8, 38, what, INK, "start", 11)
    for column, panel in enumerate(panels if not shared else []):
        legend(f, rows, panel, 12 + 410 * column, 185, lines)
    if shared:
        legend(f, rows, panels[0], 62, 220, lines)
    f.save()


def main():
    rows = read()
    for name, (what, panels) in pictures().items():
        draw(rows, name, what, panels)


if __name__ == "__main__":
    main()
