#!/usr/bin/env python3
"""Is the answer the same where it must be? kinds.py AMONTONS [--only KIND] [--scene NAME] [--part K/N] [-j N] [--keep DIR]

Runs scenes and the same scenes transformed (scene_text.py), and compares what must not change, node by node where it can:
  units       lengths times 1e-6 .. 1e6 and stresses times 1e-12 .. 1e12, all together
  turned      the whole scene turned in space before it starts
  turning     finite strain: all that holds and loads turns while the scene goes on
  order       bodies, pairs and conditions the other way round, with other names
  slave       either side of a pair carries the pressure: within the estimated error
  increments  their number, where the answer does not depend on it
  one         one increment too large for everything: right, cut or refused, not wrong
--only: the kind; --scene: names that contain this; --part 2/3: the second third; --keep: scene files and outputs of what differs stay there.
"""
import argparse
import concurrent.futures
import copy
import csv
import json
import math
import os
import shutil
import sys
import tempfile
import threading

import kinds_scenes
import launch
import scene_text as text

ALWAYS = {"Output/VTU": "false", "Output/Report": "false", "Contact solver/Tolerance": "1e-12"}


class Back:
    """How values of the transformed run become those of the base run: lengths, stresses and forces are divided, vectors turned back, names replaced."""

    def __init__(self, length=1.0, stress=1.0, force=1.0, energy=1.0, reference=None, current=None, names=None, flipped=()):
        identity = text.rotation((0, 0, 1), 0)
        self.length, self.stress, self.force, self.energy = length, stress, force, energy
        self.reference, self.current = reference or identity, current or identity
        self.names, self.flipped = names or {}, flipped

    def vector(self, v, factor=1.0):
        return [c / factor for c in text.applied(text.transposed(self.current), v)]

    def name(self, name):
        return self.names.get(name, name)


def run(program, scene, folder):
    """Runs a scene in a folder; its exit code."""
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, "scene.prm")
    with open(path, "w") as file:
        file.write(scene)
    with open(os.path.join(folder, "messages"), "w") as file:
        return launch.run([program, path, "--output", folder, "--quiet"], stdout=file, stderr=file, timeout=300).returncode


def answer(folder, code, back):
    """Quantities of a run, in units and frame of the base run: name -> (group whose largest value is the measure, numbers)."""
    if not os.path.exists(os.path.join(folder, "summary.json")):
        return {"exit code": ("count", [code])}
    with open(os.path.join(folder, "summary.json")) as file:
        summary = json.load(file)
    # whether small strain will do is an estimate
    result = {"exit code": ("count", [0 if summary["message"].startswith("kinematics") else code])}
    total = [0.0, 0.0, 0.0]
    for pair in summary["pairs"]:
        name = back.name(pair["name"])
        for key in ("normal_force", "tangential_force"):
            result[f"{name}: {key}"] = ("force", back.vector(pair[key], -back.force if name in back.flipped else back.force))
        result[f"{name}: peak pressure"] = ("pressure", [pair["peak_pressure"] / back.stress])
        for key in ("contact_size", "stick_size"):
            if pair[key] is not None:
                result[f"{name}: {key}^2"] = ("size", [(pair[key] / back.length) ** 2])
    for reaction in summary["reactions"]:
        total = [a + b for a, b in zip(total, back.vector(reaction["force"], back.force))]
    result["sum of reactions"] = ("force", total)
    result["energy"] = ("energy", [summary["energy"] / back.energy])
    result["dissipation"] = ("energy", [(summary["meshes"][-1].get("dissipation") or 0.0) / back.energy])
    for probe in summary["probes"]:
        for n, point in enumerate(probe["points"]):
            if point["von_mises"] is not None:
                result[f"{back.name(probe['name'])}[{n}]: von Mises"] = ("stress", [point["von_mises"] / back.stress])
    result["unknowns"] = ("count", [summary["dofs"]])
    return result


