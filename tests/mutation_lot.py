"""Changes of the source that are drawn by lot (mutation.py --lot), and the nets of tests that are thrown after them.

A change is one of: + for -, * for /, < for <=, > for >=, == for !=, && for ||, min for max, true for false (and the other way round), a removed !, 1.0 for
0.5, and a statement left out (a call or a compound assignment on a line of its own). All places of source/ and include/ are drawn alike, but for comments,
texts, preprocessor lines, and statements that declare parameters, assert or throw. The same seed on the same source draws the same.
"""
import collections
import os
import random
import re

Place = collections.namedtuple("Place", "file line begin end old new")  # file relative to the tree, text[begin:end] == old

SWAPPED = {"+": "-", "*": "/", "<": "<=", ">": ">=", "==": "!=", "&&": "||", "min": "max", "true": "false"}
SWAPPED.update({new: old for old, new in SWAPPED.items()})
SWAPPED.update({"!": "", "0.5": "1.0"})
# .clang-format puts blanks about binary operators, and none inside of < > of templates, before & and * of declarations, and after !
OPERATORS = re.compile(r"""(?<=[\w)\]}"']) (?P<binary>[-+*/]|[<>]=?|[=!]=|&&|\|\|)(?=\s)|(?<![\w!])(?P<negation>!)(?=[\w(])"""
                       r"""|\b(?:std|MPI)::(?P<extreme>min|max)\(|\b(?P<truth>true|false)\b|(?<![\w.])(?P<half>0\.5)(?!\w)""")
STATEMENT = re.compile(r"(?P<statement>(?!return\b|throw\b|delete\b|using\b|case\b)[\w.:>\[\]()*-]*(?:(?<=\w)\(.*\)|(?:\[[^=]*\])? +[-+*/|&]=.*|\+\+|--);)$")
NO_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|R"\(.*?\)"|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])\'|^[ \t]*#(?:[^\n\\]|\\\n|\\.)*', re.S | re.M)
PASSED_OVER = re.compile(r"\b(throw|Assert\w*|assert|static_assert|InputError|add_parameter|declare_entry|template)\b")


def code_of(text):
    """As long as the text: comments and preprocessor lines are blank, texts are lines."""
    def hide(match):
        filling = "_" if match.group(0)[0] in "R\"'" else " "
        inside = re.sub(r"[^\n]", filling, match.group(0))
        return inside if filling == " " else '"' + inside[1:-1] + '"'
    return NO_CODE.sub(hide, text)


def statement_about(code, begin, end):
    first = max(code.rfind(mark, 0, begin) for mark in ";{}") + 1
    after = [at for at in (code.find(mark, end) for mark in ";{}") if at >= 0]
    return code[first:min(after)] if after else code[first:]


def operators(code):
    for match in OPERATORS.finditer(code):
        old = match.group(match.lastgroup)
        yield match.start(match.lastgroup), match.end(match.lastgroup), old, SWAPPED[old]


def statements(code):
    """Those on a line of their own that begin after the end of another, or after the head of a loop or branch."""
    at, before = 0, ";"
    for line in code.split("\n"):
        match = STATEMENT.match(line.strip())
        whole = line.count("(") == line.count(")") and line.count("{") == line.count("}")
        if match and whole and (before[-1] in ";{}:" or re.match(r"(\}\s*)?(else|(if|for|while)\b.*\))$", before)):
            begin = at + len(line) - len(line.lstrip())
            yield begin, at + len(line.rstrip()), match.group("statement"), ";"
        at += len(line) + 1
        before = line.strip() or before


def places(tree):
    """All, in the order of files and of text."""
    result = []
    for top in "include", "source":
        for folder, _, names in os.walk(os.path.join(tree, top)):
            for path in (os.path.join(folder, name) for name in names if name.endswith((".h", ".cc"))):
                with open(path) as stream:
                    text = stream.read()
                code = code_of(text)
                for begin, end, _, new in [*operators(code), *statements(code)]:
                    if not PASSED_OVER.search(statement_about(code, begin, end)):
                        result.append(Place(os.path.relpath(path, tree), text.count("\n", 0, begin) + 1, begin, end, text[begin:end], new))
    return sorted(result)


def drawn(tree, seed):
    """All places, in the order in which the seed draws them."""
    result = places(tree)
    random.Random(seed).shuffle(result)
    return result


