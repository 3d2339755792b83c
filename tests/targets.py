#!/usr/bin/env python3
"""Are targets kept, and what do they cost? targets.py AMONTONS [-j N] [--only NAME] [--write PAGE]

Runs scenes with closed forms to target errors of 10, 3, 1 and 0.3 % with nothing else said of the mesh ('Target error' and Cycles = -1) and prints, for the pressure
and the tangential traction (in the mean square) and for numbers ('Target quantity'), the program's estimate, the true error, their ratio, meshes, unknowns, linear
solves and seconds. By hand; not part of ctest.

Half planes that are cut out with exact boundary values, rings and shrink fits have no error but that of the discretisation. The others are measured against
half spaces and parabolas, which the blocks and disks of the scene are not: what that leaves (`floor`, as in scorecard_formulas.py) is added to the target.
Where there is no closed form, the scene itself with a target of 0.1 % (with friction under a punch 0.3 %) is the measure; its increments are the same.
"""
import argparse
import bisect
import concurrent.futures
import functools
import math
import statistics
import sys
import threading
from dataclasses import dataclass

import scorecard_formulas as formulas
import scorecard_parts

TARGETS = (0.1, 0.03, 0.01, 0.003)
PRESSURE = "contact pressure"
ERRORS = {PRESSURE: "pressure_l2", "contact size": "contact_size", "stick size": "stick_size", "total force": "normal_force"}


def line(size, radius):
    """Floor of the pressure in the mean square, of a Hertz line contact on a block as high as `size`."""
    return lambda a: formulas.ellipse_change(formulas.block_line(a, size) + formulas.circle_line(a, radius))


def point(size, radius):
    return lambda a: formulas.ellipse_change(formulas.block_point(a, size)[0] + formulas.circle_point(a, radius), True)


@dataclass(frozen=True)
class Scene:
    name: str
    file: str
    sets: tuple = ()
    floor: object = None  # of the pressure, by the contact size
    quantities: tuple = (PRESSURE,)
    targets: tuple = TARGETS
    along: object = None  # no closed form: the coordinate of a contact node along the surface
    pair: str = None  # of this pair
    reference: float = 0.001  # its target there

    def run(self, run, target, quantity=PRESSURE):
        return run(self.file, "Refinement/Cycles=-1", f"Refinement/Target error={target}", f"Refinement/Target quantity={quantity}", *self.sets)


SCENES = [
    Scene("half planes, cut out", "half_plane_box.prm", quantities=(PRESSURE, "contact size", "total force")),
    Scene("half planes, cut out, linear elements", "half_plane_box.prm", ("Discretization/Degree=1",)),
    Scene("half planes, cut out, friction", "half_plane_box_friction.prm", quantities=(PRESSURE, "stick size")),
    Scene("half spaces, cut out, axisymmetric", "verification/half_space_box_axisymmetric.prm"),
    Scene("half spaces, cut out, in space", "half_space_box.prm", targets=(0.1, 0.03)),
    Scene("rings", "verification/rings.prm"),
    Scene("shrink fit", "verification/shrink_fit.prm"),
    Scene("cylinder on a block", "hertz_cylinder.prm", floor=line(10, 10)),
    Scene("two cylinders", "verification/two_cylinders.prm", floor=line(10, 10)),
    Scene("sphere, axisymmetric", "hertz_sphere_axisymmetric.prm", floor=point(10, 10)),
    Scene("sphere, in space", "hertz_sphere.prm", floor=point(10, 10), targets=(0.1, 0.03)),
    Scene("cone", "verification/cone.prm", floor=lambda a: formulas.block_point(a, 10)[1]),
    Scene("Cattaneo and Mindlin", "cattaneo_mindlin.prm", floor=line(10, 10), targets=(0.1, 0.03, 0.01)),
    Scene("disk between platens", "verification/disk_platen.prm"),
    Scene("cap in a seat", "verification/cap_in_seat.prm", targets=(0.1, 0.03, 0.01)),
    Scene("crossed cylinders", "crossed_cylinders.prm", targets=(0.1, 0.03)),
    Scene("two spheres", "two_spheres.prm", targets=(0.1, 0.03)),
    Scene("Mindlin's spheres", "mindlin_sphere.prm", targets=(0.1,)),
]


def angle(node):
    return math.atan2(node["X"], -node["Y"])


OWN = [
    Scene("pin with clearance", "verification/pin_in_hole.prm", targets=(0.1, 0.03, 0.01), along=angle),
    Scene("pin with clearance, coarse at first", "verification/pin_in_hole.prm", ("Body pin/Refinements=1", "Body plate/Refinements=1"), targets=(0.1, 0.03, 0.01), along=angle),
    Scene("NAFEMS, roller", "nafems_roller.prm", targets=(0.1, 0.03, 0.01), along=lambda node: node["X"], pair="roller"),
    Scene("NAFEMS, rounded punch", "nafems_punch.prm", targets=(0.1, 0.03, 0.01), along=lambda node: node["X"]),
    Scene("NAFEMS, rounded punch, friction", "nafems_punch_friction.prm", targets=(0.1, 0.03), along=lambda node: node["X"], reference=0.003),
    Scene("GRECO", "greco.prm", targets=(0.1, 0.03, 0.01), along=lambda node: node["X"]),
]

# Histories once more, on meshes that are refined on the way.
TRANSFERS = [Scene(scene.name + ", transfer", scene.file, scene.sets + ("Refinement/History=transfer",), scene.floor, targets=(0.1, 0.03, 0.01))
             for scene in SCENES if scene.file in ("half_plane_box_friction.prm", "cattaneo_mindlin.prm")]


