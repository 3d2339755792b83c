"""Points of the failure atlas (atlas.py) that are the same scene in other words: two runs whose answers must agree, or a limit of one that is the other.

The scene is a block on a wider one, pressed and sheared: edges, slip zones, lifting, and no closed form.
"""
import math
from dataclasses import dataclass, replace

from atlas_parts import NU, Scene, block, condition, contact, estimated, friction, near, plane, scene, sound


@dataclass
class Press:
    """All of it, and how it is written down: turned, in other units, mirrored, in another order."""

    n: tuple
    E: tuple
    nu: tuple
    mu: float
    down: float
    aside: float
    left: float  # the upper block is [left, left + 1] on [-1, 2]
    slave: str = "first"
    increments: int = 4
    degree: int = 2
    tied: bool = False
    kinematics: str = "small strain"
    way: str = "table(0.5: 0, 1: 1)"
    press: str = "table(0: 0, 0.5: 1)"
    angle: float = 0.0
    length: float = 1.0
    stress: float = 1.0
    mirrored: bool = False
    swapped: bool = False

    def block(self, name, x, y, cells, k):
        if self.mirrored:
            x = -x[1], -x[0]
        lower, upper = ((x[j] * self.length, y[j] * self.length) for j in range(2))
        return block(name, lower, upper, cells, self.E[k] * self.stress, self.nu[k], Rotate=self.angle)

    def scene(self):
        sign, c, s = -1 if self.mirrored else 1, math.cos(math.radians(self.angle)), math.sin(math.radians(self.angle))
        x, y = sign * self.aside * self.length, -self.down * self.length
        move = "; ".join(f"{a * x!r}*{self.way} + {b * y!r}*{self.press}" for a, b in ((c, -s), (s, c)))
        bodies = [self.block("upper", (self.left, self.left + 1), (0, 1), (self.n[0], 2), 0), self.block("lower", (-1, 2), (-1, 0), (self.n[1], 3), 1)]
        conditions = [condition("upper/top", "displacement", move), condition("lower/bottom", "displacement", "0; 0")]
        law = {"Tied": "true"} if self.tied else friction(self.mu)
        sides, slave = ["upper/bottom", "lower/top"], self.slave
        if self.swapped:
            bodies, conditions, sides, slave = bodies[::-1], conditions[::-1], sides[::-1], {"first": "second", "second": "first"}[slave]
        joint = contact(*sides, Slave=slave, **law)
        return scene(*bodies, *conditions, joint, Kinematics=self.kinematics, Increments=self.increments, degree=self.degree)

    def name(self):
        bodies = f"{self.n[0]}on{self.n[1]} E1:{self.E[1] / self.E[0]:g} nu{self.nu[0]}and{self.nu[1]}"
        return f"{bodies} mu{self.mu} at{self.left:g} aside{self.aside:.3g} {self.slave} Q{self.degree}"


def press(r, friction_up_to=3, **more):
    E = 1000.0, 1000 * 10.0 ** r.choice([-3, -1, 0, 0, 1, 3])
    nu = r.choice(NU[:6]), r.choice(NU[:6])
    down = 2e-3
    values = {
        "n": (r.choice([2, 4, 9]), r.choice([3, 6, 15])), "E": E, "nu": nu, "mu": r.choice([mu for mu in [0, 0.1, 0.3, 0.6, 3] if mu <= friction_up_to]),
        "down": down, "aside": down * r.choice([0, 0.1, 0.5]), "left": r.choice([0.0, -0.6, 0.25]), "slave": r.choice(["first", "second"]),
        "degree": r.choice([1, 2]),
    }
    return Press(**{**values, **more})


def holds(answer, first, digits=1e-5):
    """What all answers of this scene must be: sound, and the lower support carries the contact force.
    On surfaces that bend, the force of a quadratic node follows the normal of its control point, which contact.csv does not hold."""
    digits = max(digits, 1e-3 if first.kinematics == "finite strain" else 0)
    (support,) = [reaction["force"] for reaction in answer.summary["reactions"] if reaction["boundary"] == "lower/bottom"]
    sign = 1 if first.slave == "first" else -1
    off = near("support", support, [sign * v for v in answer.force()[:2]], answer.size(), digits)
    return off + sound(answer, None if first.tied else first.mu, applied=(0, 0), digits=digits)


def pair(first, second, what, turn=None, scale=(1.0, 1.0), digits=1e-5):
    """Both are sound, and their forces and energies agree; scale: of the second's."""

    def check(answers):
        off = holds(answers[0], first) + holds(answers[1], second)
        force = answers[0].force()
        force = turn(force) if turn else force
        off += near("force", answers[1].force(), [scale[0] * v for v in force], scale[0] * answers[0].size(), digits)
        return off + near("energy", answers[1].summary["energy"], scale[1] * answers[0].summary["energy"], digits=digits)

    return f"{first.name()} {what}", [first.scene(), second.scene()], check


def turned(r):
    """By an angle."""
    first, angle = press(r), r.choice([90, 180, 30, 77.7])
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    return pair(first, replace(first, angle=angle), f"{angle}deg", lambda f: (c * f[0] - s * f[1], s * f[0] + c * f[1], 0))


def units(r):
    """In other units of length and stress: micrometres or kilometres, Pa or TPa."""
    first, length, stress = press(r), 10.0 ** r.choice([-6, -3, 3, 6]), 10.0 ** r.choice([-9, -3, 0, 6, 12])
    return pair(first, replace(first, length=length, stress=stress), f"L{length:g} S{stress:g}", scale=(length * stress, length**2 * stress))


def mirrored(r):
    first = press(r)
    return pair(first, replace(first, mirrored=True), "mirrored", lambda f: (-f[0], f[1], 0))


