#!/usr/bin/env python3
"""How right is the program? scorecard.py AMONTONS [--only PART] [-j N] [--write PAGE.md] [--test] [--list]

Runs the reference cases (scorecard_cases.py, scorecard_uniform.py, scorecard_friction.py, scorecard_benchmarks.py), each run in a process of its own with a time
limit, and prints a row for each quantity: reference, ours, error, what it may be off by, and what other programs say. A row is green where

    error <= floor + estimate

floor: what the model of the reference or its digits leave open; estimate: what the program itself says that it is off by. Where a row is red,
scorecard_findings.py says why. doc/scorecard.md is made by --write.

--only: cases whose names, titles or groups contain this. --test: the small cases; exit code 1 where a row is red that doc/scorecard.md does not explain.
"""
import argparse
import concurrent.futures
import pathlib
import sys
from dataclasses import dataclass, field

import scorecard_cases  # the order of these is that of the page
import scorecard_uniform
import scorecard_friction
import scorecard_benchmarks
import scorecard_page as pages
from scorecard_parts import CASES, NoAnswer, Runner

MODULES = [scorecard_cases, scorecard_uniform, scorecard_friction, scorecard_benchmarks]
PAGE = pathlib.Path(__file__).resolve().parent.parent / "doc" / "scorecard.md"


@dataclass
class Result:
    case: object
    rows: list = field(default_factory=list)
    seconds: float = 0.0
    version: str = ""
    failure: str = ""


def solve(program, case):
    run = Runner(program)
    try:
        rows, failure = case.function(run), ""
    except (NoAnswer, ArithmeticError, LookupError, ValueError) as error:  # the latter: an answer without what is looked for
        rows, failure = [], " ".join(f"{type(error).__name__} {error}".split())
    return Result(case, rows, run.seconds, run.version, failure)


def solve_all(program, cases, jobs):
    results = {}
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for task in concurrent.futures.as_completed([pool.submit(solve, program, case) for case in cases]):
            result = task.result()
            results[result.case.name] = result
            pages.show(result)
    return [results[case.name] for case in cases]


def complaints(results):
    """What the page does not explain."""
    known = pages.explained(PAGE)
    red = [(result.case.name, row.quantity) for result in results for row in result.rows if not row.green]
    failed = [f"{result.case.name}: no answer: {result.failure}" for result in results if result.failure]
    return failed + [f"{name}, {quantity}: red, and doc/scorecard.md does not explain it" for name, quantity in red if (name, quantity) not in known]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("amontons", type=pathlib.Path)
    parser.add_argument("--only", default="")
    parser.add_argument("-j", type=int, default=1)
    parser.add_argument("--write", type=pathlib.Path)
    parser.add_argument("--test", action="store_true")
    parser.add_argument("--list", action="store_true")
    arguments = parser.parse_args()
    if arguments.write and (arguments.only or arguments.test):
        parser.error("--write takes all cases")
    cases = [case for case in CASES if arguments.only in f"{case.name} {case.title} {case.group}" and (case.small or not arguments.test)]
    if arguments.list:
        print("\n".join(f"{case.name:14} {case.group}: {case.title}" for case in cases))
        return
    results = solve_all(arguments.amontons.resolve(), cases, arguments.j)
    numbers, seconds = pages.counts(results), sum(result.seconds for result in results)
    print(f"\n{numbers['green']} rows green, {numbers['explained']} explained, {numbers['red']} red; {seconds:.0f} processor seconds")
    if arguments.write:
        arguments.write.write_text(pages.page(results, arguments.j))
    if arguments.test:
        found = complaints(results)
        print("\n".join(found))
        sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
