"""Prints the scorecard (scorecard.py), writes its page, and reads from the page which red rows it explains."""
import datetime
import re

import scorecard_findings as findings

NOTE = re.compile(r"^- \*\*(?P<case>[^*]+)\*\*, (?P<quantity>.+?): (?P<why>\S.*)$", re.M)
UNKNOWN = "not explained."
COMMAND = "python3 tests/scorecard.py build/amontons --write doc/scorecard.md"


def number(value):
    return "0" if value == 0 else f"{value:.7g}"


def small(value):
    return "0" if value == 0 else f"{value:.1e}".replace("e-0", "e-").replace("e+00", "")


def is_norm(row):
    """Of a difference: has no reference of its own."""
    return row.scale == 1.0 and row.reference == 0


def verdict(name, row):
    if row.green:
        return "green"
    return "explained" if findings.explanation(name, row.quantity) else "red"


def floor(row):
    return small(row.floor) + (f" ({row.origin})" if row.origin and row.floor else "")


def show(result):
    """On the terminal."""
    print(f"\n{result.case.name}: {result.case.title}   {result.seconds:.1f} s {result.failure}")
    for row in result.rows:
        reference = "" if is_norm(row) else number(row.reference)
        ours = small(row.ours) if is_norm(row) else number(row.ours)
        bound = f"{small(row.error):>8} <= {small(row.bound):8} = {floor(row)} + {small(row.estimate)}"
        print(f"  {verdict(result.case.name, row):9} {row.quantity:48} {reference:>12} {ours:>12} {bound}   {row.published}", flush=True)
        if not row.green:
            print(f"            {findings.explanation(result.case.name, row.quantity) or 'not explained'}", flush=True)


def counts(results):
    words = [verdict(result.case.name, row) for result in results for row in result.rows]
    within = sum(row.error <= row.floor for result in results for row in result.rows)
    return {**{word: words.count(word) for word in ("green", "explained", "red")}, "all": len(words), "within": within}


def cells(result, row, others):
    reference = "" if is_norm(row) else number(row.reference)
    ours = "" if is_norm(row) else number(row.ours)
    words = [row.quantity, reference, ours, small(row.error), floor(row), small(row.estimate)] + ([row.published] if others else [])
    color = verdict(result.case.name, row)
    return words + [color if color == "green" else f"**{color}**"]


def table(results):
    others = any(row.published for result in results for row in result.rows)
    head = ["case", "quantity", "reference", "ours", "error", "floor", "estimate"] + (["others"] if others else []) + [""]
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    for result in results:
        title = f"**{result.case.name}** {result.case.title}, {result.seconds:.1f} s"
        if result.failure:
            lines.append(f"| {title} | no answer: {result.failure} |" + " |" * (len(head) - 2))
        for k, row in enumerate(result.rows):
            lines.append("| " + " | ".join([title if k == 0 else ""] + cells(result, row, others)) + " |")
    return lines


def notes(results):
    """A line for each red row; what was said before is not said again."""
    lines, said = [], {}
    for name, quantity in [(result.case.name, row.quantity) for result in results for row in result.rows if not row.green]:
        why = findings.explanation(name, quantity) or UNKNOWN
        lines.append(f"- **{name}**, {quantity}: " + (f"as for {said[why]}." if why in said and why != UNKNOWN else why))
        said.setdefault(why, f"{name}, {quantity}")
    return lines


def page(results, cores):
    now, number_of, cases = datetime.date.today().isoformat(), counts(results), len(results)
    version = next(result.version for result in results if result.version)
    seconds = sum(result.seconds for result in results)
    failed = sum(bool(result.failure) for result in results)
    lines = ["# Scorecard", "", "    " + COMMAND, ""]
    lines += [f"Made by this command on {now}, with Amontons {version}. {findings.HEAD}", ""]
    lines += ["| | |", "|---|---|", f"| rows | {number_of['all']}, of {cases} cases |", f"| green | {number_of['green']} |"]
    lines += [f"| red, explained below their table | {number_of['explained']} |", f"| red, not explained | {number_of['red']} |"]
    lines += [f"| within their floor alone | {number_of['within']} |", f"| cases without an answer | {failed} |", f"| cannot run | {len(findings.CANNOT)} |"]
    lines += [f"| processor seconds | {seconds:.0f}, {cores} at a time |", "", findings.BOUNDS, ""]
    groups = {}
    for result in results:
        groups.setdefault(result.case.group, []).append(result)
    for group, members in groups.items():
        lines += [f"## {group}", ""] + table(members) + [""]
        remarks = notes(members)
        lines += remarks + ([""] if remarks else [])
    lines += ["## What it cannot run", "", "| reference | why |", "|---|---|"] + [f"| {what} | {why} |" for what, why in findings.CANNOT] + [""]
    return "\n".join(lines)


def explained(path):
    """(case, quantity) of the red rows that a page explains."""
    text = path.read_text() if path.exists() else ""
    return {(match["case"], match["quantity"]) for match in NOTE.finditer(text) if match["why"] != UNKNOWN}