def nodes(folder, back):
    """The contact nodes, in units and frame of the base run: (pair, X, values), sorted by nothing."""
    with open(os.path.join(folder, "contact.csv")) as file:
        rows = list(csv.DictReader(file))
    result = []
    for row in rows:
        vector = lambda names: [float(row[n]) for n in names]
        old = [c / back.length for c in text.applied(text.transposed(back.reference), vector("XYZ"))]
        values = {
            "position": ("move", back.vector(vector("xyz"), back.length)), "pressure": ("pressure", [float(row["pressure"]) / back.stress]),
            "shear": ("pressure", back.vector(vector(("tx", "ty", "tz")), back.stress)),
            "slip": ("move", back.vector(vector(("slip_x", "slip_y", "slip_z")), back.length)),
            "force": ("force", back.vector(vector(("fx", "fy", "fz")), back.force)),
        }
        result.append((back.name(row["pair"]), old, row["state"], values))
    return result


def scales(base, base_nodes, scene):
    """Of each group the largest value of the base run, and what rounding makes of a value that is a sum of larger ones: 1e-14 of modulus and size."""
    largest = {group: 0.0 for group in ("force", "pressure", "stress", "size", "energy", "move")}
    for group, values in list(base.values()) + [value for _, _, _, row in base_nodes for value in row.values() if value[0] != "move"]:
        largest[group] = max([largest.get(group, 0.0)] + [abs(v) for v in values])
    largest["move"] = max([math.dist(old, row["position"][1]) for _, old, _, row in base_nodes] + [0.0])
    modulus, size = text.modulus_and_size(scene)
    force = modulus * text.force_unit(scene, size, 1.0)
    rounding = {"force": force, "pressure": modulus, "stress": modulus, "size": size**2, "energy": force * size, "move": size}
    return {group: (value, 1e-14 * rounding.get(group, 0.0)) for group, value in largest.items()}


def difference(first, second, scale):
    """Relative to the scale, after what rounding may do."""
    worst = max(0.0, max((abs(a - b) for a, b in zip(first, second)), default=0.0) - scale[1])
    return 0.0 if worst == 0 else worst / scale[0] if scale[0] > 0 else math.inf


def compare(base, other, groups):
    """Relative differences by name; inf: something is missing, or a count is another one."""
    result = {}
    for name in sorted(set(base) | set(other)):
        if name not in base or name not in other:
            result[name] = math.inf
        elif base[name][0] == "count":
            result[name] = 0.0 if base[name][1] == other[name][1] else math.inf
        else:
            result[name] = difference(base[name][1], other[name][1], groups[base[name][0]])
    return result


def compare_nodes(base, other, groups):
    """The largest difference of each column over nodes at the same place. States may differ where the pressure is zero to 1e-9 of the peak."""
    if len(base) != len(other):
        return {"number of contact nodes": math.inf}
    result = {"states": 0.0, "places": 0.0}
    size = max((abs(c) for _, old, _, _ in base for c in old), default=1.0)
    for pair, old, state, values in base:
        near = min((row for row in other if row[0] == pair), key=lambda row: math.dist(row[1], old), default=None)
        if near is None or math.dist(near[1], old) > 1e-7 * size:
            return {"places of contact nodes": math.inf}
        result["places"] = max(result["places"], math.dist(near[1], old) / size)
        for name, (group, v) in values.items():
            result["node " + name] = max(result.get("node " + name, 0.0), difference(v, near[3][name][1], groups[group]))
        if state != near[2] and max(values["pressure"][1][0], near[3]["pressure"][1][0]) > 1e-9 * groups["pressure"][0] + groups["pressure"][1]:
            result["states"] = math.inf
    return result


def estimate(folder):
    """The estimated error of contact and increments; without an answer none."""
    if not os.path.exists(os.path.join(folder, "summary.json")):
        return 0.0
    with open(os.path.join(folder, "summary.json")) as file:
        errors = json.load(file)["error_estimate"]
    return errors["contact"] + (errors.get("increments") or 0.0)


def message(folder):
    with open(os.path.join(folder, "messages")) as file:
        return file.read()


