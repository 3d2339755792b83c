"""Scenes as data for tests: reads and writes .prm files, and makes from a scene the same scene in other units, turned, or in another order.

    scene = scene_text.read(path)                # or parse(text)
    text = scene_text.write(turned(scene, rotation((0, 0, 1), 0.7)))

A scene is a list of sections [kind, name, entries]; the first one, ["", "", ...], has the entries outside of sections. What cannot be said of a scene (a
component that is free in a turned frame) raises Inexpressible.
"""
import copy
import math
import os
import re

SINGLE = ("Reference", "Discretization", "Contact solver", "Linear solver", "Refinement", "Output")
KINDS = ("Boundary condition", "Body", "Obstacle", "Contact", "Probe")
POINTS = ("Lower corner", "Upper corner", "Centre", "Rotation centre", "Shift", "Reference point", "Point", "From", "To")
SIZES = ("Radius", "Inner radius", "Length", "Half width", "Adjust")


class Inexpressible(Exception):
    """A scene file cannot say this."""


def lines(path):
    """The lines of a file without comments and continuations, with what it includes."""
    with open(path) as file:
        text = re.sub(r"[ \t]*\\\n[ \t]*", " ", re.sub(r"#.*", "", file.read()))
    for line in text.split("\n"):
        words = line.split(None, 1)
        if words and words[0] == "include":
            yield from lines(os.path.join(os.path.dirname(path), words[1].strip()))
        elif words:
            yield line.strip()


def parse(text_lines, folder="."):
    scene = [["", "", {}]]
    inside = scene[0]
    for line in text_lines:
        word, _, rest = line.partition(" ")
        if word == "subsection":
            kind = next((k for k in SINGLE + KINDS if rest == k or k in KINDS and rest.startswith(k + " ")))
            inside = [kind, rest[len(kind):].strip(), {}]
            scene.append(inside)
        elif word == "end":
            inside = scene[0]
        else:
            key, _, value = rest.partition("=")
            inside[2][key.strip()] = value.strip()
            if key.strip() == "Mesh" and "." in value:
                inside[2]["Mesh"] = os.path.join(folder, value.strip())
    return scene


def read(path):
    return parse(lines(path), os.path.dirname(os.path.abspath(path)))


def write(scene):
    text = []
    for kind, name, entries in scene:
        text += [f"subsection {kind} {name}".rstrip()] if kind else []
        text += [f"{'  ' if kind else ''}set {key} = {value}" for key, value in entries.items()]
        text += ["end", ""] if kind else [""]
    return "\n".join(text)


def change(scene, path, value):
    """Sets 'Section/Entry' or 'Entry', as --set does."""
    section, _, key = path.rpartition("/")
    found = next((entries for kind, name, entries in scene if f"{kind} {name}".strip() == section), None)
    if found is None:
        scene.append([section, "", {}])
        found = scene[-1][2]
    found[key] = value


def dimension(scene):
    return 3 if scene[0][2].get("Kind") == "3D" else 2


def numbers(text, n):
    values = [float(v) for v in text.split(",")]
    return (values + [0.0, 0.0, 0.0])[:n]


def joined(values):
    return ", ".join(repr(v + 0.0) for v in values)


def components(text):
    return [c.strip() for c in text.split(";")]


# ---- units

def force_unit(scene, length, stress):
    return stress * length ** (1 if scene[0][2].get("Kind", "plane strain").startswith("plane") else 2)


def in_units(text, factor, length, stress=1.0):
    """An expression of positions in the other unit of length (and of pressures p), times the factor."""
    text = re.sub(r"\b([xyzr])\b(?!\s*=)", lambda m: f"({m[1]}/{length!r})", text)
    text = re.sub(r"\bp\b", f"(p/{stress!r})", text)
    return f"{factor!r}*({text})"


def modulus_and_size(scene):
    """The largest Young's modulus and coordinate of a scene."""
    moduli = [float(entries["Young modulus"]) for _, _, entries in scene if "Young modulus" in entries]
    sizes = [abs(float(v)) for _, _, entries in scene for key in POINTS + SIZES if key in entries for v in entries[key].split(",")]
    return max(moduli, default=1.0), max(sizes)


