#!/usr/bin/env python3
"""Wrong scenes end with exit code 1 and one readable message: wrong_input.py AMONTONS READ_INPUTS [NAME-PART]...

Each case is written to a folder of its own and run there. Checked: exit code, one message on stderr that has the expected words
(a regular expression), no output folder left, no stack trace, done in time. What is refused while it is read, by one rank and without further arguments, is read
by READ_INPUTS, which has not to be started for each case; what it does not refuse is run. On 2 and 3 ranks: a case for each place where ranks could differ in what they
find (reader, kinds of files, meshes, surfaces, supports, expressions, output folder).
With NAME-PARTs, only cases whose names contain one of them.
"""
import concurrent.futures
import os
import re
import subprocess
import sys
import tempfile

import launch
import readers

SECONDS = 20
MEMORY = 4_000_000  # kB, of addresses

BASE = """set Kind = plane strain
subsection Body upper
  set Lower corner  = 0, 0
  set Upper corner  = 2, 1
  set Cells         = 3, 2
  set Young modulus = 1000
  set Poisson ratio = 0.3
end
subsection Body lower
  set Lower corner  = 0, -1
  set Upper corner  = 2, 0
  set Cells         = 4, 2
  set Young modulus = 1000
  set Poisson ratio = 0.3
end
subsection Boundary condition load
  set Boundaries = upper/top
  set Value      = 0; -0.01
end
subsection Boundary condition floor
  set Boundaries = lower/bottom
  set Value      = 0; 0
end
subsection Contact middle
  set First  = upper/bottom
  set Second = lower/top
end
"""

ONE_BODY = """subsection Body block
%s
  set Young modulus = 1
  set Poisson ratio = 0.3
end
subsection Boundary condition floor
  set Boundaries = block/bottom
  set Value      = 0; 0
end
"""

OBSTACLE = """subsection Body block
  set Lower corner = 0, -1
  set Upper corner = 1, 0
  set Cells        = 2, 2
  set Young modulus = 1
  set Poisson ratio = 0.3
end
subsection Boundary condition floor
  set Boundaries = block/bottom
  set Value      = 0; 0
end
subsection Obstacle tool
%s
end
subsection Contact top
  set First  = block/top
  set Second = tool
end
"""

MSH2 = """$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
1 1 "bottom"
2 2 "all"
$EndPhysicalNames
$Nodes
6
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 2 0 0
6 2 1 0
$EndNodes
$Elements
4
1 1 2 1 1 1 2
2 1 2 1 1 2 5
3 3 2 2 1 1 2 3 4
4 3 2 2 1 2 5 6 3
$EndElements
"""

MSH4 = """$MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
1
1 1 "bottom"
$EndPhysicalNames
$Entities
0 1 1 0
1 0 0 0 1 0 0 1 1 0
1 0 0 0 1 1 0 0 1 1
$EndEntities
$Nodes
1 4 1 4
2 1 0 4
1
2
3
4
0 0 0
1 0 0
1 1 0
0 1 0
$EndNodes
$Elements
2 2 1 2
1 1 1 1
1 1 2
2 1 3 1
2 1 2 3 4
$EndElements
"""

INP = """*NODE
1, 0, 0
2, 1, 0
3, 1, 1
4, 0, 1
*ELEMENT, TYPE=CPE4, ELSET=all
1, 1, 2, 3, 4
*NSET, NSET=bottom
1, 2
"""

CASES = []  # name, files, arguments, ranks, expected words (None: must run), expected line of scene.prm


def case(name, files, words, arguments=("scene.prm",), ranks=1, keep=(), leaves=()):
    if isinstance(files, (str, bytes)):
        files = {"scene.prm": files}
    CASES.append((name, files, list(arguments), ranks, words, keep, leaves))


def line_of(text, part):
    for number, line in enumerate(text.split("\n"), 1):
        if part in line:
            return number
    raise KeyError(part)


def change(name, old, new, words, text=BASE, ranks=1, part=None, leaves=()):
    """The scene `text` with `old` replaced; the message begins with the line of `part` (default: of `new`'s first line)."""
    assert old in text, (name, old)
    scene = text.replace(old, new, 1)
    number = line_of(scene, part if part is not None else new.strip().split("\n")[0])
    case(name, scene, rf"^scene\.prm:{number}: .*{words}", ranks=ranks, leaves=leaves)


def mesh(name, file, text, words, ranks=1, kind=""):
    case(name, {"scene.prm": kind + ONE_BODY % f"  set Mesh = {file}", file: text}, words, ranks=ranks)


