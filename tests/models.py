#!/usr/bin/env python3
"""Is less model enough, and what does it save? models.py AMONTONS [-j N] [--write PAGE]

Families of scenes that cross the thresholds of model selection (`Kinematics = auto`, `Model = automatic`), each member also with the full model: which model was
chosen, how far the contact force is from that of the full one (to agree within the target), and what both cost. By hand; not part of ctest.
"""
import argparse
import concurrent.futures
import sys
from dataclasses import dataclass

import scorecard_parts

TARGET = 0.01


@dataclass
class Family:
    name: str
    file: str
    entry: str  # what varies, % its value
    values: tuple
    full: str
    sign: str  # of a note that says that the full model was not taken
    sets: tuple = ()


FAMILIES = [
    Family("load: circle pressed into rubber by a part of its height", "verification/rubber_indentation.prm", "Obstacle cylinder/Displacement=0; -%g*t",
           (1e-4, 1e-3, 0.003, 0.01, 0.03, 0.1, 0.3), "Kinematics=finite strain", "small strain is enough", ("Kinematics=auto",)),
    Family("stiffness of a punch over that of a ring", "verification/stiff_punch.prm", "Body punch/Young modulus=%g", (1e2, 1e3, 1e4, 3e4, 1e5, 1e6, 1e8, 1e10),
           "Model=full", "is taken for rigid"),
    Family("stiffness of one of two equal blocks over the other's, friction 0.3", "verification/equal_blocks.prm", "Body upper/Young modulus=%g",
           (1000, 1001, 1010, 1100, 2000), "Model=full", "friction, and with it"),
]


@dataclass
class Row:
    family: Family
    value: float
    is_reduced: bool
    change: float
    chosen: tuple  # DoFs, seconds
    full: tuple

    def text(self):
        return (f"| {self.value:g} | {'less' if self.is_reduced else 'full'} | {100 * self.change:.2g} % | {self.chosen[0]} | {self.full[0]} | {self.chosen[1]:.1f} | "
                f"{self.full[1]:.1f} |")


HEAD = """| value | model | change of the force | DoFs | DoFs, full | seconds | seconds, full |
|---|---|---|---|---|---|---|"""


def solve(program, family, value, *more):
    run = scorecard_parts.Runner(program)
    answer = run(family.file, "Refinement/Cycles=-1", f"Refinement/Target error={TARGET}", family.entry % value, *family.sets, *more)
    return answer.summary, (answer.summary["dofs"], run.seconds)


def row_of(program, family, value):
    chosen, cost = solve(program, family, value)
    full, cost_of_full = solve(program, family, value, family.full)
    force = [summary["pairs"][0]["normal_force"][1] for summary in (chosen, full)]  # the other one cancels, where symmetry cuts a contact
    return Row(family, value, any(family.sign in note for note in chosen["notes"]), abs(force[0] / force[1] - 1), cost, cost_of_full)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program")
    parser.add_argument("-j", type=int, default=2)
    parser.add_argument("--write")
    arguments = parser.parse_args()
    wanted = [(family, value) for family in FAMILIES for value in family.values]
    with concurrent.futures.ThreadPoolExecutor(arguments.j) as pool:
        rows = list(pool.map(lambda what: row_of(arguments.program, *what), wanted))
    agree = [row for row in rows if row.change <= TARGET]
    text = f"{len(agree)} of {len(rows)} agree with the full model within the target of {100 * TARGET:g} %; {sum(row.is_reduced for row in rows)} do with less."
    for family in FAMILIES:
        text += f"\n\n## {family.name[0].upper() + family.name[1:]}\n\n{HEAD}\n" + "\n".join(row.text() for row in rows if row.family is family)
    print(text)
    if arguments.write:
        with open(arguments.write, "w") as page:
            page.write("# As little model as the target needs\n\nMade by `python3 tests/models.py build/amontons --write doc/models.md`; what is compared stands there. Seconds are of the processor.\n\n" + text + "\n")
    sys.exit(len(agree) < len(rows))


if __name__ == "__main__":
    main()
