"""What the cases of the scorecard (scorecard.py) are made of: runs, measures of their answers, rows of the table.

A case is a function of a Runner that returns rows. Bounds of rows have two parts: `floor`, what the model or the digits of the reference leave open (with
its origin), and `estimate`, what the program itself says that this quantity is off by.
"""
import csv
import json
import math
import os
import pathlib
import tempfile
from dataclasses import dataclass

import launch

PARAMETERS = pathlib.Path(__file__).resolve().parent.parent / "parameters"
LIMIT = 240
TOLERANCE = 1e-9  # of the contact solver: "exact" is no better
CASES = []


@dataclass
class Case:
    name: str
    title: str
    group: str
    function: object
    small: bool  # part of the test


def case(name, title, group, small=False):
    """Registers the function that follows."""

    def register(function):
        CASES.append(Case(name, title, group, function, small))
        return function

    return register


@dataclass
class Row:
    quantity: str
    reference: float
    ours: float
    floor: float = 0.0
    origin: str = ""  # of the floor
    estimate: float = 0.0
    published: str = ""
    scale: float = None  # of the error, where the reference is zero

    @property
    def error(self):
        return abs(self.ours - self.reference) / abs(self.scale or self.reference)

    @property
    def bound(self):
        return self.floor + self.estimate

    @property
    def green(self):
        return self.error <= self.bound  # false for nan


class NoAnswer(Exception):
    """A run that did not converge."""


class Runner:
    """Starts scenes, and adds up their processor seconds."""

    def __init__(self, program):
        self.program, self.seconds, self.version = program, 0.0, ""

    def __call__(self, scene, *sets, text="", limit=LIMIT, fails=False):
        """The answer of parameters/SCENE with these entries set, and with this text appended to it (scenes that name no files, then)."""
        with tempfile.TemporaryDirectory(prefix="amontons-scorecard-") as folder:
            path, log = PARAMETERS / scene, os.path.join(folder, "log")
            if text:
                path = pathlib.Path(folder) / "scene.prm"
                path.write_text(f"include {PARAMETERS / scene}\n\n{text}")
            command = [str(self.program), str(path), "--output", folder, "--quiet"]
            for entry in ("Output/VTU=false", "Output/Report=false", *sets):
                command += ["--set", entry]
            code, seconds = launch.timed(command, limit, log)
            self.seconds += seconds
            answer = Answer(folder, log)
        self.version = answer.summary.get("version", "") + " " + answer.summary.get("commit", "")
        if not fails and (code != 0 or answer.summary.get("status") != "converged"):
            raise NoAnswer(f"exit code {code}: " + (answer.summary.get("message") or answer.log[-300:]))
        return answer


def table(path):
    def cell(text):
        try:
            return float(text)
        except ValueError:
            return text

    if not os.path.exists(path):
        return []
    with open(path) as file:
        return [{key: cell(value) for key, value in row.items()} for row in csv.DictReader(file)]


SAMPLES = 12  # of an element, for integrals


def elements(rows):
    """Nodes of each face along a line: three where every second one is in the middle of its neighbours (quadratic elements), else two."""

    def way(a, b):
        return math.hypot(a["X"] - b["X"], a["Y"] - b["Y"])

    triples = [rows[k : k + 3] for k in range(0, len(rows) - 2, 2)]
    middle = all(abs(way(a, b) - way(b, c)) < 0.02 * way(a, c) for a, b, c in triples)
    return triples if len(rows) % 2 == 1 and middle else [rows[k : k + 2] for k in range(len(rows) - 1)]


def interpolate(nodes, s, key):
    """Lagrange's polynomial."""
    result = 0.0
    for a in nodes:
        result += a[key] * math.prod((s - b["s"]) / (a["s"] - b["s"]) for b in nodes if b is not a)
    return result


