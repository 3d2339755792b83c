"""Reads back what a run has written beside summary.json and compares it: contact.csv, history.csv, contact.pvd, bodies.pvd, report.html, terminal.

check(output, text) yields (what, good, detail). text: what the run wrote on the terminal; summary.json is what the rest must agree with.
"""
import base64
import csv
import html
import json
import math
import os
import re
import struct
import xml.etree.ElementTree
import zlib

AXES = "xyz"


def close(a, b, tolerance, scale=0.0):
    if a is None or b is None or math.isnan(a) or math.isnan(b):
        return (a is None or math.isnan(a)) and (b is None or math.isnan(b))
    return abs(a - b) <= tolerance * max(abs(b), scale)


def short(number):
    return "-" if number is None or not math.isfinite(number) else f"{number:.5g}"


def percent(fraction):
    return "unknown" if fraction is None else short(100 * fraction) + " %"


def norm(v):
    return math.sqrt(sum(x * x for x in v))


def vector(v):
    return "(" + ", ".join(short(x if abs(x) > 1e-12 * norm(v) else 0) for x in v) + ")"


def table(path):
    with open(path) as file:
        rows = list(csv.DictReader(file))
    return [{key: text if key in ("pair", "state") else float(text) for key, text in row.items()} for row in rows]


# ---- VTU


