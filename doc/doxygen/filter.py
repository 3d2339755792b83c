#!/usr/bin/env python3
"""What doxygen reads instead of the files of SOURCE_DIR, into FOLDER: filter.py SOURCE_DIR FOLDER HTML_FOLDER

Headers: the first comment becomes that of the file, and of the class that the file is named after if that has none; a comment before a declaration at file
or class level, or behind one, becomes one of doxygen's. Sources: the first comment alone; all of them can be read on the page of the file. Pages: formulas,
anchors, links and pictures as GitHub reads them. What doxygen would take for commands, tags and links is escaped. Lines stay where they are. Files that pages link, but that are none, go to HTML_FOLDER as they are.
"""
import pathlib
import re
import shutil
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests"))
from check_links import anchor  # noqa: E402

CODE_SPAN = r"(?<!`)(`+)(?!`)(?:(?!\n\n).)+?(?<!`)\1(?!`)"
FORMULA = r"\$\$.+?\$\$|\$[^$\n]+\$"


def escape(text):
    """Characters that are commands, tags or links to doxygen, but not to the reader."""
    return re.sub(r"[\\@<>&#%]", lambda match: "\\" + match.group(0), text)


def formula(text):
    if text.startswith("$$"):
        return "\\f[" + text[2:-2] + "\\f]"
    return "\\f$" + text[1:-1] + "\\f$"


def code(text):
    inside = re.match(r"(`+)(.*)\1$", text, re.S).group(2)
    inside = re.sub(r"[\\@<>&#%$|]", lambda match: "\\" + match.group(0), inside)
    inside = inside.replace("\\>::", "\\>\\::").replace("--", "\\--")  # no request for a link, no dash
    return f"<code>{inside}</code>"


# ---- Pages

LINKED = set()


def name_of(page):
    return "index" if page.stem == "README" else "page_" + page.stem.lower()


def link(page, text, target):
    name, _, wanted = target.partition("#")
    if re.match(r"[a-z]+:", target):
        return f"[{text}]({target})"
    other = page if not name else (page.parent / name).resolve()
    if other.suffix != ".md":
        LINKED.add(other)
        return f'<a href="{other.name}.txt">{text}</a>'
    return f"[{text}](@ref {name_of(other)}{'-' + wanted if wanted else ''})"


def page_text(page, text):
    if page.stem == "README":
        text = re.sub(r"^# .*", lambda m: m.group(0) + " {#mainpage}", text, count=1)
    else:
        text = re.sub(r"^# .*", lambda m: f"{m.group(0)} {{#{name_of(page)}}}", text, count=1)
    kept = []

    def keep(piece):
        kept.append(piece)
        return f"\x01{len(kept) - 1}\x02"

    text = re.sub(r"^<!--.*?-->", lambda m: keep(""), text, flags=re.M)
    text = re.sub(r"^```(\w*)\n(.*?)^```", lambda m: keep("```" + ("{.cpp}" if m.group(1) == "cpp" else "") + "\n" + m.group(2) + "```"), text, flags=re.S | re.M)
    text = re.sub(r"(?:(?<=\n\n)|(?<=\x02\n))(?: {4,}.*\n)+", lambda m: keep(m.group(0)), text)
    text = re.sub(CODE_SPAN, lambda m: keep(code(m.group(0))), text, flags=re.S)
    text = re.sub(FORMULA, lambda m: keep(formula(m.group(0))), text, flags=re.S)

    def heading(match):
        shown = re.sub("\x01(\\d+)\x02", lambda m: plain(kept[int(m.group(1))]), match.group(2))
        bare = re.sub("\x01(\\d+)\x02", lambda m: plain(kept[int(m.group(1))]) if kept[int(m.group(1))].startswith("<code>") else m.group(0), match.group(2))
        return f"{match.group(1)}{bare} {{#{name_of(page)}-{anchor(shown)}}}"  # doxygen shows tags in headings as they are

    text = re.sub(r"^(#{2,6}\s+)(.*)$", heading, text, flags=re.M)
    text = re.sub(r"!\[([^\]]*)\]\(([^)]*)\)", lambda m: keep(f'<img src="{pathlib.Path(m.group(2)).name}" alt="{m.group(1)}">'), text)
    text = re.sub(r"\[([^\]]*)\]\(([^)\s]*)\)", lambda m: keep(link(page, m.group(1), m.group(2))), text)
    text = re.sub(r"\{#[^}]*\}$", lambda m: keep(m.group(0)), text, flags=re.M)
    text = re.sub(r"[\\@<>&%]|(?<!^)(?<!#)#(?! |#)", lambda m: "\\" + m.group(0), text)
    text = re.sub(r"\bAmontons\b", "%Amontons", text)  # the program, not the namespace
    return restore(text, kept)


def plain(piece):
    return re.sub(r"</?code>|\\", "", piece)


def restore(text, kept):
    while "\x01" in text:
        text = re.sub("\x01(\\d+)\x02", lambda m: kept[int(m.group(1))], text)
    return text


# ---- Headers

def comment_text(text):
    """The text of one comment line, escaped outside of code and formulas."""
    pieces, at = [], 0
    for match in re.finditer(CODE_SPAN + "|" + FORMULA, text):
        pieces += [escape(text[at:match.start()]), formula(match.group(0)) if match.group(0)[0] == "$" else code(match.group(0))]
        at = match.end()
    return "".join(pieces + [escape(text[at:])])