def closed_form_in_units(text, force, length):
    """NAME(PARAMETER = NUMBER, ...) of a displacement field."""
    for name, factor in (("P", force), ("Q", force), ("a", length), ("c", length), ("x0", length), ("y0", length), ("z0", length)):
        text = re.sub(rf"\b{name}\s*=\s*([-+.\deE]+)", lambda m: f"{name} = {float(m[1]) * factor!r}", text)
    return text


def rescaled_entry(entries, kind, key, value, length, stress, force):
    mesh_length = length
    if key in POINTS or key in SIZES:
        return joined([float(v) * mesh_length for v in value.split(",")])
    if key == "Young modulus":
        return repr(float(value) * stress)
    what = {"Value": entries.get("Type", "displacement")}.get(key, key)
    factor = {"Body force": stress / length, "Displacement": length, "displacement": length, "Force": force, "total force": force, "Moment": force * length,
              "Rotation": 1.0, "traction": stress, "pressure": stress, "Initial gap": length, "Friction coefficient": 1.0, "Tresca bound": stress}.get(what)
    if factor is None:
        return value
    if re.match(r"half(plane|space)_", value):
        return closed_form_in_units(value, force, length)
    return "; ".join(c if c == "free" else in_units(c, factor, length, stress) for c in components(value))


def rescaled(scene, length, stress):
    """The scene in other units: lengths times `length`, moduli and pressures times `stress`."""
    if any("." in entries.get("Mesh", "") for _, _, entries in scene):
        raise Inexpressible("the mesh of a file has its own lengths")
    force = force_unit(scene, length, stress)
    return [[kind, name, {key: rescaled_entry(entries, kind, key, value, length, stress, force) for key, value in entries.items()}]
            for kind, name, entries in scene]


# ---- rotations: matrices as lists of rows

def rotation(axis, angle):
    n = [a / math.hypot(*axis) for a in axis]
    c, s = math.cos(angle), math.sin(angle)
    cross = [[0, -n[2], n[1]], [n[2], 0, -n[0]], [-n[1], n[0], 0]]
    return [[c * (i == j) + s * cross[i][j] + (1 - c) * n[i] * n[j] for j in range(3)] for i in range(3)]