def scenes():
    case("valid", BASE, None)
    case("valid on 3 ranks", BASE, None, ranks=3)

    # names
    change("unknown body", "lower/bottom", "lowr/bottom", r"unknown body 'lowr' \(did you mean 'lower'\?\).*upper, lower")
    change("unknown body in a contact", "= lower/top", "= loer/top", "unknown body 'loer'.*lower")
    change("unknown boundary", "lower/bottom", "lower/botom", "no boundary 'botom'.*bottom.*left, right", ranks=3)
    change("unknown boundary of a contact", "= lower/top", "= lower/tpo", "no boundary 'tpo'.*top")
    case("unknown section", BASE + "subsection Load steps\nend\n", r"unknown section 'Load steps'; allowed")
    case("misspelt section", BASE.replace("subsection Contact", "subsection Contct"), r"unknown section 'Contct [a-z]+' \(did you mean 'Contact [a-z]+'")
    change("unknown parameter", "set Young modulus", "set Young module", r"unknown entry 'Young module' \(did you mean 'Young modulus'")
    method = "subsection Contact solver\n  set Method = %s\nend"
    case("node to segment on moving surfaces", "set Kinematics = finite strain\n" + method % "node-to-segment" + "\n" + BASE,
         "Contact solver/Method: node-to-segment where surfaces move.*small strain")
    case("seed on moving surfaces", "set Kinematics = finite strain\n" + method % "seed" + "\n" + BASE,
         "Contact solver/Method: seed where surfaces move.*small strain")
    case("unknown method", method % "penality" + "\n" + BASE, "penality.*mortar")
    change("unknown section", "subsection Contact middle", "subsection Contct middle", "unknown section 'Contct middle'.*Contact middle")
    change("unknown obstacle", "= lower/top", "= tool", "unknown obstacle 'tool'", part="subsection Contact")
    change("body without boundary", "= lower/top", "= lower", "without a boundary.*lower/BOUNDARY", part="subsection Contact")
    change("slave = master", "= lower/top", "= upper/bottom", "slave = master", part="set Second")
    change("self contact", "= lower/top", "= upper/top", "self contact is not supported", part="set Second = upper/top")
    change("unknown closed form", "0; -0.01", "halfplane_eliptic(P = 1, a = 1)", "halfplane_eliptic.*did you mean 'halfplane_elliptic'")
    change("closed form with too much shear", "0; -0.01", "halfplane_elliptic(P = 1, a = 1, friction = 0.3, shear_ratio = -1)", "-1 < shear_ratio < 1")
    change("closed form without a parameter", "0; -0.01", "halfplane_elliptic(P = 1)", "'a' is missing")
    reference = BASE + "subsection Reference\n  set Solution = %s\nend\n"
    for name, solution, words in [("unknown", "hertz_lin(P = 1)", "did you mean 'hertz_line'"),
                                  ("missing parameter", "hertz_line(P = 1, R = 1, E1 = 1)", "'nu1' is missing"),
                                  ("unknown parameter", "hertz_line(P = 1, R = 1, E1 = 1, nu1 = 0.3, Q = 1)", "the parameter 'Q'"),
                                  ("of points in the plane", "hertz_point(P = 1, R = 1, E1 = 1, nu1 = 0.3)", "hertz_point.*in a plane scene.*axisymmetric"),
                                  ("negative", "hertz_line(P = -1, R = 1, E1 = 1, nu1 = 0.3)", "P = -1.*positive"),
                                  ("sliding", "cattaneo_mindlin(P = 1, R = 1, E1 = 1, nu1 = 0.3, friction = 0.3, Q = 0.4)", "friction cannot carry"),
                                  ("no shear force", "mindlin_sphere(P = 1, R = 1, E1 = 1, nu1 = 0.3, friction = 0.3)", "'Q' is missing"),
                                  ("reversals", "cattaneo_mindlin(P = 1, R = 1, E1 = 1, nu1 = 0.3, friction = 0.3, Q = 0.1, reversals = 1)", "reversals without Q_max"),
                                  ("half planes with friction", "half_plane_box(a = 1, R = 1, E1 = 1, nu1 = 0.3, friction = 0.3)", "not elastically similar"),
                                  ("shear ratio", "half_plane_box(a = 1, R = 1, E1 = 1, nu1 = 0.3, shear_ratio = 0.3)", "shear_ratio without friction")]:
        text = reference % solution
        case("reference: " + name, text, rf"^scene\.prm:{line_of(text, 'Solution')}: .*{words}")
    text = BASE + "subsection Reference\n  set Solution = uniform(p = 1, width = 1)\n  set Contact = midle\nend\n"
    case("reference: unknown contact", text, "unknown contact 'midle'.*middle")

    # values
    change("wrong type", "= 1000", "= stiff", "found 'stiff'.*number")
    change("wrong choice", "Kind = plane strain", "Kind = plain strain", "found 'plain strain'.*plane strain")
    change("one unit", "set Kind", "set Units = mm\nset Kind", "Units: found 'mm'; allowed: LENGTH, FORCE, as in 'mm, N'")
    change("units in another order", "set Kind", "set Units = N, mm\nset Kind", "found 'N, mm'.*first the unit of length")
    change("unknown kinematics", "set Kind", "set Kinematics = large strain\nset Kind", "found 'large strain'.*small strain, finite strain, auto")
    twice = BASE + "subsection Boundary condition again\n  set Boundaries = lower/bottom\n  set Value = free; 0.5\nend\n"
    case("two displacements of a boundary", twice, rf"^scene\.prm:{line_of(twice, 'condition again')}: .*y of 'lower/bottom' is moved by 0\.5, and by 0 in Boundary condition .*, line")
    change("unknown law", "= 0.3", "= 0.3\n  set Law = Mooney-Rivlin", "Body upper/Law: found 'Mooney-Rivlin'.*neo-Hookean, St. Venant-Kirchhoff", part="set Law")
    change("not a flag", "= lower/top", "= lower/top\n  set Tied = perhaps", "found 'perhaps'", part="set Tied")
    change("nu = 0.5", "= 0.3", "= 0.5", r"found 0\.5.*less than 0\.5")
    change("nu = 0.6", "= 0.3", "= 0.6", r"found 0\.6.*less than 0\.5", ranks=2)
    change("nu = -1", "= 0.3", "= -1", "more than -1")
    for line in "  set Young modulus = 1000\n", "  set Poisson ratio = 0.3\n", "  set Lower corner  = 0, 0\n", "  set Upper corner  = 2, 1\n":
        name = line.split("=")[0].strip()[4:]
        change(name + " is missing", line, "", f"Body upper/{name}: this entry is missing.*no default", part="Body upper")
    change("E is empty", "= 1000", "=", "this entry is missing", part="  set Young modulus =")
    for name, lines, missing in [("radius of a disk", "  set Mesh = disk", "Radius"), ("radius of a ring", "  set Mesh = ring\n  set Inner radius = 1", "Radius"),
                                 ("inner radius of a ring", "  set Mesh = ring\n  set Radius = 1", "Inner radius")]:
        case(name + " is missing", ONE_BODY % lines, rf"^scene\.prm:1: Body block/{missing}: this entry is missing.*for Mesh = ")
    case("length of a cylinder is missing", "set Kind = 3D\n" + ONE_BODY % "  set Mesh = cylinder\n  set Radius = 1", r"^scene\.prm:2: Body block/Length: this entry is missing")
    for name, lines, missing in [("radius of a circle", "  set Surface = circle", "Radius"), ("radius of a paraboloid", "  set Surface = paraboloid", "Radius"),
                                 ("flank of a cone", "  set Surface = cone", "Flank angle")]:
        case(name + " is missing", OBSTACLE % lines, rf"Obstacle tool/{missing}: this entry is missing.*for Surface = ")
    case("rigid body without E", BASE.replace("  set Young modulus = 1000\n  set Poisson ratio = 0.3\n", "  set Rigid = true\n  set Displacement = 0; -0.01\n", 1)
         .replace("subsection Boundary condition load\n  set Boundaries = upper/top\n  set Value      = 0; -0.01\nend\n", ""), None)
    change("E = 0", "= 1000", "= 0", "found 0.*positive", part="set Young modulus = 0")
    change("E < 0", "= 1000", "= -5", "found '?-5")
    change("E = inf", "= 1000", "= inf", "found '?inf")
    change("E = nan", "= 1000", "= nan", "found '?nan")
    change("no numbers", "= 3, 2", "= 3", "found '3'")
    change("Cells = 0", "= 3, 2", "= 3, 0", "found '3, 0'")
    change("huge Cells", "= 3, 2", "= 20000, 20000", "cells", part="Body upper", ranks=2)
    change("huge Cells beyond integers", "= 3, 2", "= 99999999999, 2", "found '99999999999, 2'")
    change("many coarse cells", "= 3, 2", "= 4000, 4000", "at most 2e6", part="Body upper")
    change("many refinements", "= 3, 2", "= 3, 2\n  set Refinements = 20", "at most 5e7", part="Body upper")
    change("negative refinements", "= 3, 2", "= 3, 2\n  set Refinements = -1", "found '-1'", part="Refinements")
    change("zero thickness", "= 2, 1", "= 2, 0", "larger coordinates")
    change("grading", "= 3, 2", "= 3, 2\n  set Grading = 0, 1", "positive", part="Grading")
    change("grading without cells", "= 3, 2", "= 300, 2\n  set Grading = 1e300, 1", "too thin", part="Body upper")
    change("unknown shape", "set Lower corner  = 0, 0", "set Mesh = blok\n  set Lower corner  = 0, 0", "did you mean 'block'", part="blok")
    change("radius of a block", "set Lower corner  = 0, 0", "set Radius = 3\n  set Lower corner  = 0, 0", "no meaning", part="Radius")
    change("thin ring", "  set Lower corner  = 0, 0\n  set Upper corner  = 2, 1\n  set Cells         = 3, 2\n",
           "  set Mesh = ring\n  set Radius = 1\n  set Inner radius = 0.999999999999\n", "cells", part="Body upper")
    change("inner radius", "  set Lower corner  = 0, 0\n  set Upper corner  = 2, 1\n  set Cells         = 3, 2\n",
           "  set Mesh = ring\n  set Radius = 1\n  set Inner radius = 2\n", "less than the outer radius", part="Inner radius")
    change("negative radius", "Kind = plane strain", "Kind = axisymmetric", "negative radius.*x >= 0",
           text=BASE.replace("Lower corner  = 0, 0", "Lower corner  = -1, 0"), part="Lower corner  = -1, 0")
    case("negative radius after placement",
         BASE.replace("plane strain", "axisymmetric").replace("= 3, 2", "= 3, 2\n  set Rotate = 90"), "axisymmetric.*x >= 0", ranks=2)
    change("negative radius of a disk", "Kind = plane strain", "Kind = axisymmetric", "axisymmetric.*quarter disk",
           text=BASE.replace("  set Lower corner  = 0, 0\n  set Upper corner  = 2, 1\n  set Cells         = 3, 2\n",
                             "  set Mesh = half disk\n  set Centre = 0, 1\n  set Radius = 1\n"), part="Body upper")
    change("End time", "set Kind", "set End time = 0\nset Kind", "positive")
    change("third component in the plane", "Value      = 0; -0.01", "Value      = 0; -0.01; 3", r"3 component\(s\).*2 component\(s\)")
    case("third component that says nothing", BASE.replace("Value      = 0; -0.01", "Value      = 0; -0.01; 0"), None)
    change("negative End time", "set Kind", "set End time = -1\nset Kind", "positive")
    change("Increments", "set Kind", "set Increments = 0\nset Kind", "found '0'.*automatic, or an integer n >= 1")
    for name, entry, words in [("no integer", "Increments = 2.5", r"found '2\.5'.*automatic"), ("minimum increment", "Minimum increment = 2", "found 2.*fraction"),
                               ("no minimum increment", "Minimum increment = 0", "positive"), ("output time after the end", "Output times = 0.5, 3", r"found 3.*\(0, End time\]"),
                               ("output time 0", "Output times = 0, 1", r"found 0.*\(0, End time\]"), ("output times decrease", "Output times = 0.9, 0.5", "found 0.5.*increasing"),
                               ("output times that are no numbers", "Output times = 0.5, end", "found 'end'.*numbers")]:
        change("load program: " + name, "set Kind", f"set {entry}\nset Kind", words)
    for name, entry, words in [("negative", "Friction coefficient = -0.1", r"found -0\.1, a negative bound.*the place, t and p"),
                               ("negative bound", "Tresca bound = 2-3", "found 2-3, a negative bound"),
                               ("unknown variable", "Friction coefficient = 0.3*q", r"cannot be read.*\"q\".*p \(contact pressure\)"),
                               ("r in plane strain", "Tresca bound = r", "variable r"), ("not finite", "Friction coefficient = 1/0", "not a finite number"),
                               ("pressure elsewhere", "Initial gap = p", "variable p, which has no meaning here.*x, y, t"), ("z in the plane", "Initial gap = z", "variable z.*x, y, t"),
                               ("random", "Friction coefficient = rand()", "function rand")]:
        change("friction: " + name, "= lower/top", "= lower/top\n  set " + entry, words, part="set " + entry)
    change("friction: negative where bodies touch", "= lower/top", "= lower/top\n  set Friction coefficient = 0.3-x", r"'0\.3-x' is negative at x = .*t = 0\.", part="Friction", ranks=2)
    case("a name in Latin-1", {"scene.prm": BASE.replace("Body upper", "Body \xfcpper").encode("latin-1")}, r"^scene\.prm:2: .*the name '.xfcpper'.*UTF-8")
    for entry in "Friction coefficient = 0.3", "Tresca bound = 1", "Initial gap = -0.1*t":
        change("tied: " + entry, "= lower/top", f"= lower/top\n  set Tied = true\n  set {entry}", "no meaning for Tied = true", part="set " + entry)
    change("Points of a probe", "set Kind", "subsection Probe P\nset Body = upper\nset From = 0, 0\nset To = 1, 1\nset Points = 2000000000\nend\nset Kind",
           "found", part="Points")
    change("probe without a place", "set Kind", "subsection Probe P\nset Body = upper\nend\nset Kind", "no place")
    change("probe of an unknown body", "set Kind", "subsection Probe P\nset Body = uper\nset Point = 0, 0\nend\nset Kind", "unknown body 'uper'",
           part="Probe P")
    change("probe without a body", "set Kind", "subsection Probe P\nset Point = 0, 0\nend\nset Kind", "the body is missing; allowed: body upper, lower",
           part="Probe P")

    refinement = "subsection Refinement\n  set %s\nend\n"
    for name, entries, words in [("negative target", "Target error = -0.5", "Target error: found -0.5.*-1 .chosen"), ("target in per cent", "Target error = 5", r"Target error: found 5;.*0.05 is 5 %"), ("dissipation without friction", "Target quantity = dissipation", "dissipation of a scene without friction"),
                                 ("unknown target quantity", "Target quantity = pressure", "approach")]:
        case(name, BASE + refinement % entries, words)

    for name, bytes_, words in [("bytes that are no UTF-8", b"\xff\xd4", r"found '\\xff\\xd4'"), ("a very long word", b"x" * 3000, r"found 'x{80}\.\.\.'"), ("a control character", b"\x1b[2J", r"found '\\x1b\[2J'")]:
        case(name, BASE.encode().replace(b"= plane strain", b"= " + bytes_), "^scene\.prm:1: Kind: " + words)

    # expressions
    change("expression error", "0; -0.01", "0; -0.01*(x", "cannot be read")
    change("unknown function", "0; -0.01", "0; sine(x)", "cannot be read.*sine")
    change("unknown variable", "0; -0.01", "0; -0.01*w", "cannot be read.*w")
    change("r in plane strain", "0; -0.01", "0; -0.01*r", "variable r")
    change("z in the plane", "0; -0.01", "0; -0.01*z", "variable z, which has no meaning here.*x, y, t")
    change("pressure in a displacement", "0; -0.01", "0; -0.01*p", "variable p")
    change("place in a total force", "  set Value      = 0; -0.01", "  set Type = total force\n  set Value      = 0; -x", "variable x.*expression of t,", part="0; -x")
    change("place in a motion", "  set Value      = 0; -0.01", "  set Type = platen\n  set Displacement = 0; -0.01*y", "variable y.*expression of t,", part="0; -0.01*y")
    change("expression for a modulus", "= 1000", "= 1000*x", "found '1000.x'.*number", part="1000*x")
    change("expression for Adjust", "= lower/top", "= lower/top\n  set Adjust = 0.1*t", "found '0.1.t'.*number", part="set Adjust")
    change("components", "0; -0.01", "0", "1 component", part="set Value      = 0")
    change("nothing prescribed", "0; -0.01", "free; free", "prescribes nothing")
    change("table", "0; -0.01", "0; table(0: 0, 1)", "table")
    change("table whose times decrease", "0; -0.01", "0; table(1: 0, 0: 1)", "increas")
    change("constant that is not finite", "0; -0.01", "0; log(-1)", "finite")
    change("constant division by zero", "0; -0.01", "0; 1/0", "finite")
    for ranks in 1, 2, 3:
        change(f"infinite displacement, {ranks} ranks", "0; -0.01", "0; -0.01/x", r"infinite at x = 0, y = 1", ranks=ranks)
        change(f"displacement that is no number, {ranks} ranks", "0; -0.01", "0; -0.01*log(x-5)", r"not a number at x = .*, y = 1",
               ranks=ranks)
        change(f"traction that is no number, {ranks} ranks", "  set Value      = 0; -0.01",
               "  set Type = traction\n  set Value      = 0; sqrt(0.3-x)", r"not a number at x = .*, y = 1", ranks=ranks, part="set Value      = 0; sqrt")
    change("pressure that is no number", "  set Value      = 0; -0.01", "  set Type = pressure\n  set Value      = log(-1-x)", "not a number",
           part="set Value      = log")
    change("body force that is no number", "= 3, 2", "= 3, 2\n  set Body force = 0; log(-y)", "not a number at x", part="Body force")
    change("initial gap that is no number", "= lower/top", "= lower/top\n  set Initial gap = sqrt(x-1)", "not a number at x", part="Initial gap", ranks=2)
    change("value that is no number later", "set Kind = plane strain", "set Increments = 4\nset Kind = plane strain", "not a number at .*t = 0.5",
           text=BASE.replace("0; -0.01", "0; -0.01*t+0*sqrt(0.3-t)"), part="set Value      = 0; -0.01", ranks=2, leaves=("output",))  # its first increment
    case("total force on the axis", BASE.replace("plane strain", "axisymmetric").replace(
        "  set Boundaries = upper/top\n  set Value      = 0; -0.01", "  set Boundaries = upper/left\n  set Type = total force\n  set Value = 0; -1"),
         "area|axis")

    # structure of the file
    change("missing end", "= 0, 0\n  set Upper corner  = 2, 1\n", "= 0, 0\n  set Upper corner  = 2, 1\n  subsection Deep\n", "no 'end'|Deep",
           part="Body upper")
    change("end too many", "set Kind = plane strain", "set Kind = plane strain\nend", "no section is open", part="end")
    scene = BASE + "subsection Body upper\nend\n"
    case("duplicate section", scene, rf"^scene\.prm:{len(BASE.splitlines()) + 1}: .*second time \(first in line 2\)")
    change("duplicate entry", "= 0.3", "= 0.3\n  set Poisson ratio = 0.2", r"second time \(first in line", part="= 0.2")
    change("no keyword", "set Kind", "Kind", "found 'Kind = plane strain'.*subsection")
    change("misspelt keyword", "subsection Body upper", "subsecton Body upper", "did you mean 'subsection'")
    change("no equals", "set Kind = plane strain", "set Kind plane strain", "set NAME = VALUE")
    change("section without a name", "subsection Contact middle", "subsection Contact", "no name")
    case("empty file", "", r"^scene\.prm: .*no body")
    case("binary file", bytes(range(256)) * 40, r"^scene\.prm:\d+: .*no text file")
    case("executable as scene", {}, "no text file|found", arguments=["EXECUTABLE"])
    case("missing scene", {}, "nothing.prm.*cannot be opened", arguments=["nothing.prm"], ranks=2)
    case("folder as scene", {}, "cannot be opened", arguments=["."])
    case("include loop", "include scene.prm\n" + BASE, "include each other")
    case("include of a missing file", "include nothing.prm\n" + BASE, r"^scene\.prm:1: .*nothing\.prm")
    case("continued at the end", BASE + "set Title = a \\", "ends after")
    case("two obstacles of one name", OBSTACLE % "  set Surface = plane\n  set Normal = 0, -1" + "subsection Obstacle tool\nend\n", "second time")

    # files that are right
    case("Windows line ends", BASE.replace("\n", "\r\n").encode(), None)
    case("tabs", BASE.replace("  set ", "\tset\t").replace(" = ", "\t=\t"), None)
    case("byte order mark", b"\xef\xbb\xbf" + BASE.encode(), None)
    case("comments after values", BASE.replace("= 0.3", "= 0.3 # steel").replace("end\n", "end # of it\n"), None)
    case("include", {"scene.prm": "include parts/a.prm\n", "parts/a.prm": BASE}, None)
    case("probe outside", BASE + "subsection Probe P\n  set Body = upper\n  set Point = 9, 9\nend\n", None)
    case("probe outside, 2 ranks", BASE + "subsection Probe P\n  set Body = upper\n  set Point = 9, 9\nend\n", None, ranks=2)
    json = ('{"Body upper": {"Lower corner": [0, 0], "Upper corner": [2, 1], "Young modulus": 100, "Poisson ratio": 0.3}, "Boundary condition a": '
            '{"Boundaries": "upper/bottom", "Value": [0, 0]}, "Boundary condition b": {"Boundaries": "upper/top", "Value": [0, -0.01]}}')
    case("JSON", {"scene.json": json}, None, arguments=["scene.json"])
    case("JSON with a byte order mark", {"scene.json": b"\xef\xbb\xbf" + json.encode()}, None, arguments=["scene.json"])

    # JSON that is wrong
    for name, old, new, words in [("unreadable", '"Value"', '"Value', r"^scene\.json:\d+: .*no JSON"), ("entry", "Young modulus", "Yung modulus", "Yung modulus.*did you mean"),
                                  ("type", "100", '"soft"', "found 'soft'"), ("body", "upper/top", "uper/top", "unknown body 'uper'"),
                                  ("expression", "-0.01", '"-0.01*q"', "cannot be read"), ("array", '{"Body upper"', '{"Material": [{"a": 1}], "Body upper"', "Material")]:
        assert old in json
        case("JSON: " + name, {"scene.json": json.replace(old, new, 1)}, words, arguments=["scene.json"])
    case("JSON: empty", {"scene.json": ""}, r"^scene\.json:\d+: .*no JSON", arguments=["scene.json"])

    # mechanics
    drop = BASE.replace("  set Boundaries = upper/top\n  set Value      = 0; -0.01", "  set Boundaries = upper/top\n  set Type = traction\n  set Value = %s")
    contact = drop[drop.index("subsection Contact"):]
    squeezed = open(os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "parameters/verification/disk_squeezed.prm"), encoding="utf-8").read().replace("0.5*t; -0.01*t", "0; t")
    for kinematics in ("small", "finite"):  # nodal normals of facets seem to hold it
        driven = squeezed.replace("finite strain", f"{kinematics} strain").replace("Poisson ratio = 0.3", "Poisson ratio = 0.3\n  set Body force = 1e-4*t; -t")
        case(f"disk driven along a plane, {kinematics} strain", driven, "nothing holds the rigid motion along x of body 'disk', and the loads drive it")
        rolling = driven.replace("Second = lower", "Second = lower\n  set Friction coefficient = 0.5").replace("subsection Contact above\n  set First  = disk/arc\n  set Second = upper\nend\n", "")
        case(f"disk that rolls down a rough plane, {kinematics} strain", rolling, "the round body 'disk' rolls on its plane, whatever the friction, and the loads drive it")
    case("plane whose back the body lies on, finite strain",
         "set Kinematics = finite strain\nsubsection Body b\n  set Lower corner = 0, -1\n  set Upper corner = 2, 0\n  set Young modulus = 1\n  set Poisson ratio = 0\nend\n"
         "subsection Obstacle o\n  set Surface = plane\n  set Normal = 0, 1\n  set Displacement = 0; -0.05*t\nend\nsubsection Boundary condition c\n  set Boundaries = b/bottom\n  set Value = 0; 0\nend\n"
         "subsection Contact k\n  set First = b/top\n  set Second = o\nend\n", "do not face each other: the body lies behind the plane; allowed: an obstacle that looks at the boundary")
    for ranks in 1, 2, 3:
        case(f"sideways load that contact cannot hold, {ranks} ranks", drop % "1; -1", "holds.*upper|rigid.*upper", ranks=ranks)
    case("load on a body without supports", (drop % "0; -1").replace(contact, ""), "holds.*upper", ranks=2)
    case("moment on a free body", (drop % "0; x-1").replace(contact, ""), "holds.*rotation.*upper")
    change("overlap", "= 0, 0\n  set Upper corner  = 2, 1", "= 0, -0.2\n  set Upper corner  = 2, 1", r"overlap by 0\.2.*Initial gap", part="subsection Contact", ranks=2)
    facing = "do not face each other: along the normals nothing of one is opposite"
    change("sides that do not face each other", "= lower/top", "= lower/bottom", f"'upper/bottom' and 'lower/bottom' {facing}.*finite strain", part="subsection Contact", ranks=2)
    change("tied sides that do not face each other, finite strain", "set Kind", "set Kinematics = finite strain\nset Kind", facing,
           text=BASE.replace("= lower/top", "= lower/bottom\n  set Tied = true"), part="subsection Contact")
    change("sides that look away from each other", "= lower/top", "= lower/bottom", "look away from each other.* 2 behind", part="subsection Contact", ranks=2,
           text=BASE.replace("First  = upper/bottom", "First  = upper/top"))
    change("declared gap of sides that look away from each other", "= lower/top", "= lower/bottom\n  set Initial gap = 0", "look away from each other", part="subsection Contact",
           text=BASE.replace("First  = upper/bottom", "First  = upper/top"))
    solid_blocks = BASE
    for old, new in [("plane strain", "3D"), ("= 0, 0\n", "= 0, 0, 0\n"), ("= 2, 1\n", "= 2, 1, 1\n"), ("= 0, -1\n", "= 0, 0, -1\n"), ("= 2, 0\n", "= 2, 1, 0\n"), ("= 3, 2", "= 3, 1, 2"),
                     ("= 4, 2", "= 4, 1, 2"), ("= 0; -0.01", "= 0; 0; -0.01"), ("= 0; 0\n", "= 0; 0; 0\n")]:
        solid_blocks = solid_blocks.replace(old, new)
    case("valid in 3D", solid_blocks, None)
    change("sides that do not face each other in 3D", "= lower/top", "= lower/front", facing, part="subsection Contact", text=solid_blocks, ranks=2)
    ring = BASE.replace("  set Lower corner  = 0, 0\n  set Upper corner  = 2, 1\n  set Cells         = 3, 2\n", "  set Mesh = ring\n  set Centre = 1, 2\n  set Radius = 2\n  set Inner radius = 1.5\n")
    case("ring on a block", ring.replace("upper/top", "upper/inner").replace("upper/bottom", "upper/outer"), None)
    change("ring on a block, by its inner side", "upper/bottom", "upper/inner\n  set Slave = second", "do not face each other: one of the two bodies lies between them", part="subsection Contact", ranks=2,
           text=ring.replace("upper/top", "upper/outer"))
    change("traction of a rigid body", "= 3, 2", "= 3, 2\n  set Rigid = true", "rigid", part="set Boundaries = upper/top")
    change("boundary twice", "= lower/bottom", "= lower/bottom, lower/bottom", "twice")
    change("pair twice", "subsection Contact middle", "subsection Contact other\n  set First = upper/bottom\n  set Second = lower/top\nend\nsubsection Contact middle",
           "same two surfaces", part="Contact middle")

    # obstacles and platens
    for name, text, words in [("surface", "  set Surface = ball", "found 'ball'.*sphere"), ("radius", "  set Surface = circle\n  set Radius = 0", "positive"),
                              ("normal", "  set Normal = 0, 0", "direction"), ("normal of a circle", "  set Surface = circle\n  set Normal = 1, 0", "no meaning"),
                              ("flank", "  set Surface = cone\n  set Flank angle = 90", "between 0 and 90"),
                              ("free component with a force", "  set Displacement = 0; 0\n  set Force = 0; -1", "'free'"),
                              ("motion", "  set Displacement = 0", "1 component"), ("expression", "  set Displacement = 0; -q", "cannot be read"),
                              ("no number", "  set Normal = 0, -1\n  set Displacement = 0; log(-t)", "not a number|infinite"),
                              ("force that is no number", "  set Normal = 0, -1\n  set Force = 0; log(-t)", "not a number"),
                              ("free rotation at finite strain", "  set Displacement = 0; -0.01\n  set Rotation = free", "a free rotation, which finite strain does not have"),
                              ("moment without free rotation", "  set Normal = 0, -1\n  set Rotation = 0\n  set Moment = 1", "free")]:
        kinematics = "set Kinematics = finite strain\n" if "finite strain" in name else ""
        case("obstacle: " + name, kinematics + OBSTACLE % text, r"^scene\.prm:\d+: .*" + words, ranks=2 if "number" in name else 1)
    for name, text, words in [("the wrong normal", "Normal = 0, 1", "do not face each other.*nothing.*Normal"), ("a circle below", "Surface = circle\n  set Radius = 1\n  set Centre = 0.5, -2",
                               "do not face|look away"), ("a hollow circle above", "Surface = circle\n  set Radius = 1\n  set Centre = 0.5, 1\n  set Hollow = true", "on the back of the obstacle.*Hollow")]:
        case("obstacle with " + name, OBSTACLE % ("  set " + text), r"^scene\.prm:\d+: Contact top: .*" + words, ranks=2 if "normal" in name else 1)
    case("obstacle overlaps", OBSTACLE % "  set Normal = 0, -1\n  set Centre = 0, -0.3", "overlap")
    change("platen with a value", "  set Value      = 0; -0.01", "  set Type = platen\n  set Value      = 0; -0.01", "no meaning.*platen", part="set Value      = 0; -0.01")
    change("platen with a held force", "  set Value      = 0; -0.01", "  set Type = platen\n  set Displacement = 0; 0\n  set Force = 0; -1", "'free'", part="set Force")
    change("motion without a platen", "  set Value      = 0; -0.01", "  set Value      = 0; -0.01\n  set Force = 0; -1", "only for a platen", part="set Force")
    change("radial platen", "  set Value      = 0; -0.01", "  set Type = platen\n  set Displacement = 1; 0", "radial", part="set Displacement",
           text=BASE.replace("plane strain", "axisymmetric"))

    # meshes
    mesh("mesh .msh 2.2", "m.msh", MSH2, None)
    mesh("mesh .msh 4.1", "m.msh", MSH4, None, ranks=2)
    mesh("mesh .inp", "m.inp", INP, None)
    for name, text in [("m.msh", MSH2), ("m.inp", INP)]:
        case(f"part that is not in the file, {name}", {"scene.prm": ONE_BODY % f"  set Mesh = {name}\n  set Part = alll", name: text},
             r"^scene\.prm:1: Body block: the mesh file has no part 'alll' \(did you mean 'all'\?\); allowed: all", ranks=2 if name == "m.msh" else 1)
    case("part of a shape", ONE_BODY % "  set Mesh = disk\n  set Radius = 1\n  set Part = all", r"^scene\.prm:4: Body block/Part: .*for Mesh = disk")
    mesh("mesh with Windows line ends", "m.msh", MSH2.replace("\n", "\r\n").encode(), None)
    seam = MSH2.replace("$Nodes\n6", "$Nodes\n8").replace("6 2 1 0\n", "6 2 1 0\n7 1 0 0\n8 1 1 0\n").replace("2 5 6 3", "7 5 6 8")
    mesh("mesh with a seam", "m.msh", seam, r"^scene\.prm:1: Body block: the mesh is in 2 parts that share no edge of a cell, though 2 of one are where another has one, too, as at \(1 [01]\)", ranks=2)
    mesh("mesh with a seam between common ends", "m.msh", seam.replace("7 5 6 8", "7 5 6 3"),
         r"^scene\.prm:1: Body block: the mesh is in 2 parts that share no edge of a cell, though 1 of one are where another has one, too, as at \(1 0\)")
    case("a mesh, and a part of it", {"scene.prm": ONE_BODY % "  set Mesh = m.msh" + ONE_BODY.replace("Body block", "Body other").replace("condition floor", "condition other")
                                      % "  set Mesh = m.msh\n  set Part = all", "m.msh": MSH2},
         r"^scene\.prm:10: Body other: the same mesh file in the same place as body 'block'; allowed: for each body a 'Part' of the file")
    case("the same mesh twice", {"scene.prm": ONE_BODY % "  set Mesh = m.msh" + ONE_BODY.replace("Body block", "Body other").replace("condition floor", "condition other") % "  set Mesh = m.msh", "m.msh": MSH2},
         r"^scene\.prm:10: Body other: the same mesh file in the same place as body 'block'")
    case("missing mesh", ONE_BODY % "  set Mesh = m.msh", r"^scene\.prm:2: .*no file '.*m\.msh'", ranks=3)
    case("mesh of an unknown kind", ONE_BODY % "  set Mesh = m.stl", r"^scene\.prm:2: .*m\.stl.*\.msh, \.geo or \.inp")
    for version, text in ("2.2", MSH2), ("4.1", MSH4):
        lines = text.split("\n")
        for fraction in 0.1, 0.3, 0.5, 0.7, 0.9, 1:
            n = int(fraction * (len(lines) - 2))
            mesh(f"truncated .msh {version} at line {n}", "m.msh", "\n".join(lines[:n]), r"m\.msh:\d+: ", ranks=2 if fraction == 0.5 else 1)
    mesh("empty .msh", "m.msh", "", r"m\.msh")
    mesh("too many nodes announced", "m.msh", MSH2.replace("$Nodes\n6", "$Nodes\n7"), r"m\.msh:\d+: ")
    mesh("too few nodes announced", "m.msh", MSH2.replace("$Nodes\n6", "$Nodes\n5"), r"m\.msh:\d+: .*\$EndNodes.*counts")
    mesh("negative count", "m.msh", MSH2.replace("$Elements\n4", "$Elements\n-4"), r"m\.msh:\d+: ")
    mesh("huge count", "m.msh", MSH2.replace("$Elements\n4", "$Elements\n99999999999999"), r"m\.msh:\d+: ")
    mesh("huge block of nodes", "m.msh", MSH4.replace("2 1 0 4", "2 1 0 99999999999999"), r"m\.msh:\d+: ")
    mesh("too few elements announced", "m.msh", MSH4.replace("2 1 3 1\n", "2 1 3 0\n"), r"m\.msh:\d+: ")
    for n in ("-1", "-6", "2"):
        mesh(f"{n} groups of a curve", "m.msh", MSH4.replace("1 0 0 0 1 0 0 1 1 0", f"1 0 0 0 1 0 0 {n} 1"), rf"m\.msh:10: .*{n} physical groups", ranks=2 if n == "-6" else 1)
    mesh("unknown node", "m.msh", MSH2.replace("3 3 2 2 1 1 2 3 4", "3 3 2 2 1 1 2 3 44"), r"m\.msh:\d+: .*no node 44", ranks=3)
    mesh("unknown node in 4.1", "m.msh", MSH4.replace("2 1 2 3 4\n", "2 1 2 3 44\n"), r"m\.msh:\d+: .*no node 44")
    mesh("node twice", "m.msh", MSH2.replace("2 1 0 0\n", "1 1 0 0\n"), r"m\.msh:\d+: .*twice")
    mesh("coordinate that is no number", "m.msh", MSH2.replace("3 1 1 0", "3 1 nan 0"), r"m\.msh:\d+: .*finite number")
    mesh("text in the mesh", "m.msh", MSH2.replace("3 1 1 0", "3 1 one 0"), r"m\.msh:\d+: .*found 'one'")
    mesh("version of gmsh's format", "m.msh", MSH2.replace("2.2 0 8", "3.0 0 8"), r"m\.msh:2: .*2\.2 and 4\.1")
    mesh("no gmsh mesh", "m.msh", "hello\n", r"m\.msh:1: .*no gmsh mesh")
    mesh("folded cell", "m.msh", MSH2.replace("3 3 2 2 1 1 2 3 4", "3 3 2 2 1 1 3 2 4"), r"m\.msh:\d+: .*folded")
    mesh("mesh out of the plane", "m.msh", MSH2.replace("3 1 1 0", "3 1 1 1"), "different z")
    mesh("no boundary names", "m.msh", MSH2.replace('1 1 "bottom"', '1 9 "bottom"'), "no boundary 'bottom'")
    mesh("triangles", "m.msh", MSH2.replace("3 3 2 2 1 1 2 3 4", "3 2 2 2 1 1 2 3"), r"m\.msh:\d+: .*1 triangles.*quadrilaterals.*Recombine", ranks=2)
    tetrahedra = MSH2.replace("3 3 2 2 1 1 2 3 4", "3 4 2 2 1 1 2 3 4")
    mesh("tetrahedra in the plane", "m.msh", tetrahedra, r"m\.msh:\d+: .*three-dimensional")
    case("tetrahedra", {"scene.prm": "set Kind = 3D\n" + (ONE_BODY % "  set Mesh = m.msh").replace("0; 0", "0; 0; 0"), "m.msh": tetrahedra},
         "tetrahedra.*hexahedra")
    mesh("broken .inp", "m.inp", INP.replace("1, 1, 2, 3, 4", "1, 1, 2, 3"), r"m\.inp:\d+: .*nodes")
    mesh(".inp with an unknown node", "m.inp", INP.replace("1, 1, 2, 3, 4", "1, 1, 2, 3, 5"), r"m\.inp:\d+: .*no node 5")
    mesh(".inp with an unknown element", "m.inp", INP.replace("CPE4", "XYZ4"), r"m\.inp:\d+: .*XYZ4")
    mesh(".inp with triangles", "m.inp", INP.replace("CPE4", "CPE3").replace("1, 1, 2, 3, 4", "1, 1, 2, 3"), r"m\.inp:\d+: .*triangles.*Recombine")
    mesh(".inp without nodes", "m.inp", "hello\n", r"m\.inp.*no nodes")
    mesh(".inp with an unknown node in a set", "m.inp", INP + "77\n", r"m\.inp.*no node 77")
    mesh("binary .inp", "m.inp", bytes(range(256)) * 20, r"m\.inp")
    geo = "Point(1) = {0,0,0}; Point(2) = {1,0,0}; Point(3) = {1,1,0}; Point(4) = {0,1,0};\nLine(1) = {1,2}; Line(2) = {2,3}; Line(3) = {3,4}; Line(4) = {4,1};\n" \
          "Curve Loop(1) = {1,2,3,4}; Plane Surface(1) = {1};\nPhysical Curve(\"bottom\") = {1}; Physical Surface(\"all\") = {1};\n"
    mesh("mesh .geo", "m.geo", geo + "Transfinite Surface{1}; Recombine Surface{1};\n", None)
    mesh(".geo that makes triangles", "m.geo", geo, r"m\.geo.*triangles.*Recombine")
    mesh(".geo that fails", "m.geo", geo.replace("Plane Surface(1) = {1};", "Plane Surface(1) = {7"), r"gmsh made no mesh of .*m\.geo", ranks=2)
    mesh("empty .geo", "m.geo", "", r"m\.geo")
    case("curved boundary of no name", {"scene.prm": ONE_BODY % "  set Mesh = m.msh\n  set Curved boundaries = side = circle(0, 0)", "m.msh": MSH2}, "boundary 'side'")
    solid = "set Kind = 3D\n" + (ONE_BODY % "%s").replace("0; 0", "0; 0; 0")
    curved = solid % "  set Mesh = m.msh\n  set Curved boundaries = bottom = %s"
    for name, shape, words in [("missing CAD file", "cad(a.step)", r"no file '.*a\.step'.*STEP or IGES"), ("CAD file of an unknown kind", "cad(m.msh)", r"\.step, \.stp"),
                               ("CAD scale", "cad(a.step, -1)", "SCALE > 0"), ("CAD scale that is no number", "cad(a.step, mm)", "SCALE > 0")]:
        case(name, {"scene.prm": curved % shape, "m.msh": MSH2}, r"^scene\.prm:4: .*" + words)
    case("CAD in 2D", {"scene.prm": ONE_BODY % "  set Mesh = m.msh\n  set Curved boundaries = bottom = cad(a.step)", "m.msh": MSH2}, r"^scene\.prm:3: .*in 3D")
    parameters = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "parameters")
    with open(os.path.join(parameters, "step_file.msh")) as stream:
        dome = stream.read()
    with open(os.path.join(parameters, "step_file.step")) as stream:
        step = stream.read()
    on_top = (curved % "%s").replace("bottom = ", "top = ", 1)
    with open(os.path.join(parameters, "verification", "patch_3d_step.msh")) as stream:
        stairs = stream.read()
    case("hexahedron folded in space", {"scene.prm": solid % "  set Mesh = m.msh", "m.msh": stairs.replace("\n154 2.4 2 -2\n", "\n154 2.4 2 1e-308\n")}, r"m\.msh:\d+: .*folded", ranks=2)
    case("CAD file that is none", {"scene.prm": on_top % "cad(a.step)", "m.msh": dome, "a.step": "hello\n"}, r"^scene\.prm:2: .*cannot read '.*a\.step'.*STEP or IGES", ranks=2)
    case("empty IGES file", {"scene.prm": on_top % "cad(a.igs)", "m.msh": dome, "a.igs": ""}, r"^scene\.prm:2: .*cannot read '.*a\.igs'.*IGES")
    case("CAD model elsewhere", {"scene.prm": on_top % "cad(a.step, 1.1)", "m.msh": dome, "a.step": step}, r"^scene\.prm:2: .*'top'.*lies on no single face.*1e-3", ranks=2)
    case("truncated CAD file", {"scene.prm": on_top % "cad(a.step)", "m.msh": dome, "a.step": step[:len(step) // 2]}, r"^scene\.prm:2: .*a\.step")
    case("CAD file with a weight too few", {"scene.prm": on_top % "cad(a.step)", "m.msh": dome, "a.step": step.replace(",(1.,0.70", ",(set 1.,0.70", 1)},
         r"^scene\.prm:2: .*cannot read '.*a\.step'.*not damaged", ranks=2)
    case("CAD file that breaks OpenCASCADE", {"scene.prm": on_top % "cad(a.step)", "m.msh": dome, "a.step": step[:2147] + step[2186:]}, r"^scene\.prm:2: .*a\.step'.*breaks down .signal 11.*not damaged", ranks=2)
    case("disk in 3D", solid % "  set Mesh = half disk", r"^scene\.prm:3: .*found 'half disk', a shape of scenes in 2D; .*half sphere.*cylinder")
    case("sphere in 2D", ONE_BODY % "  set Mesh = sphere", r"^scene\.prm:2: .*found 'sphere', a shape of scenes in 3D; .*half disk.*ring")
    case("length of a sphere", solid % "  set Mesh = sphere\n  set Radius = 1\n  set Length = 2", r"^scene\.prm:5: .*no meaning.*sphere")
    case("zero length", solid % "  set Mesh = cylinder\n  set Radius = 1\n  set Length = 0", r"^scene\.prm:5: .*positive")
    case("thick hollow cylinder", solid % "  set Mesh = hollow cylinder\n  set Radius = 1\n  set Inner radius = 2", r"^scene\.prm:5: .*less than the outer radius")
    case("thin hollow sphere", solid % "  set Mesh = hollow sphere\n  set Radius = 1\n  set Inner radius = 0.999999", r"^scene\.prm:2: .*cells")
    case("curved boundary that is not round", {"scene.prm": ONE_BODY % "  set Mesh = m.msh\n  set Curved boundaries = bottom = square(0, 0)", "m.msh": MSH2},
         r"^scene\.prm:3: .*square")

    # command line
    case("--set of an unknown entry", BASE, r"^--set: .*Yung.*did you mean 'Young modulus'", arguments=["scene.prm", "--set", "Body upper/Yung modulus = 3"])
    case("--set of an unknown section", BASE, r"^--set: .*Body uper", arguments=["scene.prm", "--set", "Body uper/Young modulus = 3"])
    case("--set without =", BASE, r"^--set: .*Section/Name = value", arguments=["scene.prm", "--set", "Body upper/Young modulus"])
    case("--set of a wrong value", BASE, r"^--set: .*found 'x'", arguments=["scene.prm", "--set", "Body upper/Young modulus = x"])
    case("--set without value", BASE, "value is missing", arguments=["scene.prm", "--set"])
    case("unknown argument", BASE, "--ouput.*did you mean '--output'", arguments=["scene.prm", "--ouput", "x"])
    case("two scenes", BASE, "second file", arguments=["scene.prm", "scene.prm"])
    case("study without a file", {}, "no study file", arguments=["study"])
    case("study of a missing file", {}, "nothing.prm", arguments=["study", "nothing.prm"], ranks=2)
    map_of = "set Kind = stability\nset Scene = scene.prm\n%s\nsubsection Sweep\n  set 1 = Body upper/Poisson ratio: 0.2, 0.3\n  set 2 = Increments: 1, 2\nend\n"

    def study(name, text, words, **more):
        case(name, {"scene.prm": BASE, "study.prm": text}, words, arguments=["study", "study.prm", "--output", "made"], **more)

    study("kind of a study", "set Kind = stabilty\n", r"^study\.prm:1: Kind: found 'stabilty' \(did you mean 'stability'\?\); allowed: convergence, work precision, stability")
    study("entry of another kind of study", map_of % "set Per mesh = true", r"^study\.prm:3: Per mesh: it has no meaning in a study of the kind stability; allowed: .*Expected")
    study("time limit of a study", map_of % "set Time limit = 0", r"^study\.prm:3: Time limit: found '0'; allowed: a positive number")
    study("threshold of a map", map_of % "set Threshold = limit: 3*y", r"^study\.prm:3: Threshold: found '3\*y'; allowed: an expression of x giving y")
    study("expected value of a study", map_of % "set Expected = energy", r"^study\.prm:3: Expected: found 'energy'; allowed: PATH IN SUMMARY.JSON = EXPRESSION")
    study("expression of a study", map_of % "set Expected = energy = 3*t", r"^study\.prm:3: Expected: '3\*t' has the variable t")
    study("targets of a map", map_of % "set Targets = 0.1", r"^study\.prm:3: Targets: it has no meaning in a study of the kind stability")
    study("targets of a study", (map_of % "set Quantities = energy\nset Targets = 0.1, -1").replace("stability", "work precision"), r"^study\.prm:4: Targets: found '-1'")
    study("work precision without quantities", (map_of % "").replace("stability", "work precision"), r"^study\.prm: Quantities: no quantity is given")
    study("study on two ranks", map_of % "", r"^study\.prm:1: Kind: .*on several ranks; allowed: one rank; --jobs N", ranks=2)
    case("number of jobs", {"study.prm": map_of % ""}, r"^command line: --jobs: found '0'; allowed: a number of runs", arguments=["study", "study.prm", "--jobs", "0"])
    case("output is a file", {"scene.prm": BASE, "taken": "mine"}, "taken.*cannot be made", arguments=["scene.prm", "--output", "taken"], ranks=2, keep=["taken"])
    case("output below a file", {"scene.prm": BASE, "taken": "mine"}, "taken.*cannot be made", arguments=["scene.prm", "--output", "taken/a/b"], keep=["taken"])
    case("no arguments", {}, "usage", arguments=[])


def read(asked, folder, arguments, words):
    """What is wrong with the refusal of a scene or study; None where it is not refused while it is read."""
    asked.noise()
    code, said = asked.ask(f"folder {folder}", SECONDS)
    if code == 0:
        code, said = asked.ask(f"{'scene' if len(arguments) == 1 else 'study'} {arguments[-1]}", SECONDS)
    text = said.decode(errors="replace")
    if code != 1:
        return None
    errors = [f"{noise[:300]} beside the message"] if (noise := asked.noise()) else []
    if "\ufffd" in text or len(said) > 2000:
        errors.append(f"no valid UTF-8, or too much of it: {len(said)} bytes")
    if "\n" in text.strip():
        errors.append("more than one line")
    if not re.search(words, text):
        errors.append(f"the message has no '{words}'")
    return errors + ["message: " + text[:600]] if errors else []


def write(folder, files):
    for file, text in files.items():
        path = os.path.join(folder, file)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "wb") as stream:
            stream.write(text if isinstance(text, bytes) else text.encode())


def run(executable, folder, name, files, arguments, ranks, words, keep, leaves):
    before = sorted(os.listdir(folder))
    command = [executable] + [executable if a == "EXECUTABLE" else a for a in arguments]
    try:
        done = launch.run(command, ranks, cwd=folder, timeout=SECONDS, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    except subprocess.TimeoutExpired:
        return [f"not done after {SECONDS} s"]
    errors, text = [], done.stderr.decode(errors="replace")
    if "\ufffd" in text or len(done.stderr) > 2000:
        errors.append(f"no valid UTF-8, or too much of it: {len(done.stderr)} bytes")
    out = done.stdout.decode(errors="replace")
    if words is None:
        if done.returncode != 0:
            errors.append(f"exit code {done.returncode}")
        if text:
            errors.append("stderr is not empty")
        if "outside" in name and "note" not in out.lower() and "outside" not in out:
            errors.append("no note")
    else:
        # what mpirun adds stands between lines of dashes, or names MPI processes
        lines = [line for line in re.sub(r"(?ms)^-{60,}\n.*?^-{60,}\n", "", text).split("\n") if line and not re.match(r"^\[.*\]|.*mpirun", line)]
        if done.returncode != 1:
            errors.append(f"exit code {done.returncode}")
        if len(lines) != 1 and words != "usage":
            errors.append(f"{len(lines)} lines on stderr")
        if not any(re.search(words, line) for line in lines):
            errors.append(f"the message has no '{words}'")
        if re.search(r"Stacktrace|terminate called|Segmentation|core dumped|internal error", text):
            errors.append("a crash")
        if set(os.listdir(folder)) - set(before) != set(leaves) or set(before) - set(os.listdir(folder)):
            errors.append(f"left: {sorted(set(os.listdir(folder)) ^ set(before))}")
        for file in keep:
            with open(os.path.join(folder, file)) as stream:
                if stream.read() != files[file]:
                    errors.append(f"{file} is changed")
    if errors:
        errors.append("stderr: " + text.strip()[:600])
        if words is None:
            errors.append("stdout: " + out.strip()[-300:])
    elif os.environ.get("SHOW"):
        print(f"      {text.strip()[:400]}")
    return errors


def main():
    executable, reader, parts = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2]), sys.argv[3:]
    scenes()
    failed = n = n_read = 0
    with tempfile.TemporaryDirectory(prefix="amontons-wrong-") as top, concurrent.futures.ThreadPoolExecutor(2) as pool:
        running = []
        asked = readers.Readers(reader, top, MEMORY)
        for i, (name, files, arguments, ranks, words, keep, leaves) in enumerate(CASES):
            if parts and not any(part in name for part in parts):
                continue
            folder = os.path.join(top, str(i))
            os.makedirs(folder)
            write(folder, files)
            if ranks == 1 and words is not None and not leaves and arguments in (["scene.prm"], ["study", "study.prm"]):
                before = sorted(os.listdir(folder))
                if (errors := read(asked, folder, arguments, words)) is not None:
                    if sorted(os.listdir(folder)) != before:
                        errors.append(f"left: {sorted(os.listdir(folder))}")
                    running.append((name, pool.submit(list, errors)))
                    n_read += 1
                    continue
            running.append((name, pool.submit(run, executable, folder, name, files, arguments, ranks, words, keep, leaves)))
        asked.stop()
        for name, case in running:
            errors = case.result()
            n += 1
            failed += bool(errors)
            if errors:
                print(f"FAILED {name}" + "".join("\n       " + e for e in errors), flush=True)
            elif os.environ.get("SHOW"):
                print(f"ok     {name}", flush=True)
    print(f"{n - failed} of {n} cases hold, {n_read} of them refused while they are read")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