def swapped(r):
    """Bodies, conditions and sides of the pair in another order."""
    first = press(r)
    return pair(first, replace(first, swapped=True), "swapped")


def steps(r):
    """Without friction increments do not matter, at small nor finite strain."""
    kinematics = r.choice(["small strain", "finite strain"])
    first = press(r, 0, kinematics=kinematics, increments=r.choice([1, 2]))
    return pair(first, replace(first, increments=r.choice([5, 13])), kinematics)


def friction_steps(r):
    """With friction they do, as far as the program says."""
    first = press(r, mu=r.choice([0.1, 0.3, 0.6]), increments=r.choice([2, 4]))
    second = replace(first, increments=32)

    def check(answers):
        off = holds(answers[0], first) + holds(answers[1], first)
        said = sum(max(a.summary["increments"][key] for key in ("normal_force", "tangential_force", "shear", "pressure")) for a in answers)
        return off + near("force", answers[0].force(), answers[1].force(), answers[1].size(), 2 * said + 1e-5)

    return f"{first.name()} {first.increments}inc", [first.scene(), second.scene()], check


def sides(r):
    """Either side carries the pressure: the same forces, as far as the program says that the meshes are off."""
    first = press(r, slave="first")
    second = replace(first, slave="second")

    def check(answers):
        off = holds(answers[0], first) + holds(answers[1], second)
        other = [-v for v in answers[1].force()]
        return off + near("force", other, answers[0].force(), answers[0].size(), sum(estimated(a) for a in answers) + 1e-5)

    return first.name(), [first.scene(), second.scene()], check


def rough_is_tied(r):
    """With a very large coefficient nothing slides: as tied, where nothing opens."""
    first = press(r, mu=1e6, left=0.0, aside=2e-3 * r.choice([0, 0.05, 0.1]), nu=(0.0, 0.0))
    first = replace(first, E=(1000.0, 1000.0 * 10.0 ** r.choice([2, 4, 6])))

    def check(answers):
        off = ["slips or opens"] if any(row["state"] != "stick" for row in answers[0].rows if not math.isnan(row["gap"])) else []
        return off + holds(answers[0], first) + near("force", answers[1].force(), answers[0].force(), answers[0].size())

    return first.name(), [first.scene(), replace(first, tied=True).scene()], check


def stiff_is_rigid(r):
    """A lower block of 1e8 times the stiffness is a rigid one; the upper one is as on a plane."""
    first = press(r, left=0.0)
    first = replace(first, E=(1000.0, 1e11), slave="first", nu=(first.nu[0], 0.3))
    text = first.scene().text
    start = text.index("subsection Body lower")
    rigid = text[:start] + plane("lower", (0, 0), (0, 1)) + text[text.index("end", start) + 4 :]
    start = rigid.index("subsection Boundary condition lower")
    rigid = (rigid[:start] + rigid[rigid.index("end", start) + 4 :]).replace("lower/top", "lower")

    def check(answers):
        off = holds(answers[0], first, 1e-4) + sound(answers[1], first.mu)
        return off + near("force", answers[0].force(), answers[1].force(), answers[1].size(), 1e-4)

    return first.name(), [first.scene(), Scene(rigid)], check


def released(r):
    """Pressed (and sheared) and let go again: no force is left, and nothing but friction has taken work."""
    first = press(r, press="table(0: 0, 0.5: 1, 1: 0)", way="table(0.25: 0, 0.5: 1, 1: 1)", increments=8)

    def check(answers):
        (a,) = answers
        biggest = max(math.hypot(*mesh["pairs"][0]["normal_force"]) for mesh in a.summary["meshes"])
        off = near("force at the end", a.force(), [0, 0, 0], biggest, 1e-4) if not first.mu else []
        return off + sound(a, first.mu, least=biggest) + laws(a)

    return first.name(), [first.scene()], check


def laws(answer):
    """Friction takes work and gives none, from one increment to the next."""
    works = [mesh.get("dissipation", 0) for mesh in answer.summary["meshes"]]
    size = max([mesh["energy"] for mesh in answer.summary["meshes"]] + works)
    return [f"friction gives work: {a:.6e} then {b:.6e}" for a, b in zip(works, works[1:]) if b < a - 1e-6 * size][:1]


def reversed_shear(r):
    """Sheared to and fro under constant pressing, ending where it began: work of friction only grows, and the forces keep the cone."""
    way = r.choice(["table(0.2: 0, 0.4: 1, 0.8: -1, 1: 0)", "table(0.2: 0, 0.6: 1, 1: -1)"])
    first = press(r, mu=r.choice([0.05, 0.3, 1]), press="table(0: 0, 0.2: 1)", way=way, aside=2e-3 * r.choice([0.2, 1]), increments=r.choice([5, 15]))

    def check(answers):
        (a,) = answers
        return holds(a, first) + laws(a)

    return f"{first.name()} {first.increments}inc {'cycle' if '1: 0' in way else 'back'}", [first.scene()], check


def unloaded(r):
    """Nothing is moved or loaded: no forces, at floating blocks neither."""
    kinematics, mu, floating = r.choice(["small strain", "finite strain", "auto"]), r.choice([0, 0.3, 10]), r.choice([True, False])
    first = press(r, mu=mu, down=0.0, aside=0.0, kinematics=kinematics)
    result = first.scene()
    if floating:
        result.text = result.text.replace("Boundaries = upper/top\n  set Type = displacement", "Boundaries = upper/top\n  set Type = traction")

    def check(answers):
        (a,) = answers
        scale = min(first.E)
        return near("force", a.force(), [0, 0, 0], scale, 1e-9) + near("energy", a.summary["energy"], 0, scale, 1e-9)

    return f"{first.name()} {kinematics} {'floating' if floating else 'held'}", [result], check
