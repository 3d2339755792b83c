#!/usr/bin/env python3
"""What is too slow for every run of the tests: `ninja -C build lint`, or lint.py BUILD_DIR [format|headers|tidy]... [--only REGEX]

format:  clang-format (check_format.py);
headers: each header compiles alone, that is, includes what it uses;
tidy:    clang-tidy over all sources with the checks of .clang-tidy (which says why each is there).
Needs clang-format and clang-tidy. Prints what it finds and exits 1 if there is anything.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def commands(build):
    """{source: how to compile it by itself}, from a configuration without unity files and precompiled headers, which clang could not read."""
    folder = pathlib.Path(build) / "lint"
    subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DAMONTONS_UNITY=OFF",
                    "-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON"], check=True, stdout=subprocess.DEVNULL)
    entries = json.loads((folder / "compile_commands.json").read_text())
    return folder, {e["file"]: shlex.split(e["command"]) for e in entries if "_release.dir" in e["command"]}


def compile_header(flags, header):
    done = subprocess.run(flags + ["-fsyntax-only", "-x", "c++", "-"], input=f"#include <{header}>\n", capture_output=True, text=True)
    return "" if done.returncode == 0 else f"{header} does not compile alone:\n" + "\n".join(re.findall(r".*error:.*", done.stderr)[:5])


def tidy(folder, source):
    done = subprocess.run(["clang-tidy", "-p", str(folder), "--quiet", source], capture_output=True, text=True)
    lines = [line for line in done.stdout.splitlines() if re.search(r"(warning|error): .*\[[a-z]", line) and str(ROOT) in line]
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("what", nargs="*", default=["format", "headers", "tidy"])
    parser.add_argument("--only", default="", help="a regular expression of file names")
    arguments = parser.parse_args()
    jobs = []
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        if "format" in arguments.what:
            jobs.append(pool.submit(lambda: "" if subprocess.run([sys.executable, ROOT / "tests/check_format.py"]).returncode == 0 else "format"))
        folder, by_source = commands(arguments.build)
        some = next(iter(by_source.values()))
        flags = some[: some.index("-o")]
        for header in sorted((ROOT / "include").rglob("*.h")):
            name = str(header.relative_to(ROOT / "include"))
            if "headers" in arguments.what and re.search(arguments.only, name):
                jobs.append(pool.submit(compile_header, flags, name))
        for source in sorted(by_source):
            if "tidy" in arguments.what and re.search(arguments.only, source) and source.startswith(str(ROOT / "source")):
                jobs.append(pool.submit(tidy, folder, source))
        found = 0
        for job in concurrent.futures.as_completed(jobs):
            if job.result():
                print(job.result(), flush=True)
                found += 1
    print(f"{len(jobs)} jobs, {found} with findings")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
