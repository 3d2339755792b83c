"""The scenes that other programs solve, too, as plain data: doc/studies.md. Units mm, N, MPa.

H2  half of a block with the surface of a cylinder on a flat block          parameters/verification/peers_cylinder.prm
CM  the whole of it with friction, pressed and then sheared                 parameters/verification/peers_shear.prm
HA  axisymmetric block with the surface of a sphere on a rigid plane        parameters/verification/peers_sphere.prm
H3  that in space, a quarter with a square cross-section                    parameters/verification/peers_sphere_3d.prm
PI  half of a pin with clearance in the hole of a large plate               parameters/verification/pin_in_hole.prm

Meshes are grids of lines. N cells reach over the length `a`, which is a little more than the contact; cells are as large to 1.3 a beside the axis and to `depth` from the
surface, then grow by 1.3 to the far sides. In the plane the flat block has 0.88 N cells where the curved one has N: their nodes do not match.
The grid of the pin is polar: along is the angle from the load, upwards the way from the surface into the body. The pin has a hole of BORE at its centre, whose edge is moved; nodes of pin and plate
match, as straight sides of 0.88 N cells overlap by a part of the clearance (CalculiX, linear, N = 20: an error of 274 %).
"""
import dataclasses
import math

E, NU, RADIUS = 210e3, 0.3, 50.0
CLEARANCE, BORE, PLATE = 0.00182, 0.02, 30.0  # of the pin, whose radius is 1
GROWTH, REACH, COARSER = 1.3, 1.3, 0.88


@dataclasses.dataclass(frozen=True)
class Case:
    name: str
    kind: str  # "plane", "axisymmetric", "space", "pin"
    size: float  # half width and height of a block
    a: float  # N cells are as long as this
    depth: float  # as a part of a
    press: float
    shear: float = 0.0
    friction: float = 0.0
    whole: bool = False  # to both sides of x = 0
    scene: str = ""

    @property
    def rigid(self):
        """Whether the other side is a rigid plane."""
        return self.kind in ("axisymmetric", "space")

    @property
    def clamped(self):
        """Whether the far sides are held across, too."""
        return self.whole or self.kind == "pin"

    @property
    def share(self):
        """Whole force over that of the mesh."""
        return {"plane": 1 if self.whole else 2, "axisymmetric": 1, "space": 4, "pin": 2}[self.kind]

    def lengths(self, lower):
        """Of the grid, along and upwards."""
        if self.kind == "pin":
            return math.pi, PLATE - 1 if lower else 1 - BORE
        return self.size, self.size

    def sagitta(self, r):
        """Height of the curved surface above the plane."""
        return RADIUS - math.sqrt(RADIUS**2 - r * r)


CASES = {case.name: case for case in (
    Case("H2", "plane", 48, 1.5, 0.5, 0.0903, scene="peers_cylinder"),
    Case("CM", "plane", 48, 1.5, 0.5, 0.0903, 0.0203, 0.3, True, scene="peers_shear"),
    Case("HA", "axisymmetric", 30, 3.0, 0.5, 0.161, scene="peers_sphere"),
    Case("H3", "space", 30, 3.0, 0.0, 0.161, scene="peers_sphere_3d"),
    Case("PI", "pin", 1, 0.9, 0.5, 0.0046, scene="pin_in_hole"))}


def line(h, equal, length):
    """Places 0, h, .., equal h, and on with cells that grow, at most by GROWTH, to `length`."""
    rest = length - equal * h
    many = math.ceil(math.log(1 + rest * (GROWTH - 1) / (GROWTH * h)) / math.log(GROWTH) - 1e-9)
    low, high = 1.0 + 1e-9, GROWTH
    for _ in range(100):
        q = 0.5 * (low + high)
        low, high = (q, high) if h * q * (q**many - 1) / (q - 1) < rest else (low, q)
    places = [h * k for k in range(equal + 1)]
    for k in range(many):
        places.append(places[-1] + h * q ** (k + 1))
    return places[:-1] + [float(length)]


def grid(case, N, lower=False):
    """Lines of a body along x (and y), and upwards: the lower one's go from -size to 0."""
    cells = COARSER * N if lower and case.kind != "pin" else N
    h = case.a / cells
    width, height = case.lengths(lower)
    along = line(h, math.ceil(REACH * cells - 1e-9), width)
    up = line(h, max(1, math.ceil(case.depth * cells - 1e-9)), height)
    if case.whole:
        along = [-x for x in reversed(along[1:])] + along
    up = [-y for y in reversed(up)] if lower else up
    return [along, along, up] if case.kind == "space" else [along, up]


def lifted(case, point, lower=False, clearance=0.0):
    """Where a node of the grid is: the curved body's lower side has the curve, its upper one is plane; the hole of the pin's plate is larger by `clearance`."""
    if case.kind == "pin":
        angle, r = point[0], 1 - point[1] + (clearance if lower else 0)
        return r * math.sin(angle), -r * math.cos(angle)
    if lower:
        return tuple(point)
    r = math.hypot(*point[:-1])
    return (*point[:-1], point[-1] + case.sagitta(r) * (1 - point[-1] / case.size))


def place(case, point):
    """Where a point of a surface in the plane is, from the middle of the contact: a length, of the pin an angle."""
    return math.atan2(point[0], -point[-1]) if case.kind == "pin" else point[0]