COMMENT = re.compile(r"^(\s*)//[/!]?(?!/)(.*)$")
TRAILING = re.compile(r"^(\s*\S.*?[;,}])(\s*)//(?!/)(.*)$")


def without_literals(line):
    return re.sub(r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])\'', lambda m: '""' + " " * (len(m.group(0)) - 2), line)


class Scopes:
    """Which braces are open: of a namespace or class ("scope"), of an enum, of a body."""

    def __init__(self):
        self.open, self.head, self.round = [], "", 0

    def read(self, line):
        for character in re.sub(r"/\*\*.*?\*/|//.*", "", without_literals(line)):
            if character == "{":
                if self.round:
                    kind = "body"
                elif re.search(r"\benum\b", self.head):
                    kind = "enum"
                elif re.search(r"\b(namespace|class|struct|union)\b", self.head) and not re.search(r"[()=]", re.sub(r"<.*>", "", self.head)):
                    kind = "scope"
                else:
                    kind = "body"
                self.open.append(kind)
                self.head = ""
            elif character == "}":
                if self.open:
                    self.open.pop()
                self.head = ""
            elif character in ";":
                self.head = ""
            else:
                self.round += {"(": 1, ")": -1}.get(character, 0)
                self.head += character
        self.head += " "

    def documented(self):
        return "body" not in self.open and not self.round

    def between(self):
        """Between declarations."""
        return self.documented() and not re.sub(r"\b(public|private|protected)\s*:|#\s*\w+.*", "", self.head).strip()


def is_main_class(file, lines, at):
    """Whether the class that the header is named after, and that has no comment of its own, begins here."""
    text = re.sub(r"^\s*template\s*<[^<>]*>", "", "\n".join(lines[at:at + 4]))
    match = re.match(r"\s*(?:class|struct)\s+(\w+)(?![^{;]*;)", text)
    return bool(match) and match.group(1).lower() == file.stem.replace("_", "")


def header(file, lines):
    result, scopes, first, at, of_file = [], Scopes(), True, 0, ""
    while at < len(lines):
        match = COMMENT.match(lines[at])
        if match:
            end = at
            while end < len(lines) and COMMENT.match(lines[end]):
                end += 1
            block = [COMMENT.match(line) for line in lines[at:end]]
            marks = [m.group(2).strip().startswith("[") and m.group(2).strip().endswith("]") for m in block]
            following = lines[end].strip() if end < len(lines) else ""
            is_file = first and at < 2
            enum = bool(scopes.open) and scopes.open[-1] == "enum"
            before_declaration = following and not following.startswith("}") and not re.match(r"(public|private|protected)\s*:|#", following)
            if is_file:
                result.append(f"/// @file {file.name} {comment_text(block[0].group(2).strip())}")
                result += [f"///{comment_text(m.group(2))}" for m in block[1:]]
                of_file = " ".join(comment_text(m.group(2).strip()) for m in block).replace("*/", "* /")
            elif before_declaration and not any(marks) and (scopes.between() or enum):
                result += [f"{m.group(1)}///{comment_text(m.group(2))}" for m in block]
            else:
                result += ["" for m in block]
            first, at = False, end
            continue
        if of_file and scopes.between() and is_main_class(file, lines, at) and not lines[at - 1].strip().startswith(("//", "template")):
            lines[at] = f"/** {of_file} */ {lines[at].lstrip()}"
        line, at = lines[at], at + 1
        first = first and not line.strip()
        before = scopes.documented()
        scopes.read(line)
        blanked = without_literals(line)
        trailing = TRAILING.match(blanked) if before and scopes.documented() else None
        ends = trailing and (trailing.group(1).endswith(";") or scopes.open[-1:] == ["enum"])
        if not ends:
            result.append(line)
            continue
        column = trailing.end(2)
        result.append(f"{line[:column]}///<{comment_text(line[column + 2:])}")
        while at < len(lines) and COMMENT.match(lines[at]) and len(COMMENT.match(lines[at]).group(1)) == column:
            result.append(f"{' ' * column}///<{comment_text(COMMENT.match(lines[at]).group(2))}")
            at += 1
    return result


def source(file, lines):
    """One comment, in as many lines."""
    first = [comment_text(match.group(2)) for match in map(COMMENT.match, lines) if match]
    n = next((at for at, line in enumerate(lines) if not COMMENT.match(line)), len(lines))
    comments = [f"/// @file {file.name} {first[0].strip()}"] + [f"///{text}" for text in first[1:n]] if n else [f"/// @file {file.name}"]
    return comments + [""] * (len(lines) - len(comments))


def main():
    root, folder, html = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    for top, endings in (("include", [".h"]), ("source", [".cc"]), ("doc", [".md"]), (".", [".md"])):
        for file in sorted((root / top).glob("*.md") if top == "." else (root / top).rglob("*")):
            if file.suffix not in endings:
                continue
            text = file.read_text(encoding="utf-8")
            if file.suffix == ".md":
                text = page_text(file, text)
            else:
                text = "\n".join((header if file.suffix == ".h" else source)(file, text.splitlines())) + "\n"
            target = folder / file.relative_to(root)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text, encoding="utf-8")
    for file in LINKED:
        shutil.copy(file, html / f"{file.name}.txt")


if __name__ == "__main__":
    main()
