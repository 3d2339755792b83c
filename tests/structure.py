#!/usr/bin/env python3
"""How the source is built: structure.py [SOURCE_DIR] [--check]

Prints the largest file, long functions, classes with many data members, conditions on modes at the top, the way from run() to one linear solve, the share of
comments in headers, and lines in all. doc/program.md (What is counted) says what was planned, and why some of it stays.
--check: exits 1 where a bound below is broken. They are what was reached and only fall; a bound that a change needs is a class or a file that does two things.
"""
import argparse
import pathlib
import re
import sys

BOUNDS = {"largest file": 500, "functions over 80 code lines": 1, "functions over 40 code lines": 38, "data members of the largest class": 22}
MODES = re.compile(r"\b(finite_strain|has_history|is_incremental|follow_motion|automatic|until_measured|measured)\b")

# Each calls the next one.
WAY = [
    "ContactProblem::run", "ContactProblem::run_load_program", "LoadStepping::run", "LoadStepping::run_load_program", "LoadStepping::solve_increment",
    "LoadStepping::solve_on_mesh", "LoadPath::iterate", "LoadPath::solve", "ContactSolver::solve", "run_method", "Newton::iterate", "Newton::turn", "Newton::solve",
    "EliminatedStep::solve", "LinearSolver::solve",
]


def code_of(text):
    """Without comments, literals and preprocessor lines; lines stay where they are."""
    def blank(match):
        return "\n" * match.group(0).count("\n") if match.group(0)[0] in "/#" else '""'
    return re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|^[ \t]*#(?:[^\n\\]|\\\n|\\.)*', blank, text, flags=re.S | re.M)


def blocks(code):
    """(kind, head, first line, last line, body) of all braces: "space", "class", "function" (outermost only) or "other"."""
    stack, head, result = [], 0, []
    for match in re.finditer(r"[{};]", code):
        at, character = match.start(), match.group(0)
        if character == "{":
            text = code[head:at].strip()
            text = re.sub(r"^(?:\s*(?:public|private|protected)\s*:)+", "", text).strip()
            inside = [kind for kind, *_ in stack]
            if any(kind in ("function", "other") for kind in inside):
                kind = "other"
            elif re.match(r"(inline\s+)?namespace\b", text):
                kind = "space"
            elif re.search(r"\benum\b", text):
                kind = "other"
            elif re.match(r"(template\s*<.*>\s*)?(class|struct|union)\b[^()=]*$", text, re.S):
                kind = "class"
            elif "(" in text and not re.search(r"=\s*$", text):
                kind = "function"
            else:
                kind = "other"
            stack.append((kind, text, at))
        elif character == "}" and stack:
            kind, text, begin = stack.pop()
            result.append((kind, text, code.count("\n", 0, begin) + 1, code.count("\n", 0, at) + 1, code[begin + 1:at]))
        head = match.end()
    return result


def code_lines(body):
    return sum(1 for line in body.split("\n") if line.strip())


def members(body):
    """Data members of a class: its statements that are no functions, types or friends."""
    flat, depth = [], 0
    for character in body:
        depth -= character == "}"
        if depth == 0:
            flat.append(character if character != "}" else "}")
        depth += character == "{"
    count = 0
    for statement in re.split(r"[;]|\{\}", "".join(flat)):
        text = re.sub(r"\b(public|private|protected)\s*:", "", statement).strip()
        text = re.sub(r"[={].*$", "", text, flags=re.S) if not re.search(r"\boperator\b", text) else "("
        while re.search(r"<[^<>]*>", text):
            text = re.sub(r"<[^<>]*>", "", text)
        if not text or "(" in text or re.match(r"(using|friend|template|typedef|static|enum|struct|class)\b", text):
            continue
        if re.match(r"[\w:&*\s,\[\]]+$", text) and len(text.split()) > 1:
            count += 1 + text.count(",")
    return count


def name_of(head):
    found = re.search(r"([~\w]+(?:<\w+>)?(?:::[~\w]+)*)\s*\(", head) if "(" in head else re.search(r"(?:class|struct|union)\s+(\w+)", head)
    return found.group(1) if found else head[:40]


def check_way(bodies):
    """bodies: of functions, by their names without template arguments."""
    for caller, callee in zip(WAY, WAY[1:]):
        if not re.search(rf"\b{callee.split('::')[-1]}\(", bodies.get(caller, "")):
            sys.exit(f"{caller} does not call {callee}: WAY and doc/program.md (What is counted) are out of date")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("source", nargs="?", default=pathlib.Path(__file__).resolve().parent.parent, type=pathlib.Path)
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    files, functions, classes = [], [], []
    modes = header_lines = comment_lines = 0
    bodies = {}
    for top in ("include", "source"):
        for path in sorted((arguments.source / top).rglob("*")):
            if path.suffix not in (".h", ".cc"):
                continue
            text = path.read_text()
            where = path.relative_to(arguments.source)
            files.append((text.count("\n"), str(where)))
            if path.suffix == ".h":
                lines = [line.strip() for line in text.split("\n") if line.strip()]
                header_lines += len(lines)
                comment_lines += sum("//" in line for line in lines)
            code = code_of(text)
            for kind, head, first, _, body in blocks(code):
                if kind == "function":
                    bodies[re.sub(r"<\w+>", "", name_of(head))] = body
                    functions.append((code_lines(body), f"{where}:{first} {name_of(head)}"))
                elif kind == "class":
                    classes.append((members(body), f"{where}:{first} {name_of(head)}"))
            if path.parent == arguments.source / "source" and path.name != "main.cc":
                modes += sum(bool(MODES.search(line)) for line in re.findall(r"\b(?:if|while|for)\s*\([^;{]*|[^\n]*\?[^\n]*|return [^;]*&&[^;]*", code))
    for table in (files, functions, classes):
        table.sort(reverse=True)
    problem = next((n for n, where in classes if where.endswith(" ContactProblem")), 0)
    now = {
        "largest file": files[0][0],
        "functions over 80 code lines": sum(n > 80 for n, _ in functions),
        "functions over 40 code lines": sum(n > 40 for n, _ in functions),
        "data members of the largest class": classes[0][0],
    }
    print(f"files {len(files)}, lines {sum(n for n, _ in files)}, functions {len(functions)}")
    for name, value in now.items():
        print(f"{name}: {value} (at most {BOUNDS[name]})")
    print(f"data members of ContactProblem: {problem}")
    print(f"conditions on modes at the top: {modes}")
    check_way(bodies)
    print(f"calls from run() to one linear solve: {len(WAY) - 1}")
    print(f"share of lines with comments in headers: {100 * comment_lines / header_lines:.0f} %")
    for title, table, n in (("files", files, 8), ("functions", functions, 8), ("classes", classes, 8)):
        print(f"largest {title}: " + ", ".join(f"{where} {size}" for size, where in table[:n]))
    broken = [name for name, value in now.items() if value > BOUNDS[name]]
    if arguments.check and broken:
        sys.exit("above its bound: " + ", ".join(broken))


if __name__ == "__main__":
    main()