class Answer:
    def __init__(self, folder, log):
        with open(log) as file:
            self.log = file.read()
        path = os.path.join(folder, "summary.json")
        self.summary = {}
        if os.path.exists(path):
            with open(path) as file:
                self.summary = json.load(file)
        self.contact, self.history = table(os.path.join(folder, "contact.csv")), table(os.path.join(folder, "history.csv"))
        self.kind = self.summary.get("kind")

    # ---- What the program says of its own error

    def estimate(self, *increments):
        """Of the pressure, or of the tangential traction for "shear"; with friction also of these quantities by the increments."""
        told, errors = self.summary.get("increments", {}), self.summary["error_estimate"]
        return (errors["shear"] if "shear" in increments else errors["contact"]) + sum(told.get(name) or 0 for name in increments)

    @property
    def bulk(self):
        """Of the stress, over all bodies."""
        return self.summary["error_estimate"]["bulk"]

    # ---- Contact nodes

    def nodes(self, pair=None):
        return [row for row in self.contact if pair in (None, row["pair"])]

    def distance(self, row):
        return row["X"] if self.kind == "axisymmetric" else math.hypot(row["X"], row["Y"]) if self.kind == "3D" else row["X"]

    @staticmethod
    def normal(row):
        return -sum(row["f" + c] * row["n" + c] for c in "xyz")

    def force(self, pair=None):
        """Nodal forces along the normals: of the meshed part."""
        return math.fsum(self.normal(row) for row in self.nodes(pair))

    def size(self, pair=None):
        """Half-width or radius from the spread of nodal forces."""
        factor = 4 if self.kind.startswith("plane") else 2.5
        rows = self.nodes(pair)
        return math.sqrt(factor * math.fsum(self.normal(r) * self.distance(r) ** 2 for r in rows) / math.fsum(self.normal(r) for r in rows))

    def line(self, pair=None, coordinate=None):
        """Elements of a plane or axisymmetric surface, their nodes with the coordinate s (X, if nothing is said) along it."""
        rows = [dict(row, s=coordinate(row) if coordinate else row["X"]) for row in self.nodes(pair)]
        return elements(sorted(rows, key=lambda row: row["s"]))

    def at(self, s, key="pressure", **where):
        """Value at a place on the surface."""
        parts = self.line(**where)
        return interpolate(next((nodes for nodes in parts if s <= nodes[-1]["s"]), parts[-1]), s, key)

    def profile(self, exact, low, high, key="pressure", scale=None, weight=lambda s: 1.0, **where):
        """Relative L2 difference of a quantity over low < s < high to a function (or relative to the norm of the function `scale`)."""
        difference = square = 0.0
        for nodes in self.line(**where):
            left, right = max(nodes[0]["s"], low), min(nodes[-1]["s"], high)
            for j in range(SAMPLES if right > left else 0):
                s = left + (right - left) * (j + 0.5) / SAMPLES
                difference += (interpolate(nodes, s, key) - exact(s)) ** 2 * weight(s) * (right - left)
                square += (scale or exact)(s) ** 2 * weight(s) * (right - left)
        return math.sqrt(difference / square)

    def worst(self, value, key="pressure", where=lambda row: True, pair=None):
        """Value of the closed node that is farthest from this."""
        values = [row[key] for row in self.nodes(pair) if row["state"] != "open" and where(row)]
        return max(values, key=lambda v: abs(v - value), default=math.nan)

    # ---- Elsewhere

    def probe(self, name, k=0):
        return next(p for p in self.summary["probes"] if p["name"] == name)["points"][k]

    def pair(self, name=None):
        return next(p for p in self.summary["pairs"] if name in (None, p["name"]))

    def finest(self, t):
        """Row of the history at this time, on the last mesh."""
        last = self.history[-1]["mesh"]
        return min((row for row in self.history if row["mesh"] == last), key=lambda row: abs(row["t"] - t))


def section(title, **entries):
    lines = [f"  set {name.replace('_', ' ')} = {value}" for name, value in entries.items()]
    return "\n".join([f"subsection {title}"] + lines + ["end", ""])


def digits(value, unit):
    """Half a unit of the last digit of a published number, relative."""
    return 0.5 * unit / abs(value)