def times(a, b):
    return [[math.fsum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def applied(a, v):
    v = list(v) + [0.0] * (3 - len(v))
    return [math.fsum(a[i][k] * v[k] for k in range(3)) for i in range(3)]


def transposed(a):
    return [list(row) for row in zip(*a)]


def axis_and_angle(a):
    """Of a rotation, by its quaternion: the largest component first."""
    trace = a[0][0] + a[1][1] + a[2][2]
    square = [1 + trace] + [1 + 2 * a[i][i] - trace for i in range(3)]
    k = max(range(4), key=lambda i: square[i])
    if k == 0:
        q = [1 + trace, a[2][1] - a[1][2], a[0][2] - a[2][0], a[1][0] - a[0][1]]
    else:
        i, j, l = k - 1, k % 3, (k + 1) % 3
        q = [a[l][j] - a[j][l], 0, 0, 0]
        q[1 + i], q[1 + j], q[1 + l] = square[k], a[i][j] + a[j][i], a[i][l] + a[l][i]
    angle = 2 * math.atan2(math.hypot(*q[1:]), q[0])
    return (q[1:] if math.hypot(*q[1:]) > 0 else [0, 0, 1]), angle


def is_permutation(a):
    return all(min(abs(v), abs(abs(v) - 1)) < 1e-12 for row in a for v in row)


def combination(a, i, texts):
    """Component i of the matrix times the expressions; a free one may only be turned into another direction of the axes."""
    row = [v if abs(v) > 1e-15 else 0.0 for v in a[i][:len(texts)]]
    if sum(v != 0 for v in row) == 1:
        j = next(j for j, v in enumerate(row) if v)
        if texts[j] == "free":
            return "free"
    if any(v and t == "free" for v, t in zip(row, texts)):
        raise Inexpressible("a free component in a turned frame")
    return " + ".join(f"{v!r}*({t})" for v, t in zip(row, texts) if v) or "0"


def in_turned_frame(a, text, n):
    """An expression of the position before the scene was turned."""
    names = "xyz"[:n]
    old = {name: "(" + " + ".join(f"{a[j][i]!r}*{names[j]}" for j in range(n) if abs(a[j][i]) > 1e-15) + ")" for i, name in enumerate(names)}
    return re.sub(r"\b([xyz])\b", lambda m: old[m[1]], text)


def turn_vector(a, text, n):
    """A vector of expressions, each of which may be free."""
    texts = [c if c == "free" else in_turned_frame(a, c, n) for c in components(text)]
    if all(t == "free" for t in texts):
        return text
    return "; ".join(combination(a, i, texts) for i in range(n))


def turn_body(a, entries, n):
    """Turns the placement x -> R (x - c) + c + s of a body."""
    axis = numbers(entries.get("Rotation axis", "0, 0, 1"), 3)
    centre, shift = (numbers(entries.get(key, "0"), 3) for key in ("Rotation centre", "Shift"))
    before = rotation(axis, math.radians(float(entries.get("Rotate", "0"))))
    after = applied(a, [c + s for c, s in zip(centre, shift)])
    axis, angle = axis_and_angle(times(a, before))
    if n == 2:
        angle, axis = angle * (1 if axis[2] >= 0 else -1), [0.0, 0.0, 1.0]
    else:
        entries["Rotation axis"] = joined(axis)
    entries["Rotate"] = repr(math.degrees(angle))
    entries["Shift"] = joined([x - c for x, c in zip(after, centre)][:n])


def turn_motion(a, entries, n):
    """Held components that nobody mentions must be said, since they may be combined with others."""
    driven = components(entries.get("Force", "")) if entries.get("Force") else []
    if driven and "Displacement" not in entries:
        entries["Displacement"] = "; ".join("free" if c != "0" else "0" for c in driven)
    for key in ("Displacement", "Force") + (("Rotation", "Moment") if n == 3 else ()):
        if entries.get(key):
            entries[key] = turn_vector(a, entries[key], n)
    if "Reference point" in entries:
        entries["Reference point"] = joined(applied(a, numbers(entries["Reference point"], 3))[:n])


def default_direction(entries):
    surface = entries.get("Surface", "plane")
    return {"Axis": "0, 0, 1"} if surface == "cylinder" else {} if surface in ("circle", "sphere") else {"Normal": "0, 1, 0"}


def turned(scene, a):
    """The whole scene turned by the matrix, about the origin."""
    n, scene = dimension(scene), copy.deepcopy(scene)
    if scene[0][2].get("Kind") == "axisymmetric":
        raise Inexpressible("the axis stays")
    for kind, _, entries in scene:
        if kind == "Body":
            turn_body(a, entries, n)
        default = default_direction(entries) if kind == "Obstacle" else {}
        for key in ("Centre", "Normal", "Axis") if kind == "Obstacle" else ("Point", "From", "To") if kind == "Probe" else ():
            if key in entries or key in default and not (n == 2 and key == "Axis"):
                entries[key] = joined(applied(a, numbers(entries.get(key, default.get(key)), 3))[:n])
        turn_motion(a, entries, n)
        if entries.get("Body force"):
            entries["Body force"] = turn_vector(a, entries["Body force"], n)
        for key in ("Initial gap", "Friction coefficient", "Tresca bound"):
            if entries.get(key):
                entries[key] = in_turned_frame(a, entries[key], n)
        if "Value" in entries:
            if re.match(r"half(plane|space)_", entries["Value"]):
                raise Inexpressible("a closed form in a turned frame")
            scalar = entries.get("Type") == "pressure"
            if sorted(components(entries["Value"])) == sorted(["0"] + ["free"] * (n - 1)) and not is_permutation(a):
                entries.pop("Value")
                entries["Type"] = "symmetry"
                continue
            entries["Value"] = in_turned_frame(a, entries["Value"], n) if scalar else turn_vector(a, entries["Value"], n)
    return scene


# ---- during the history, with finite strain

def turning(axis, angle, n):
    """The rotation by an angle that is an expression of t, as expressions; matrix of texts."""
    m = [x / math.hypot(*axis) for x in axis]
    cross = [[0, -m[2], m[1]], [m[2], 0, -m[0]], [-m[1], m[0], 0]]
    return [[f"(cos({angle})*{(i == j) - m[i] * m[j]!r} + {m[i] * m[j]!r} + sin({angle})*{cross[i][j] + 0.0!r})" for j in range(n)] for i in range(n)]


def moved(q, texts):
    if any("free" in t for t in texts):
        raise Inexpressible("a free component in a turning frame")
    return [" + ".join(f"{c}*({t})" for c, t in zip(row, texts)) for row in q]


def turn_motion_along(q, axis, angle, entries, n):
    if "Force" in entries or "Moment" in entries or "free" in entries.get("Displacement", "") + entries.get("Rotation", ""):
        raise Inexpressible("a free motion in a turning frame")
    if n == 3 and entries.get("Rotation"):
        raise Inexpressible("rotations one after another")
    point = [repr(x) for x in numbers(entries.get("Reference point", "0"), n)]
    u = components(entries["Displacement"]) if entries.get("Displacement") else ["0"] * n
    new = moved(q, [f"{x} + ({c})" for x, c in zip(point, u)])
    entries["Displacement"] = "; ".join(f"{c} - ({x})" for c, x in zip(new, point))
    if n == 2:
        entries["Rotation"] = f"({entries.get('Rotation') or '0'}) + ({angle})"
    else:
        m = [x / math.hypot(*axis) for x in axis]
        entries["Rotation"] = "; ".join(f"{x!r}*({angle})" for x in m)


def turned_along(scene, axis, angle):
    """The scene turns about the origin by an angle that is an expression of t (0 at t = 0), while it goes on."""
    n, scene = dimension(scene), copy.deepcopy(scene)
    if scene[0][2].get("Kinematics") != "finite strain" or scene[0][2].get("Kind") == "axisymmetric":
        raise Inexpressible("large rotations need finite strain, not about an axis")
    q = turning(axis, angle, n)
    for kind, _, entries in scene:
        what = entries.get("Type", "displacement") if kind == "Boundary condition" else ""
        if kind == "Obstacle" or entries.get("Rigid") == "true" or what == "platen":
            turn_motion_along(q, axis, angle, entries, n)
        if entries.get("Body force"):
            entries["Body force"] = "; ".join(moved(q, components(entries["Body force"])))
        if what in ("traction", "total force"):
            entries["Value"] = "; ".join(moved(q, components(entries["Value"])))
        if what == "displacement":
            new = moved(q, [f"{x} + ({c})" for x, c in zip("xyz", components(entries["Value"]))])
            entries["Value"] = "; ".join(f"{c} - {x}" for c, x in zip(new, "xyz"))
        if what == "symmetry":
            raise Inexpressible("a plane of symmetry stays")
    return scene


# ---- order and names

def reordered(scene, rename=True):
    """The sections the other way round, and with other names; returns the old names by the new ones, too."""
    new = {}
    for kind, name, _ in scene:
        if kind in KINDS:
            new[name] = f"n{len(scene) - len(new)} {name[::-1]}" if rename else name
    result = [copy.deepcopy(scene[0])]
    for kind, name, entries in reversed(scene[1:]):
        entries = dict(entries)
        for key in ("Boundaries", "First", "Second"):
            if key in entries:
                sides = [s.strip().partition("/") for s in entries[key].split(",")]
                if key == "Boundaries":
                    sides.reverse()
                entries[key] = ", ".join(new[body] + slash + boundary for body, slash, boundary in sides)
        if kind == "Probe":
            entries["Body"] = new[entries["Body"]]
        result.append([kind, new.get(name, name), entries])
    return result, {value: key for key, value in new.items()}


def ramped(scene):
    """Constant loads and motions grow with t from 0."""
    scene = copy.deepcopy(scene)
    for _, _, entries in scene:
        for key in ("Value", "Displacement", "Force", "Body force"):
            if entries.get(key) and not re.search(r"\bt\b|table|half(plane|space)_", entries[key]):
                entries[key] = "; ".join(c if c in ("free", "0") else f"({c})*t" for c in components(entries[key]))
    return scene