def told(place, text):
    """The line before and after the change."""
    first, last = text.rfind("\n", 0, place.begin) + 1, text.find("\n", place.end)
    line = text[first:last]
    new = text[first:place.begin] + place.new + text[place.end:last]
    return f"{place.file}:{place.line}  {line.strip()}  ->  {new.strip()}"


def folder_of(file):
    """"contact", ...; "" at the top."""
    return os.path.dirname(re.sub(r"^(source|include/amontons)/", "", file))


PLANE = "patch_q2_first_10_to_1|patch_q1_second_hanging_nodes|patch_q2_first_punch|two_punches_q1|tied_patch|disk_platen|half_plane_box|hertz_sphere"
FRICTION = "patch_friction_q1_first_slips|microslip_bar_.*|cattaneo_mindlin_75|floating_slab_mu_0.2|floating_slab_3d_mu_0.2|transfer_microslip_bar|iterations_.*|greco_mu_.*"
FINITE = "patch_finite_.*|objectivity_.*|simple_shear_.*|uniaxial_.*|oblique_touch|slide_.*_first|turned_obstacle|wall_buckling|snap_away"
BLOCKS = "patch_3d_.*|sphere_2a|crossed_cylinders|cross_point_.*|split_slave_.*|tee_.*"
QUICK = "patch_q1_second_hanging_nodes|tied_patch|microslip_bar_q1|patch_3d_q1_first_punch|patch_finite_q2_second_turned_sticking|cylinders_1b"  # some 5 s
# Scenes that stand on a folder; the folders that are not here: all of them
SCENES = {
    "geometry": f"{PLANE}|{BLOCKS}|step_file|facets_.*|second_order_mesh|declared_circle|rings_.*|shrink_.*",
    "discretization": f"{PLANE}|disk_.*|turned_.*|lifted|piston|punch_moment|tied_beam|{FRICTION}",
    "elasticity": f"{PLANE}|{FINITE}|press_finite_.*|nearly_incompressible_.*|capstan_pressure|patch_q2_plane_stress",
    "contact": f"{PLANE}|{BLOCKS}|{FINITE}|declared_gap_.*|growing_interference_.*|patch_penalty|patch_node.*|cap_in_seat_.*",
    "friction": f"{FRICTION}|law_ends|floating_slab_.*|capstan_.*",
    "algebra": f"{PLANE}|{BLOCKS}|{FRICTION}|ranks_.*",
    "solver": f"{FRICTION}|{FINITE}|floating_slab_.*|increments_.*|large_increment|untouched_.*|penalty_.*",
    "adaptivity": f"{PLANE}|target_error|auto_.*|transfer_.*|small_strain_.*|patch_3d_.*hanging_nodes.*",
    "output": f"{PLANE}|{FRICTION}|bulk_tension|tied_beam|coarse_contact_warning",
    "verification": f"{PLANE}|.*cylinders.*|half_.*|cone_3c|flat_punch.*|shrink_.*|uniaxial_.*|roller_1d|rings_.*|capstan_.*|microslip.*|mindlin.*|cattaneo.*",
}
BLIND_TO = ("output", "scene", "verification")  # golden.py compares forces of scenes that are right: unit tests first


def nets(folder):
    """[(name, regular expression of tests)]: tests that an earlier net has thrown are not thrown again."""
    quick, whole, units = ("quick", f"^scenes/({QUICK})$"), ("golden", "^golden$"), ("units", f"^{folder}/" if folder else "^$")
    first = [units, quick, whole] if folder in BLIND_TO else [quick, whole, units]
    return first + [("scenes", f"^scenes/({SCENES.get(folder, PLANE + '|' + FRICTION + '|' + FINITE)})$"), ("kinds", "^(kinds|atlas)$"),
                    ("rest", "^(?!layers$|format$|structure$|quotes$|build_unit_tests$)")]


def tests_of_nets(all_tests, folder):
    """[(name, tests)] from all tests (name, ...)."""
    thrown, result = set(), []
    for name, pattern in nets(folder):
        caught = [test for test in all_tests if re.search(pattern, test[0]) and test[0] not in thrown]
        thrown.update(test[0] for test in caught)
        result.append((name, caught))
    return result
