#!/usr/bin/env python3
"""A study that is killed at a random moment goes on and ends with the same table: killed_study.py AMONTONS

A small map and a small work-precision study are run once from beginning to end, then killed (the program alone, with SIGKILL; then with SIGINT) and begun again
until they end. Compared are the results but for what was measured, and the printed map. Nothing that the studies started may be left.
"""
import csv
import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
MEASURED = {"wall seconds", "processor seconds", "megabytes"}

MAP = f"""set Kind              = stability
set Title             = A small map
set Scene             = {ROOT}/parameters/floating_slab.prm
set Overrides         = Refinement/Cycles = 0 | Body slab/Refinements = 0
set Expected          = pairs.0.normal_force.1 = 800 | pairs.0.tangential_force.0 = -120
set No solution where = 0.15 - y
set Threshold         = T/N: 0.15
subsection Sweep
  set 1 = Increments: 1, 2
  set 2 = Contact base/Friction coefficient: 0.1, 0.2, 1
end
subsection Series Amontons (dual mortar)
end
subsection Series outside
  set Overrides = Body slab/Poisson ratio = 0.5
end
"""

WORK = f"""set Kind       = work precision
set Title      = A small study
set Scene      = {ROOT}/parameters/hertz_cylinder.prm
set Overrides  = Refinement/Initial refinements = 2
set Quantities = reference.errors.contact_size
set Targets    = 0.1
subsection Sweep
  set 1 = Discretization/Degree: 1, 2
  set 2 = Refinement/Cycles: 0, 1, 2
end
"""


def start(program, study, output):
    with tempfile.TemporaryDirectory(prefix="amontons-") as temporary:
        process = subprocess.Popen([program, "study", study, "--output", output, "--jobs", "2"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                   env=dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", OMPI_MCA_ess_singleton_isolated="1",
                                            OMPI_MCA_pml="ob1", OMPI_MCA_btl="self", TMPDIR=temporary))
        yield process
        process.communicate()


def run(program, study, output):
    """Exit code, what was printed, seconds."""
    begin = time.monotonic()
    for process in start(program, study, output):
        out, errors = process.communicate()
    return process.returncode, out + errors, time.monotonic() - begin


def results(output, study):
    """Of all runs, without what was measured."""
    with open(os.path.join(output, pathlib.Path(study).stem + ".csv")) as stream:
        stream.readline()
        return [{name: value for name, value in row.items() if name not in MEASURED} for row in csv.DictReader(stream)]


def n_rows(output, study):
    try:
        with open(os.path.join(output, pathlib.Path(study).stem + ".csv")) as stream:
            return stream.read().count("\n") - 2
    except OSError:
        return 0


def grids(printed):
    return re.findall(r"^.*\|.*$|^ +\+ .*$", printed, re.M)


def processes_with(text):
    found = []
    for folder in pathlib.Path("/proc").iterdir():
        try:
            if folder.name.isdigit() and text in (folder / "cmdline").read_text():
                found.append(folder.name)
        except OSError:
            pass
    return found


def check(program, folder, name, text, expected):
    study = os.path.join(folder, name + ".prm")
    pathlib.Path(study).write_text(text)
    whole, part = os.path.join(folder, name + "_whole"), os.path.join(folder, name + "_killed")
    code, printed, seconds = run(program, study, whole)
    complaints = [f"ended with {code}: {printed}"] if code != 0 else []
    complaints += [f"'{line}' is not printed" for line in expected if line not in printed]
    for number in (signal.SIGKILL, signal.SIGINT):
        moment = random.uniform(0.1, 0.9) * seconds
        for process in start(program, study, part):
            time.sleep(moment)
            process.send_signal(number)
            process.wait()
        time.sleep(0.3)
        print(f"{name}: {number.name} after {moment:.2f} of {seconds:.2f} s, {n_rows(part, study)} results", flush=True)
        if processes_with(part):
            complaints.append(f"{number.name} leaves processes {processes_with(part)}")
    code, again, _ = run(program, study, part)
    if code != 0 or results(part, study) != results(whole, study):
        complaints.append(f"another table ({code}):\n{results(part, study)}\ninstead of\n{results(whole, study)}")
    if grids(again) != grids(printed):
        complaints.append(f"printed\n{again}\ninstead of\n{printed}")
    left = [path for path in os.listdir(part) if path.endswith("_runs")]
    return [f"{name}: {text}" for text in complaints + [f"left behind: {path}" for path in left]]


def main():
    program = os.path.abspath(sys.argv[1])
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else random.randrange(10**6)
    random.seed(seed)
    print(f"seed {seed}")
    with tempfile.TemporaryDirectory(prefix="amontons-killed-") as folder:
        complaints = check(program, folder, "map", MAP, ["+ solved 4  r refused with reason 2", "r refused with reason 6"])
        complaints += check(program, folder, "work", WORK, ["The cheapest run that reaches these errors of contact_size"])
    print("\n".join(complaints) or "both studies went on")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
