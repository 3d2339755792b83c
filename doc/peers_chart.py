#!/usr/bin/env python3
"""Error against seconds beside other programs: draws doc/pictures/peers.svg and peers_sphere.svg from doc/peers.csv, which tests/peers/peers.py --write doc/peers.csv measures."""
import csv
import math
import pathlib

from figures import BLUE, FOLDER, GREEN, GREY, INK, RED, Figure

TABLE = pathlib.Path(__file__).resolve().parent / "peers.csv"
# case: title, seconds, errors
PANELS = {"H2": ("cylinder, without friction", (0.2, 40), (1e-3, 0.1)), "CM": ("cylinder, with friction", (0.3, 40), (1e-3, 0.1)),
          "HA": ("sphere, axisymmetric", (0.1, 15), (1e-3, 0.1)), "H3": ("sphere, in space", (0.3, 50), (3e-3, 0.2))}
PICTURES = {"peers": ("H2", "CM"), "peers_sphere": ("HA", "H3")}
CURVES = [
    ("Amontons", ["degree 1"], BLUE, "5 3", "Amontons, linear"), ("Amontons", ["degree 2"], BLUE, "", "Amontons, quadratic"),
    ("GetFEM5.4.2", ["ALM-Q1/Q1"], GREEN, "5 3", "GetFEM, linear"), ("GetFEM5.4.2", ["ALM-Q2/Q2"], GREEN, "", "GetFEM, quadratic"),
    ("ccx2.20", ["f2f/CPE4", "f2f/CAX4", "f2f/C3D8"], RED, "5 3", "CalculiX, face to face, linear"), ("ccx2.20", ["MORTAR/C3D8"], "#c98a1b", "5 3", "CalculiX, mortar, linear")]
MARKS = [a * 10**k for k in range(-4, 3) for a in (1, 3)]


def read():
    with open(TABLE, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def panel(f, rows, case, left):
    title, (low, high), (bottom, top) = PANELS[case]
    upper, width, height = 52, 310, 262

    def place(x, y):
        return left + width * math.log(x / low) / math.log(high / low), upper + height * math.log(top / y) / math.log(top / bottom)

    f.text(left + width / 2, 22, title, INK, "middle", 14, True)
    for x in (x for x in MARKS if low * 0.999 <= x <= high * 1.001):
        f.line([place(x, top), place(x, bottom)], "#e4e7ea", 1)
        f.text(*map(sum, zip(place(x, bottom), (0, 17))), f"{x:g}", INK, "middle", 12)
    for y in (y for y in MARKS if bottom * 0.999 <= y <= top * 1.001):
        f.line([place(low, y), place(high, y)], "#e4e7ea", 1)
        f.text(left - 6, place(low, y)[1] + 4, f"{100 * y:g} %", INK, "end", 12)
    f.line([place(low, top), place(low, bottom), place(high, bottom)], GREY, 1)
    f.text(left + width / 2, upper + height + 36, "processor seconds of the whole process", INK, "middle", 13)
    for program, formulations, colour, dash, _ in CURVES:
        points = sorted((float(row["cpu"]), float(row["error"])) for row in rows
                        if (row["program"], row["case"]) == (program, case) and row["formulation"] in formulations)
        points = [place(*point) for point in points if point[1] <= top and point[0] >= low]
        f.line(points, colour, 2, dash) if len(points) > 1 else None
        for point in points:
            f.dot(*point, colour, 3.5, hollow=bool(dash))


def draw(rows, name, cases):
    f = Figure(name, 760, 432)
    f.path = FOLDER / f"{name}.svg"
    for column, case in enumerate(cases):
        panel(f, rows, case, 62 + 370 * column)
    f.text(8, 38, "error of the pressure", INK, "start", 11)
    for k, (_, _, colour, dash, label) in enumerate(CURVES):
        x, y = 62 + 220 * (k // 2), 384 + 24 * (k % 2)
        f.line([(x, y), (x + 34, y)], colour, 2, dash)
        f.dot(x + 17, y, colour, 3.5, hollow=bool(dash))
        f.text(x + 42, y + 5, label, INK, "start", 13)
    f.save()


def main():
    rows = [row for row in read() if row["error"]]
    for name, cases in PICTURES.items():
        draw(rows, name, cases)


if __name__ == "__main__":
    main()