def array(element, compressed):
    """The numbers of a DataArray: ASCII, base64, or base64 of zlib's."""
    text = element.text.strip()
    code = {"Float64": "d", "Float32": "f", "Int32": "i", "UInt32": "I", "UInt8": "B", "Int64": "q", "UInt64": "Q"}[element.get("type")]
    if element.get("format") == "ascii":
        return [float(word) for word in text.split()]
    if compressed:
        n_blocks, _, _, _ = struct.unpack("<4I", base64.b64decode(text[:24]))
        assert n_blocks == 1
        data = zlib.decompress(base64.b64decode(text[24:]))
    else:
        data = base64.b64decode(text)
        (n_bytes,) = struct.unpack("<I", data[:4])
        data = data[4:]
        assert len(data) == n_bytes
    return list(struct.unpack("<%d%s" % (len(data) // struct.calcsize(code), code), data))


def piece(path):
    """{name: list of numbers or of tuples} of a .vtu file; points of cells as "cells"."""
    root = xml.etree.ElementTree.parse(path).getroot()
    compressed = root.get("compressor") is not None
    result = {"n_points": int(root.find(".//Piece").get("NumberOfPoints")), "n_cells": int(root.find(".//Piece").get("NumberOfCells"))}
    for element in root.iter("DataArray"):
        data, n = array(element, compressed), int(element.get("NumberOfComponents", 1))
        result[element.get("Name", "Points")] = [tuple(data[i : i + n]) for i in range(0, len(data), n)] if n > 1 else data
    ends = [int(i) for i in result["offsets"]]
    points = [int(i) for i in result["connectivity"]]
    result["cells"] = [points[a:b] for a, b in zip([0] + ends, ends)]
    return result


def records(path):
    """[(t, file)] of a .pvd file."""
    return [(float(d.get("timestep")), os.path.join(os.path.dirname(path), d.get("file"))) for d in xml.etree.ElementTree.parse(path).getroot().iter("DataSet")]


def pieces(path):
    """Those of a .pvtu file, or the one file."""
    if not path.endswith(".pvtu"):
        return [piece(path)]
    found = [p.get("Source") for p in xml.etree.ElementTree.parse(path).getroot().iter("Piece")]
    return [piece(os.path.join(os.path.dirname(path), name)) for name in found]


def area_of(points):
    """Length of a line; area of a quadrilateral in space."""
    if len(points) == 2:
        return math.dist(*points)
    a, b = ([points[j][d] - points[i][d] for d in range(3)] for i, j in ((0, 2), (1, 3)))
    return 0.5 * norm([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def check_contact(output, summary, contact):
    """contact.csv in itself, against the summary, and against the last contact_*.vtu."""
    for pair in summary["pairs"]:
        rows = [r for r in contact if r["pair"] == pair["name"] and r["area"] > 0]
        for state in "open", "stick", "slip":
            n = sum(r["state"] == state for r in rows)
            yield f"contact.csv: {pair['name']}: {state} nodes", n == pair["n_" + state], f"{n}, {pair['n_' + state]}"
        largest = max([abs(r["pressure"]) for r in rows], default=0)
        size = max([norm([r[c] for c in AXES.upper()]) for r in rows], default=1)
        for names, what in (("tx ty tz", "traction"), ("slip_x slip_y slip_z", "slip")):
            across = max([abs(sum(r["n" + c] * r[name] for c, name in zip(AXES, names.split()))) for r in rows], default=0)
            yield f"contact.csv: {pair['name']}: {what} is tangential", across <= 1e-3 * (largest if what == "traction" else size), across
        yield f"contact.csv: {pair['name']}: unit normals", all(close(norm([r["n" + c] for c in AXES]), 1, 1e-9) for r in rows), ""

    t, path = records(os.path.join(output, "contact.pvd"))[-1]
    yield "contact.pvd: last time", close(t, summary["meshes"][-1]["t"], 1e-9), t
    vtu = piece(path)
    names = [p["name"] for p in summary["pairs"]]
    states = {"open": 0, "slip": 1, "stick": 2}
    nodes = {}
    for i in range(vtu["n_points"]):
        place = (names[int(vtu["pair"][i])],) + tuple(round(x, 7) for x in vtu["Points"][i])
        nodes.setdefault(place, []).append(i)
    yield "contact.vtu: as many points as contact.csv has rows", vtu["n_points"] == len(contact), f"{vtu['n_points']}, {len(contact)}"
    largest = {key: max([abs(r[key]) for r in contact if not math.isnan(r[key])], default=0) for key in contact[0] if key not in ("pair", "state")}
    wrong = {key: [] for key in ("pressure", "gap", "state", "normal", "traction", "slip", "displacement", "place")}
    for r in contact:
        here = nodes.get((r["pair"],) + tuple(round(r[c], 7) for c in "XYZ"), [])
        scale = max(largest["pressure"], 1e-300)

        def differs(i):
            found = []
            for key, value, unit in (("pressure", r["pressure"], scale), ("gap", r["gap"], largest["gap"])):
                if not close(vtu[key][i], value, 1e-9, unit):
                    found.append(key)
            for key, columns, unit in (("normal", "nx ny nz", 1), ("traction", "tx ty tz", scale), ("slip", "slip_x slip_y slip_z", 1)):
                if not all(close(v, r[c], 1e-9, unit) for v, c in zip(vtu[key][i], columns.split())):
                    found.append(key)
            if not all(close(v, r[c] - r[c.upper()], 1e-9, max(largest["x"], largest["y"], largest["z"])) for v, c in zip(vtu["displacement"][i], AXES)):
                found.append("displacement")
            if int(vtu["state"][i]) != states[r["state"]]:
                found.append("state")
            return found

        best = min((differs(i) for i in here), key=len, default=["place"])
        for key in best:
            wrong[key].append((r["X"], r["Y"], r["Z"]))
    for key, where in wrong.items():
        yield f"contact.vtu: {key} as in contact.csv", not where, where[:3]
    moved = any(abs(r[c] - r[c.upper()]) > 0 for r in contact for c in AXES)
    yield "contact.csv: nodes move", moved, ""
    yield "contact.vtu: pieces of surfaces", all(len(set(c)) == len(c) == (2 if summary["dimension"] == 2 else 4) for c in vtu["cells"]), ""
    sizes = [area_of([vtu["Points"][i] for i in c]) for c in vtu["cells"]]
    yield "contact.vtu: no piece without area", min(sizes, default=1) > 0, min(sizes, default=1)
    used = {i for c in vtu["cells"] for i in c}
    yield "contact.vtu: each point belongs to a piece", len(used) == vtu["n_points"], f"{len(used)}, {vtu['n_points']}"


def check_bodies(output, summary, contact, t):
    last, path = records(os.path.join(output, "bodies.pvd"))[-1]
    yield "bodies.pvd: last time", close(last, t, 1e-9), last
    names = summary["probes"][0]["points"][0]["stress"].keys() if summary["probes"] and summary["probes"][0]["points"][0]["stress"] else []
    places, n_cells, largest_u, largest_s, wrong_mises, empty = {}, 0, 0, 0, 0, 0
    for part in pieces(path):
        stresses = [name for name in part if name.startswith("stress_")]
        normal = [part[name] for name in stresses if name[-2] == name[-1]]
        shear = [part[name] for name in stresses if name[-2] != name[-1]]
        n_cells += part["n_cells"]
        for cell in part["cells"]:
            empty += len(set(part["Points"][i] for i in cell)) < 2 ** summary["dimension"]
        for i in range(part["n_points"]):
            s, q = [v[i] for v in normal], [v[i] for v in shear]
            mises = math.sqrt(0.5 * sum((a - b) ** 2 for a, b in ((s[0], s[1]), (s[1], s[2]), (s[2], s[0]))) + 3 * sum(x * x for x in q))
            largest_s = max([largest_s] + [abs(x) for x in s + q])
            wrong_mises = max(wrong_mises, abs(mises - part["von_mises"][i]))
            u = part["displacement"][i]
            largest_u = max(largest_u, norm(u))
            X = tuple(part["Points"][i])
            places.setdefault(tuple(round(x, 4) for x in X), []).append((X, u, {n: part["stress_" + n][i] for n in names}, part["von_mises"][i]))
    with open(summary["scene"]) as scene:
        n_bodies = sum(line.split()[:2] == ["subsection", "Body"] for line in scene)
    bodies = {label for part in pieces(path) for label in part["body"]}
    yield "bodies.vtu: body", bodies == set(range(n_bodies)), sorted(bodies)
    subdivisions = n_cells / summary["cells"]
    yield "bodies.vtu: cells", subdivisions in (1, 2 ** summary["dimension"]) and not empty, f"{n_cells} of {summary['cells']}, {empty} empty"
    yield "bodies.vtu: von Mises of the stresses", wrong_mises <= 1e-5 * largest_s, wrong_mises

    def here(X):
        X = tuple(X) + (0.0,) * (3 - len(X))
        found = []
        for d in range(8):
            key = tuple(round(x + (1e-6 if d >> k & 1 else -1e-6) * max(1, abs(x)), 4) for k, x in enumerate(X))
            found += [p for p in places.get(key, []) if math.dist(p[0], X) <= 3e-6 * max(1, norm(X))]
        return found

    n, wrong = 0, []
    for r in contact:
        u = [r[c] - r[c.upper()] for c in AXES]
        points = here([r[c] for c in "XYZ"])
        n += bool(points)
        if points and min(math.dist(p[1], u) for p in points) > 1e-5 * largest_u + 1e-9 * norm([r[c] for c in AXES]):
            wrong.append([r[c] for c in "XYZ"])
    yield "bodies.vtu: displacement as in contact.csv", n > 0 and not wrong, f"{n} nodes, {wrong[:3]}"
    n, wrong = 0, []
    for probe in summary["probes"]:
        for point in probe["points"]:
            if point["displacement"] is None:
                continue
            found = here(point["point"])
            n += bool(found)
            good = [
                p
                for p in found
                if all(close(v, w, 1e-5, largest_u) for v, w in zip(p[1], point["displacement"]))
                and all(close(p[2][c], point["stress"][c], 1e-5, largest_s) for c in names)
                and close(p[3], point["von_mises"], 1e-5, largest_s)
            ]
            if found and not good:
                wrong.append(point["point"])
    if summary["probes"]:
        yield "bodies.vtu: displacement and stress as at the probes", n > 0 and not wrong, f"{n} points, {wrong[:3]}"


# ---- history.csv


def columns_of(mesh, kind):
    """What a row of the table must hold, by the names of the columns."""
    row = {key: mesh[key] for key in ("increment", "t", "mesh", "cells", "dofs", "iterations", "energy")}
    row["error_bulk"], row["error_contact"] = mesh["error_estimate"]["bulk"], mesh["error_estimate"]["contact"]
    axes = ["r", "z"] if kind == "axisymmetric" else AXES
    for pair in mesh["pairs"]:
        for force in "normal_force", "tangential_force":
            row.update({f"{pair['name']}.{force}_{c}": v for c, v in zip(axes, pair[force])})
        row.update({f"{pair['name']}.{key}": pair[key] for key in ("peak_pressure", "contact_size", "n_open", "n_stick", "n_slip")})
        if pair["stick_size"] is not None:
            row[f"{pair['name']}.stick_size"] = pair["stick_size"]
    if "external_work" in mesh:
        row.update({key: mesh[key] for key in ("external_work", "contact_work", "dissipation")})
        known = mesh["contact_work"] is not None  # not where the increment was solved again on a finer mesh
        row["contact_work_minus_dissipation"] = mesh["contact_work"] - mesh["dissipation"] if known else None
    return row


def check_history(summary, history):
    yield "history.csv: rows", len(history) == len(summary["meshes"]), f"{len(history)}, {len(summary['meshes'])}"
    wrong = []
    for mesh, row in zip(summary["meshes"], history):
        for key, value in columns_of(mesh, summary["kind"]).items():
            if key not in row or not close(row[key], float("nan") if value is None else value, 1e-12, 1e-300):
                wrong.append(f"{key}: {row.get(key)} and {value}")
    yield "history.csv: numbers of the summary", not wrong, wrong[:3]
    last, wrong = history[-1], []
    axes = ["r", "z"] if summary["kind"] == "axisymmetric" else AXES
    for probe in summary["probes"]:
        for i, point in enumerate(probe["points"]):
            name = probe["name"] + (f"[{i}]" if len(probe["points"]) > 1 else "")
            if point["displacement"] is None:
                continue
            wanted = {f"{name}.u_{c}": v for c, v in zip(axes, point["displacement"])}
            wanted.update({f"{name}.stress_{c}": v for c, v in point["stress"].items()})
            wanted[f"{name}.von_mises"] = point["von_mises"]
            wrong += [key for key, value in wanted.items() if not close(last.get(key), value, 1e-12, 1e-300)]
    yield "history.csv: probes", not wrong, wrong[:3]
    newton = summary["newton"]
    for key in "krylov_iterations", "residual":
        column = "krylov" if key == "krylov_iterations" else key
        yield f"history.csv: {column}", all(any(close(row[column], n[key], 1e-12) and n["dofs"] == row["dofs"] for n in newton) for row in history), ""


# ---- terminal and report


def estimate(summary, key):
    """The error of the mesh with that of the increments, as the sides of a right triangle, and kinematics on top: "1.5 %   (mesh 1 %, kinematics 0.5 %)"."""
    of = summary["error_estimate"]
    total, parts = of[key], ["mesh " + percent(of[key])]
    if key == "contact" and of["facets"] > 1e-3:
        parts.append("of which facets " + percent(of["facets"]))
    kinematics, increments = ("shear_kinematics", "shear") if key == "shear" else ("kinematics", "pressure")
    others = {"kinematics": of.get(kinematics), "increments": summary.get("increments", {}).get(increments)}
    total = math.hypot(total, others["increments"] or 0) + (others["kinematics"] or 0)
    for name, error in others.items():
        if error is not None:
            parts.append(f"{name} {percent(error)}")
    alone = total == of[key] and others["increments"] is None and len(parts) <= 2 and "facets" not in parts[-1]
    return percent(total) + ("" if alone else f"   ({', '.join(parts)})")


def expected_lines(summary):
    """{label: text} of the answer, as people read it."""
    lines = []
    round_kind = summary["kind"] in ("3D", "axisymmetric")
    full_turn = ", full turn" if summary["kind"] == "axisymmetric" else ""
    for p in summary["pairs"]:
        normal = norm(p["normal_force"])
        lines.append(("  normal force", short(normal) + "   " + vector(p["normal_force"]) + full_turn))
        if norm(p["tangential_force"]) > 1e-12 * normal:
            lines.append(("  tangential force", vector(p["tangential_force"]) + full_turn))
        lines.append(("  peak pressure", short(p["peak_pressure"])))
        if p["n_open"] > 0:
            lines.append(("  contact radius" if round_kind else "  contact half-width", short(p["contact_size"]) + "   (Hertz-equivalent)"))
        if p["stick_size"] is not None and p["n_open"] > 0 and p["n_slip"] > 0 and p["n_stick"] > 0:
            lines.append(("  stick radius" if round_kind else "  stick half-width", short(p["stick_size"]) + "   (Hertz-equivalent, of bound less shear)"))
        if summary["error_estimate"].get("quantity") is not None and p["approach"] is not None:
            lines.append(("  approach", short(p["approach"])))
        lines.append(("  nodes", f"{p['n_open']} open, {p['n_stick']} stick, {p['n_slip']} slip"))
    for what, key in (("pressure", "contact"), ("shear", "shear"), ("stress", "bulk")):
        if summary["error_estimate"].get(key) is not None:
            lines.append(("estimated error of the " + what, estimate(summary, key)))
    if "increments" in summary:
        errors = summary["increments"]
        lines.append(("estimated error by increments", f"shear {percent(errors['shear'])}, stick size {percent(errors['stick_size'])}, forces "
                      f"{percent(max(errors['normal_force'], errors['tangential_force']))}, work of friction {percent(errors['dissipation'])} of all"))
    lines.append(("strain energy", short(summary["energy"])))
    if "dissipation" in summary["meshes"][-1]:
        lines.append(("external work", short(summary["meshes"][-1]["external_work"])))
        lines.append(("work of friction", short(summary["meshes"][-1]["dissipation"])))
    for probe in summary["probes"]:
        if len(probe["points"]) <= 4:
            for i, p in enumerate(probe["points"]):
                u = "-" if p["displacement"] is None else vector(p["displacement"])
                lines.append(("probe " + probe["name"] if i == 0 else "", f"at {vector(p['point'])}: displacement {u}; von Mises {short(p['von_mises'])}"))
    if "reference" in summary:
        for name, error in summary["reference"]["errors"].items():
            value = summary["reference"]["values"].get(name)
            lines.append(("  error of " + name, percent(error) + (f"   ({short(value[0])}, exact {short(value[1])})" if value else "")))
    lines.append(("finest mesh", f"{summary['cells']} cells, {summary['dofs']} DoFs"))
    return lines


def check_terminal(summary, text):
    lines = []
    for line in text.split("\n"):
        if line.startswith(" " * 34) and lines and len(lines[-1]) > 34:
            lines[-1] += " " + line[34:]
        else:
            lines.append(line)
    # the blanks between words are lost
    found = {(line[:34].strip(), " ".join(line[34:].split())) for line in lines}
    missing = [line for line in expected_lines(summary) if (line[0].strip(), " ".join(line[1].split())) not in found]
    yield "terminal: the answer", not missing, missing[:3]
    number = r"(\d\.\d\de[+-]\d\d|-)"
    iterations = [m.groups() for m in re.finditer(rf"(?m)^ +(\d+) +{number} +(\d+) +(\d+) +(\d+) +(\d+) +(\d+|direct)$", text)]
    if not iterations:
        return
    wanted = []
    for newton in summary["newton"]:
        wanted += [(str(i + 1), f"{r:.2e}", str(c)) for i, (r, c) in enumerate(zip(newton["residuals"], newton["active_set_changes"]))]
    lines = [(i[0], i[1], i[5]) for i in iterations]
    if "equilibrium of the transferred state" in text:  # whose iterations are not in the summary
        left = iter(lines)
        good = all(line in left for line in wanted)
    else:
        good = lines == wanted
    yield "terminal: iterations", good, f"{len(lines)} lines, {len(wanted)} iterations"
    totals = [str(sum(p[n] for p in summary["pairs"])) for n in ("n_open", "n_stick", "n_slip")]
    yield "terminal: nodes after the last iteration", list(iterations[-1][2:5]) == totals, f"{iterations[-1][2:5]}, {totals}"


def charts(text):
    """{title: [[(x, y), ...] of each line]} of the report's charts with linear axes, in the units of their ticks."""
    result = {}
    for svg in re.findall(r"(?s)<svg .*?</svg>", text):
        title = re.search(r'font-size="14" font-weight="600">([^<]*)</text>', svg)
        ticks = {"middle": [], "end": []}
        for x, y, anchor, value in re.findall(r'<text x="([-\d.]+)" y="([-\d.]+)" text-anchor="(middle|end)">([-+.\deE]+)</text>', svg):
            ticks[anchor].append((float(x) if anchor == "middle" else float(y) - 4, float(value)))
        if not title or min(len(t) for t in ticks.values()) < 2:
            continue

        def scale(ticks):
            (p, v), (q, w) = ticks[0], ticks[-1]
            return lambda pixel: v + (pixel - p) * (w - v) / (q - p), abs(w - v) / abs(q - p)

        (x, dx), (y, dy) = scale(ticks["middle"]), scale(ticks["end"])
        lines = [
            [(x(float(a)), y(float(b))) for a, b in re.findall(r"[ML]([-\d.]+) ([-\d.]+)", path)] for path in re.findall(r'<path d="([^"]*)" fill="none"', svg)
        ]
        dots = [
            [(x(float(a)), y(float(b))) for a, b in re.findall(r'cx="([-\d.]+)" cy="([-\d.]+)"', group)] for group in re.findall(r'(?s)<g fill="[^"]*">(.*?)</g>', svg)
        ]
        result[html.unescape(title.group(1))] = (lines, dots, dx, dy)
    return result


def same_points(found, wanted, dx, dy):
    """To a pixel."""
    return len(found) == len(wanted) and all(abs(a - c) <= dx and abs(b - d) <= dy for (a, b), (c, d) in zip(found, wanted))


def last_pass(meshes):
    """The rows of the last way through t: of each increment the last mesh."""
    rows = []
    for mesh in reversed(meshes):
        if rows and mesh["t"] > rows[-1]["t"]:
            break
        if not rows or mesh["t"] < rows[-1]["t"]:
            rows.append(mesh)
    return rows[::-1]


def png(data):
    """(width, height, rows of pixels as bytes) of a PNG with 8 bits of three colours."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, deflated = 8, b""
    while at < len(data):
        (size,) = struct.unpack(">I", data[at : at + 4])
        name, content = data[at + 4 : at + 8], data[at + 8 : at + 8 + size]
        assert struct.unpack(">I", data[at + 8 + size : at + 12 + size])[0] == zlib.crc32(name + content)
        if name == b"IHDR":
            width, height, *kind = struct.unpack(">IIBBBBB", content)
            assert kind == [8, 2, 0, 0, 0]
        deflated += content if name == b"IDAT" else b""
        at += 12 + size
    raw, n = zlib.decompress(deflated), 3 * width
    assert len(raw) == (n + 1) * height
    rows, above = [], bytes(n)
    for y in range(height):
        how, row = raw[y * (n + 1)], bytearray(raw[y * (n + 1) + 1 : (y + 1) * (n + 1)])
        for i in range(n):
            a, b, c = row[i - 3] if i > 2 else 0, above[i], above[i - 3] if i > 2 else 0
            nearest = min((a, b, c), key=lambda v: abs(a + b - c - v))
            row[i] = (row[i] + (0, a, b, (a + b) // 2, nearest)[how]) % 256
        above = bytes(row)
        rows.append(above)
    return width, height, rows


def body_pictures(text):
    """{title: (the SVG, [pictures])} of bodies in space."""
    result = {}
    for svg in re.findall(r"(?s)<svg (?:(?!</svg>).)*</svg>", text):
        images = [png(base64.b64decode(data)) for data in re.findall(r'href="data:image/png;base64,([^"]*)"', svg)]
        if images:
            result[html.unescape(re.search(r'font-weight="600">([^<]*)</text>', svg).group(1))] = (svg, images)
    return result


def check_bodies_picture(output, text):
    """The bodies in space: as wide and as high as they are from one of the sides, in the colours of their stresses."""
    found = [value for title, value in body_pictures(text).items() if title.startswith("Bodies, von Mises stress")]
    yield "report: a picture of the bodies", len(found) == 1 and len(found[0][1]) == 1, len(found)
    if not found:
        return
    svg, ((width, height, rows),) = found[0]
    drawn = [[any(row[3 * x : 3 * x + 3] != b"\xff\xff\xff" for row in rows) for x in range(width)], [any(channel != 255 for channel in row) for row in rows]]
    spans = [(line.index(True), len(line) - 1 - line[::-1].index(True)) if True in line else (0, -1) for line in drawn]
    good = all(2 <= first <= 4 and size - 5 <= last <= size - 3 for (first, last), size in zip(spans, (width, height)))
    yield "report: the bodies fill their picture", good, f"{spans} of {width}, {height}"
    factor = re.search(r"are drawn ([-+.\de]+) times as large", svg)
    warp = float(factor.group(1)) if factor else 1
    _, path = records(os.path.join(output, "bodies.pvd"))[-1]
    points = [[x + warp * d for x, d in zip(X, u)] for part in pieces(path) for X, u in zip(part["Points"], part["displacement"])]
    best = 1
    for up in range(3):
        for azimuth in (-60, 30, 120, 210):
            for elevation in (25, -25):
                a, e = math.radians(azimuth), math.radians(elevation)
                right, over = [0, 0, 0], [0, 0, 0]
                right[(up + 1) % 3], right[(up + 2) % 3] = -math.sin(a), math.cos(a)
                over[(up + 1) % 3], over[(up + 2) % 3], over[up] = -math.sin(e) * math.cos(a), -math.sin(e) * math.sin(a), math.cos(e)
                sizes = []
                for axis in (right, over):
                    places = [sum(x * d for x, d in zip(p, axis)) for p in points]
                    sizes.append(max(places) - min(places))
                best = min(best, abs((width - 6) / (height - 6) / (sizes[0] / sizes[1]) - 1))
    yield "report: shape of the bodies", best < 0.01, best
    mises = max(v for part in pieces(path) for v in part["von_mises"])
    ticks = [float(v) for v in re.findall(r'<text x="[-\d.]+" y="[-\d.]+">([-+.\deE]+)</text>', svg)]
    yield "report: largest von Mises stress of the bodies", 0.1 * mises <= max(ticks, default=0) <= 1.01 * mises, f"{ticks[-1:]}, {mises}"
    colours = {row[3 * x : 3 * x + 3] for row in rows for x in range(width)}
    yield "report: stresses in many colours", len(colours) > 20, len(colours)


def check_picture(output, summary, text):
    """The deformed mesh: as many cells, as wide and as high as the bodies, and stresses no larger than theirs."""
    svg = re.search(r"(?s)<svg (?:(?!</svg>).)*Deformed mesh, von Mises stress.*?</svg>", text)
    if summary["dimension"] != 2:
        yield "report: no mesh in space", not svg, ""
        yield from check_bodies_picture(output, text)
        return
    paths = re.findall(r'<path fill="[^"]*" stroke="[^"]*"[^>]* d="([^"]*)"/>', svg.group(0))
    outlines = [re.findall(r"[ML]([-\d.]+) ([-\d.]+)", cell) for path in paths for cell in path.split("Z") if cell]
    tiny = "h1v1h-1Z" in svg.group(0)  # cells of less than a pixel, of which each pixel shows one
    good = len(outlines) == summary["cells"] or tiny and len(outlines) < summary["cells"]
    yield "report: cells of the mesh", good, f"{len(outlines)}, {summary['cells']}"
    _, path = records(os.path.join(output, "bodies.pvd"))[-1]
    points = [(X[0] + u[0], X[1] + u[1]) for part in pieces(path) for X, u in zip(part["Points"], part["displacement"])]
    mises = max(v for part in pieces(path) for v in part["von_mises"])
    sizes = [max(p[d] for p in points) - min(p[d] for p in points) for d in range(2)]
    pixels = [[float(p[d]) for cell in outlines for p in cell] for d in range(2)]
    drawn = [max(p) - min(p) for p in pixels]
    good = all(abs(w - 420 * size / max(sizes)) <= 0.3 + 2e-3 * w for w, size in zip(drawn, sizes))
    yield "report: size of the deformed mesh", good, f"{drawn}, {sizes}"
    ticks = [(float(y), float(v)) for y, v in re.findall(r'<text x="[-\d.]+" y="([-\d.]+)">([-+.\deE]+)</text>', svg.group(0))]
    highest = max(drawn[1], 120) * (ticks[-1][1] - ticks[0][1]) / (ticks[0][0] - ticks[-1][0]) if len(ticks) > 1 else 0
    yield "report: largest von Mises stress of the mesh", 0.2 * mises <= highest <= 1.01 * mises, f"{highest}, {mises}"


def check_report(summary, contact, text):
    missing = [line for line in expected_lines(summary) if f"<td>{html.escape(line[0])}</td><td>{html.escape(line[1])}</td>" not in text]
    yield "report: the answer", not missing, missing[:3]
    found = charts(text)
    for pair in summary["pairs"]:
        title = "Contact pressure, " + pair["name"]
        if title not in found or summary["dimension"] != 2:
            continue
        lines, _, dx, dy = found[title]
        rows = [r for r in contact if r["pair"] == pair["name"]]
        arc = [0.0]
        for a, b in zip(rows, rows[1:]):
            arc.append(arc[-1] + math.dist(*([r[c] for c in "XYZ"] for r in (a, b))))
        centre = pair["centre"] + [0.0] * (3 - len(pair["centre"]))
        middle = min(range(len(rows)), key=lambda i: math.dist([rows[i][c] for c in "XYZ"], centre))
        points = [(s - arc[middle], r["pressure"]) for s, r in zip(arc, rows)]
        shown = 1.6 * pair["contact_size"] if sum(abs(s) <= pair["contact_size"] for s, _ in points) > 3 else math.inf
        wanted = [p for p in points if abs(p[0]) <= shown]
        yield f"report: {title}", same_points(lines[0], wanted, dx, dy), f"{lines[0][:3]}, {wanted[:3]}"
    rows = last_pass(summary["meshes"])
    if len(rows) < 2:
        return
    over_time = {"Normal force": [[norm(m["pairs"][i]["normal_force"]) for m in rows] for i in range(len(summary["pairs"]))],
                 "Peak pressure": [[m["pairs"][i]["peak_pressure"] for m in rows] for i in range(len(summary["pairs"]))]}
    if "dissipation" in rows[-1]:
        over_time["Work of friction"] = [[0] + [m["dissipation"] for m in rows]]
        over_time["Where the work goes"] = [[0] + [m[key] for m in rows] for key in ("external_work", "energy", "contact_work")]
    for title, curves in over_time.items():
        if title not in found:
            yield f"report: {title}", title == "Work of friction" and max(abs(v) for v in curves[0]) == 0, "no such chart"
            continue
        lines, _, dx, dy = found[title]
        times = [m["t"] for m in rows]
        wanted = [list(zip([0] * (len(values) - len(times)) + times, values)) for values in curves]
        good = len(lines) == len(wanted) and all(same_points(a, b, dx, dy) for a, b in zip(lines, wanted))
        yield f"report: {title}", good, f"{[line[-2:] for line in lines]}, {[line[-2:] for line in wanted]}"


def check(output, text):
    with open(os.path.join(output, "summary.json")) as file:
        summary = json.load(file)
    with open(os.path.join(output, "report.html")) as file:
        report = file.read()
    contact, history = (table(os.path.join(output, name + ".csv")) for name in ("contact", "history"))
    yield from check_contact(output, summary, contact)
    yield from check_bodies(output, summary, contact, summary["meshes"][-1]["t"])
    yield from check_history(summary, history)
    yield from check_terminal(summary, text)
    yield from check_report(summary, contact, report)
    yield from check_picture(output, summary, report)