class Runs:
    """Base scenes, each of which runs once."""

    def __init__(self, program, folder):
        self.program, self.folder, self.lock, self.done = program, folder, threading.Lock(), {}

    def base(self, scene):
        """The folder and exit code of a scene."""
        with self.lock:
            if scene not in self.done:
                folder = os.path.join(self.folder, f"base_{len(self.done)}")
                self.done[scene] = (folder, run(self.program, scene, folder))
            return self.done[scene]


def outcome(case, runs, folder):
    """Runs both scenes of a case; the differences that are too large, and the largest."""
    base_folder, base_code = runs.base(text.write(case.scene))
    code = run(runs.program, text.write(case.other), folder)
    refused = [which == 1 and "kinematics" not in message(place) for which, place in ((base_code, base_folder), (code, folder))]
    if all(refused) or case.may_fail and any(refused):
        return {}, 0.0, (base_code, code)
    base, other = answer(base_folder, base_code, Back()), answer(folder, code, case.back)
    rows = nodes(base_folder, Back()) if len(base) > 1 else []
    groups = scales(base, rows, case.scene)
    found = {name: value for name, value in compare(base, other, groups).items() if name not in case.but}
    if len(base) > 1 and len(other) > 1 and case.by_node:
        found.update(compare_nodes(rows, nodes(folder, case.back), groups))
    if case.tolerance is None:
        error = max(estimate(base_folder) + estimate(folder), 1e-9)
        # all round its centre the size of a contact is zero
        small = {name for name, (group, value) in base.items() if group == "size" and value[0] < 1e-6 * text.modulus_and_size(case.scene)[1] ** 2}
        found = {name: value / error * (0.5 if name.endswith("^2") else 1) for name, value in found.items()
                 if name not in small and not name.endswith(("unknowns", "peak pressure"))}
    return {name: value for name, value in found.items() if not value <= (case.tolerance or 1)}, max(found.values()), (base_code, code)


class Case:
    """A scene, the same scene transformed, how to come back from its answer, how much that may differ, and what may (`but`)."""

    def __init__(self, kind, name, scene, other, back, tolerance, by_node=True, may_fail=False, but=()):
        self.kind, self.name, self.scene, self.other, self.back = kind, name, scene, other, back
        self.tolerance, self.by_node, self.may_fail, self.but = tolerance, by_node, may_fail, but


def with_settings(scene):
    for path, value in ALWAYS.items():
        text.change(scene, path, value)
    return [section for section in scene if section[0] != "Reference"]


def units(name, scene):
    for length, stress in kinds_scenes.UNITS:
        force = text.force_unit(scene, length, stress)
        back = Back(length, stress, force, force * length)
        yield Case("units", f"{name} L={length:g} e={stress:g}", scene, text.rescaled(scene, length, stress), back, 1e-8)


def turned(name, scene):
    for axis, angle in kinds_scenes.TURNS_3D if text.dimension(scene) == 3 else kinds_scenes.TURNS:
        a = text.rotation(axis, math.radians(angle))
        try:
            other = text.turned(scene, a)
        except text.Inexpressible:
            continue
        yield Case("turned", f"{name} by {angle:g} about {axis}", scene, other, Back(reference=a, current=a), 1e-8)


def turning(name, scene):
    end = float(scene[0][2].get("End time", "1"))
    scene = in_increments(scene, max(10, int(scene[0][2].get("Increments", "10"))))
    for axis, angle in kinds_scenes.TURNINGS_3D if text.dimension(scene) == 3 else kinds_scenes.TURNINGS:
        other = text.turned_along(scene, axis, f"{math.radians(angle) / end!r}*t")
        yield Case("turning", f"{name} by {angle:g} about {axis}", scene, other,
                   Back(current=text.rotation(axis, math.radians(angle))), 1e-8)


def order(name, scene):
    other, names = text.reordered(scene)
    yield Case("order", name, scene, other, Back(names=names), 1e-9)