@dataclass
class Row:
    scene: str
    quantity: str
    target: float
    floor: float
    estimate: float
    error: float
    meshes: int
    dofs: int
    solves: int
    seconds: float

    @property
    def share(self):
        """Of what is allowed."""
        return self.error / (self.target + self.floor)

    @property
    def ratio(self):
        return self.estimate / self.error if self.error > 0 else math.inf

    def text(self):
        floor = f"{100 * self.floor:.2g} %" if self.floor else ""
        return (f"| {self.scene} | {self.quantity} | {100 * self.target:g} % | {floor} | {100 * self.estimate:.3g} % | {100 * self.error:.3g} % | {self.share:.2f} | "
                f"{self.ratio:.2f} | {self.meshes} | {self.dofs} | {self.solves} | {self.seconds:.1f} |")


HEAD = """| scene | quantity | target | floor | estimate | true error | of what is allowed | estimate over error | meshes | DoFs | linear solves | seconds |
|---|---|---|---|---|---|---|---|---|---|---|---|"""


def differences(answer, reference, scene):
    """Of pressure and, with friction, tangential traction to those of a better answer, as the errors of closed forms."""
    line = reference.line(scene.pair, scene.along)
    ends = [nodes[-1]["s"] for nodes in line]

    def exact(key):
        return lambda s: scorecard_parts.interpolate(line[min(bisect.bisect_left(ends, s), len(line) - 1)], s, key)

    weight = (lambda s: s) if answer.kind == "axisymmetric" else (lambda s: 1.0)
    where = {"low": line[0][0]["s"], "high": ends[-1], "weight": weight, "pair": scene.pair, "coordinate": scene.along}
    errors = {"pressure_l2": answer.profile(exact("pressure"), **where)}
    if any(node["tx"] or node["ty"] for nodes in line for node in nodes):
        errors["shear_l2"] = answer.profile(exact("tx"), key="tx", **where)  # of surfaces along x
    return errors


@functools.lru_cache(maxsize=None)
def better_answer(program, scene):
    return scene.run(scorecard_parts.Runner(program), scene.reference)


def reference_of(program, scene, one_at_a_time=threading.Lock()):
    with one_at_a_time:  # runs of one scene that start at once wait for the same answer
        return better_answer(program, scene)


def rows_of(program, scene, quantity, target):
    run = scorecard_parts.Runner(program)
    answer = scene.run(run, target, quantity)
    told, last = answer.summary["error_estimate"], answer.summary["meshes"][-1]
    errors = differences(answer, reference_of(program, scene), scene) if scene.along else last["reference"]["errors"]
    floor = scene.floor(last["pairs"][0]["contact_size"]) if scene.floor else 0.0
    cost = len({mesh["dofs"] for mesh in answer.summary["meshes"]}), answer.summary["dofs"], answer.summary["linear_solves"], run.seconds
    if quantity != PRESSURE:
        return [Row(scene.name, quantity, target, floor, told["quantity"], abs(errors[ERRORS[quantity]]), *cost)]
    rows = [Row(scene.name, quantity, target, floor, told["contact"], errors[ERRORS[PRESSURE]], *cost)]
    return rows + ([Row(scene.name, "tangential traction", target, floor, told["shear"], errors["shear_l2"], *cost)] if "shear_l2" in errors else [])


def verdict(rows):
    kept, far = [row for row in rows if row.share <= 1], [row for row in rows if row.share > 1.5]
    # where an answer is better than its floor, or than asked for by far, its error says nothing of the estimate
    fields = [row.ratio for row in rows if row.quantity in (PRESSURE, "tangential traction") and row.error > 2 * row.floor]
    inside = [ratio for ratio in fields if 0.67 <= ratio <= 4]
    return (f"{len(kept)} of {len(rows)} targets are kept, {len(far)} missed by more than half. Estimates of fields over their true errors (where those are more than twice the floor): "
            f"median {statistics.median(fields):.2f}, from {min(fields):.2f} to {max(fields):.2f}, {len(inside)} of {len(fields)} between 0.67 and 4.")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program")
    parser.add_argument("-j", type=int, default=2)
    parser.add_argument("--only", default="")
    parser.add_argument("--write")
    arguments = parser.parse_args()
    wanted = [(scene, quantity, target) for scene in SCENES + OWN + TRANSFERS if arguments.only in scene.name for quantity in scene.quantities for target in scene.targets]
    rows, failures = [], []
    with concurrent.futures.ThreadPoolExecutor(arguments.j) as pool:
        print(HEAD)
        for what, future in [(what, pool.submit(rows_of, arguments.program, *what)) for what in wanted]:
            try:
                new = future.result()
            except scorecard_parts.NoAnswer as reason:
                failures.append(f"{what[0].name}, {what[1]}, {what[2]:g}: {reason}")
                continue
            rows += new
            print("\n".join(row.text() for row in new), flush=True)
    transferred = {scene.name for scene in TRANSFERS}
    own = [row for row in rows if row.scene not in transferred]
    text = verdict(own or rows) + "".join(f"\n\nNo answer: {failure}" for failure in failures)
    print("\n" + text)
    if arguments.write:
        with open(arguments.write, "w") as page:
            page.write("# Targets, and what they cost\n\nMade by `python3 tests/targets.py build/amontons --write doc/targets.md`; what the columns are stands there. Seconds are of the processor, for comparison within the table.\n\n"
                       + text + "\n\n" + HEAD + "\n" + "\n".join(row.text() for row in own) + "\n")
            if len(own) < len(rows):
                page.write("\n## Histories on meshes that are refined on the way\n\nWith `History = transfer` instead of `replay`, the default; not counted above.\n\n"
                           + HEAD + "\n" + "\n".join(row.text() for row in rows if row.scene in transferred) + "\n")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