def slave(name, scene):
    """The other slave is another discretisation: the estimated errors of both runs are the measure. They are of norms: peaks (infinite at edges) are left out."""
    sides, flipped = [], []
    for side in ("first", "second"):
        sides.append(copy.deepcopy(scene))
        deformable = {name for kind, name, entries in scene if kind == "Body" and entries.get("Rigid") != "true"}
        pairs = [(pair, entries) for kind, pair, entries in sides[-1] if kind == "Contact"]
        for pair, entries in pairs:
            if "/" in entries["Second"] and all(entries[s].split("/")[0] in deformable for s in ("First", "Second")):
                entries["Slave"] = side
                flipped.append(pair)
    if flipped:
        yield Case("slave", name, sides[0], sides[1], Back(flipped=flipped), None, by_node=False, may_fail=True)


def in_increments(scene, number):
    other = copy.deepcopy(scene)
    other[0][2]["Increments"] = str(number)
    return other


def increments(name, scene):
    if name in kinds_scenes.WITHOUT_HISTORY:
        # the dissipation is a sum of shears at the ends of increments: exact for many of them
        scene = text.ramped(scene)
        for number in (2, 5, 50):
            yield Case("increments", f"{name} in {number}", in_increments(scene, 1), in_increments(scene, number), Back(), 1e-8, but=("dissipation",))


def one(name, scene):
    """A run that says that it failed is right, too."""
    if name in kinds_scenes.FAR:
        yield Case("one", name, in_increments(scene, 40), in_increments(scene, 1), Back(), 1e-6, may_fail=True)


KINDS = {"units": units, "turned": turned, "turning": turning, "order": order, "slave": slave, "increments": increments, "one": one}


def cases(only, part):
    result = []
    for kind, make in KINDS.items():
        if only in ("", kind):
            for name in kinds_scenes.SCENES:
                scene = with_settings(kinds_scenes.scene(name))
                try:
                    result += list(make(name, scene))
                except text.Inexpressible:
                    pass
    k, n = (int(v) for v in part.split("/"))
    return result[k - 1::n]


def tried(case, runs, keep):
    folder = os.path.join(runs.folder, f"{case.kind} {case.name}".replace("/", "_").replace(" ", "_"))
    found, worst, codes = outcome(case, runs, folder)
    if found and keep:
        place = os.path.join(keep, os.path.basename(folder))
        shutil.copytree(folder, os.path.join(place, "transformed"), dirs_exist_ok=True)
        shutil.copytree(runs.base(text.write(case.scene))[0], os.path.join(place, "base"), dirs_exist_ok=True)
    shutil.rmtree(folder)
    return case, found, worst, codes


def report(results):
    """Says how each case went; whether all hold but those that are known not to."""
    table = {}
    for case, found, worst, codes in results:
        why = kinds_scenes.known(case.kind, case.name)
        word = "ok" if not found else "known" if why else "FAILED"
        row = table.setdefault(case.kind, {"ok": 0, "known": 0, "FAILED": 0, "largest": 0.0})
        row[word] += 1
        row["largest"] = max(row["largest"], 0.0 if found else worst)
        details = ", ".join(f"{name} {value:.1e}" for name, value in sorted(found.items(), key=lambda item: -item[1])[:6])
        note = f" ({why if found else 'known not to hold, and does'})" if why else ""
        print(f"{word:6s} {case.kind:10s} {case.name}: {worst:.1e}, exit codes {codes} {details}{note}", flush=True)
    for kind, row in table.items():
        print(f"{kind:10s} {row['ok']:4d} hold (largest difference {row['largest']:.1e}), {row['known']} are known not to, {row['FAILED']} failed")
    return bool(table) and not any(row["FAILED"] for row in table.values())


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("amontons")
    parser.add_argument("--only", default="", choices=[""] + list(KINDS))
    parser.add_argument("--scene", default="")
    parser.add_argument("--part", default="1/1")
    parser.add_argument("-j", type=int, default=1)
    parser.add_argument("--keep", default="")
    arguments = parser.parse_args()
    chosen = [case for case in cases(arguments.only, arguments.part) if arguments.scene in case.name]
    with tempfile.TemporaryDirectory(prefix="amontons-kinds-") as folder, concurrent.futures.ThreadPoolExecutor(arguments.j) as pool:
        runs = Runs(arguments.amontons, folder)
        good = report(pool.map(lambda case: tried(case, runs, arguments.keep), chosen))
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
