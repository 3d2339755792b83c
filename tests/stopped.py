#!/usr/bin/env python3
"""What is left and said where a run cannot go on: stopped.py AMONTONS

Signals, a time limit, files that cannot be written, a folder that is in use, links, and an earlier run in the folder."""

import csv
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import launch

HERE = os.path.dirname(os.path.abspath(__file__))
SCENE = os.path.join(HERE, "../parameters/half_plane_box_friction.prm")
LONG = ["--set", "End time = 2", "--set", "Increments = 20", "--set", "Refinement/Cycles = 4", "--set", "Output/VTU = false"]
# Multigrid takes thousands of steps for what is nearly incompressible: a minute and more on mesh 3. (Asked for: else all of these are factorised.)
SLOW = [os.path.join(HERE, "../parameters/sphere_on_block_scaling.prm"), "--set", "Body block/Poisson ratio = 0.49999999", "--set", "Linear solver/Type = cg", "--set", "Linear solver/Maximum iterations = 1000000"]
SLOW_AT_ONCE = ["--set", "Body block/Cells = 12, 12, 12"]
SOON = 20  # seconds
QUICK = os.path.join(HERE, "../parameters/patch_test.prm")
failures = []


def check(condition, text):
    if not condition:
        failures.append(text)


def summary_of(folder):
    with open(os.path.join(folder, "summary.json")) as file:
        return json.load(file)


def start(arguments, folder, **options):
    return subprocess.Popen([program] + arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=launch.surroundings(folder), **options)


def run(arguments, **options):
    return launch.run([program] + arguments, capture_output=True, text=True, timeout=300, **options)


def wait_for(path):
    for _ in range(3000):
        if os.path.exists(path):
            return
        time.sleep(0.01)
    failures.append("no " + path)


def stopped_by(number, place):
    """Ends soon, with an answer and exit code 2; goes on to the same answer as a run that nobody stopped."""
    name = signal.Signals(number).name
    out = os.path.join(place, name)
    process = start([SCENE, "--output", out] + LONG, place)
    wait_for(os.path.join(out, "history.csv"))
    process.send_signal(number)
    time.sleep(0.001)
    process.send_signal(number)  # as `timeout` does, to the process and to its group
    said, _ = process.communicate(timeout=300)
    check(process.returncode == 2, f"{name}: exit code {process.returncode}")
    summary = summary_of(out)
    check(summary["failure"] == "stopped" and f"stopped by {name}" in summary["message"], f"{name}: {summary['message']}")
    check(not any("allow more" in note for note in summary["notes"]), f"{name}: advice on a target that was still on its way: {summary['notes']}")
    check("--resume" in said and os.path.isfile(os.path.join(out, "checkpoint", "run")), f"{name}: no checkpoint")
    check(json.load(open(os.path.join(out, "progress.json")))["state"] == "stopped", f"{name}: progress.json")
    check(0 < summary["meshes"][-1]["t"] <= 4 and summary["pairs"], f"{name}: no answer")
    again = run(["--resume", out, "--quiet"])
    check(again.returncode == 0, f"{name}: resumed: {again.stderr}")
    rows = [(mesh["t"], mesh["dofs"], mesh["iterations"], mesh["energy"]) for mesh in summary_of(out)["meshes"]]
    check(rows == whole, f"{name}: resumed it takes another way")
    check(not os.path.exists(os.path.join(out, "checkpoint")), f"{name}: a checkpoint is left")


def ranks_of(process):
    """Process ids: of the program itself, or of what mpirun has started."""
    with open(f"/proc/{process.pid}/task/{process.pid}/children") as file:
        return [int(word) for word in file.read().split()] or [process.pid]


def end_of(process, signalled=None):
    """What it says, where it ends soon after the signal."""
    if signalled:
        os.kill(signalled, signal.SIGTERM)
    try:
        return process.communicate(timeout=SOON)[0]
    except subprocess.TimeoutExpired:
        failures.append("no end within %d s" % SOON)
        for rank in ranks_of(process) + [process.pid]:
            os.kill(rank, signal.SIGKILL)
        return process.communicate()[0]


def in_a_long_solve(place):
    """It is given up; the answer is that of the mesh before, and a resumed run goes on from there."""
    for n_ranks in (1, 2):
        out = os.path.join(place, f"long{n_ranks}")
        mpi = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-np", "2"] if n_ranks > 1 else []
        process = subprocess.Popen(mpi + [program] + SLOW + ["--output", out, "--set", "Output/VTU = true", "--set", "Output/Report = true"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                   env=launch.surroundings(None if mpi else place))
        wait_for(os.path.join(out, "amontons.log"))
        for _ in range(6000):
            if "mesh 3:" in open(os.path.join(out, "amontons.log")).read():
                break
            time.sleep(0.01)
        said = " ".join(end_of(process, ranks_of(process)[-1]).split())  # one rank alone hears of it
        check(process.returncode == 2, f"long solve on {n_ranks}: exit code {process.returncode}")
        check("the last state that converged is that of t = 1 of 1 on mesh 2 (files with fields show it carried to mesh 3)" in said, f"long solve on {n_ranks}: {said[-1500:]}")
        if not os.path.exists(os.path.join(out, "summary.json")):
            continue
        summary = summary_of(out)
        check(summary["failure"] == "stopped" and [mesh["mesh"] for mesh in summary["meshes"]] == [0, 1, 2], f"long solve on {n_ranks}: {summary['message']}")
        check(summary["dofs"] == summary["meshes"][-1]["dofs"] and abs(summary["pairs"][0]["normal_force"][2] + 500) < 0.01, f"long solve on {n_ranks}: not the answer of mesh 2")
        with open(os.path.join(out, "contact.csv")) as file:
            force = sum(float(row["pressure"]) * float(row["area"]) for row in csv.DictReader(file))
        check(450 < force < 550, f"long solve on {n_ranks}: the state that was carried has a force of {force}")
        check({"report.html", "bodies.pvd", "contact.pvd"} <= set(os.listdir(out)), f"long solve on {n_ranks}: {os.listdir(out)}")
        again = run(["--resume", out, "--time-limit", "0.1s"])
        check(again.returncode == 2 and "3 solves are known" in " ".join(again.stdout.split()), f"long solve on {n_ranks}, resumed: {again.stdout[-500:]}{again.stderr}")


def by_a_second_signal(place):
    """A second after the first one it ends the process."""
    process = start(SLOW + SLOW_AT_ONCE + ["--output", os.path.join(place, "second")], place)
    wait_for(os.path.join(place, "second", "amontons.log"))
    process.send_signal(signal.SIGTERM)
    time.sleep(1.2)
    process.send_signal(signal.SIGTERM)
    process.communicate(timeout=300)
    check(process.returncode == -signal.SIGTERM, f"second signal: exit code {process.returncode}")


def in_the_first_solve(place):
    """Nothing has converged: it says so."""
    out = os.path.join(place, "first")
    process = start(SLOW + SLOW_AT_ONCE + ["--output", out, "--time-limit", "1s"], place)
    said = " ".join(end_of(process).split())
    check(process.returncode == 2 and "time limit of 1 s before any state had converged" in said, f"first solve: {process.returncode} {said[-500:]}")
    check(sorted(os.listdir(out)) == ["amontons.log", "progress.json", "summary.json"], f"first solve: {os.listdir(out)}")


def time_limit(place):
    out = os.path.join(place, "limit")
    done = run([SCENE, "--output", out, "--time-limit", "0.01s"] + LONG)
    check(done.returncode == 2 and "time limit of 0.01 s" in done.stdout, "time limit: " + done.stdout[-300:])


def other_entries(place):
    """A checkpoint is of one scene."""
    scene = os.path.join(place, "scene.prm")
    text = open(SCENE).read()
    open(scene, "w").write(text)
    out = os.path.join(place, "changed")
    run([scene, "--output", out, "--time-limit", "0.01s"] + LONG)
    open(scene, "w").write(re.sub(r"Poisson ratio *= *[0-9.]+", "Poisson ratio = 0.21", text, 1))
    done = run(["--resume", out])
    check(done.returncode == 1 and "not what the run in" in done.stderr, "changed scene: " + done.stderr)
    first, second = re.findall(r"^subsection .*?^end\n", text, re.S | re.M)[:2]
    open(scene, "w").write(text.replace(first, "@").replace(second, first).replace("@", second))
    done = run(["--resume", out])
    check(done.returncode == 1 and "another order" in done.stderr, "sections in another order: " + done.stderr)
    open(scene, "w").write(text)
    spoil(parts_of(out)[0])
    done = run(["--resume", out])
    check(done.returncode == 0 and "solved again from solve 1 on" in " ".join(done.stdout.split()) and "checksum" in done.stdout, "damaged checkpoint: " + done.stdout + done.stderr)


def parts_of(out):
    """The files of states, in their order."""
    folder = os.path.join(out, "checkpoint")
    return [os.path.join(folder, name) for name in sorted((name for name in os.listdir(folder) if re.fullmatch("states_[0-9]+", name)), key=lambda name: int(name[7:]))]


def spoil(file):
    with open(file, "r+b") as stream:
        stream.seek(-1, 2)
        stream.write(b"!")


def damaged_part(place):
    """What cannot be read is solved again; so is what is beyond it."""
    out = os.path.join(place, "parts")
    process = start([SCENE, "--output", out, "--set", "Output/Checkpoint every = 1 increments"] + LONG, place)
    wait_for(os.path.join(out, "checkpoint", "states_9"))
    process.kill()
    process.communicate()
    check(len(parts_of(out)) >= 9, "parts: " + str(parts_of(out)))
    before = parts_of(out)
    stopped = run(["--resume", out, "--time-limit", "0.001s"])
    reached = [mesh["t"] for mesh in summary_of(out)["meshes"]][-1]
    check(stopped.returncode == 2 and reached >= 0.1 * len(before) - 1e-9 and parts_of(out)[: len(before)] == before, f"a resumed run stops at t = {reached}, before what it knows")
    spoil(parts_of(out)[5])
    again = run(["--resume", out])
    said = " ".join(again.stdout.split())
    check(again.returncode == 0 and "solved again from solve 6 on" in said and "states_6: damaged: its checksum differs" in said, "damaged part: " + again.stderr)
    rows = [(mesh["t"], mesh["dofs"], mesh["iterations"], mesh["energy"]) for mesh in summary_of(out)["meshes"]]
    check(rows == whole, "damaged part: resumed it takes another way")


def missing_part(place):
    """What was in it is solved again; so is what is beyond it, and both are said."""
    out = os.path.join(place, "missing")
    process = start([SCENE, "--output", out, "--set", "Output/Checkpoint every = 1 increments"] + LONG, place)
    wait_for(os.path.join(out, "checkpoint", "states_9"))
    process.kill()
    process.communicate()
    os.remove(parts_of(out)[4])
    again = run(["--resume", out])
    said = " ".join(again.stdout.split())
    check(again.returncode == 0 and "solved again from solve 5 on" in said and "the part before it, states_5, is missing" in said, "missing part: " + again.stdout + again.stderr)
    rows = [(mesh["t"], mesh["dofs"], mesh["iterations"], mesh["energy"]) for mesh in summary_of(out)["meshes"]]
    check(rows == whole, "missing part: resumed it takes another way")


def refused_while_it_runs(place):
    """Changes nothing."""
    out = os.path.join(place, "alive")
    process = start([SCENE, "--output", out, "--set", "Output/Checkpoint every = 1 increments"] + LONG, place)
    wait_for(os.path.join(out, "checkpoint", "states_4"))
    process.send_signal(signal.SIGSTOP)
    before = parts_of(out)
    spoil(before[0])
    done = run(["--resume", out])
    check(done.returncode == 1 and "in use by another run" in done.stderr and parts_of(out) == before, "resumed while it runs: " + done.stderr)
    process.kill()
    process.communicate()


def killed_again(place):
    """Its only part is damaged, and it is killed before it has written another: the run can be resumed all the same."""
    out = os.path.join(place, "again")
    run([SCENE, "--output", out, "--time-limit", "0.01s"] + LONG)
    check(len(parts_of(out)) == 1, "killed again: " + str(parts_of(out)))
    spoil(parts_of(out)[0])
    os.remove(os.path.join(out, "history.csv"))
    process = start(["--resume", out], place)
    wait_for(os.path.join(out, "history.csv"))
    process.kill()
    process.communicate()
    check(not parts_of(out), "killed again: it has written a part")
    done = run(["--resume", out])
    check(done.returncode == 0, "killed again: " + done.stderr)


def parts_of_another_run(place):
    """Of the same bodies with other friction: what they say fits everywhere, and is wrong."""
    outs = [os.path.join(place, name) for name in ("one_run", "another_run")]
    with open(SCENE) as file:
        name = re.search(r"^ *set (Friction coefficient) *=", file.read(), re.M)
    check(name is not None, "no friction in the scene")
    for out, more in zip(outs, ([], ["--set", "Contact interface/Friction coefficient = 0.11"])):
        stopped = run([SCENE, "--output", out, "--time-limit", "0.01s"] + LONG + more)
        check(stopped.returncode == 2, "another run: " + stopped.stderr)
    for mine, other in zip(parts_of(outs[0]), parts_of(outs[1])):
        shutil.copy(other, mine)
    done = run(["--resume", outs[0]])
    check(done.returncode == 0 and "of another run" in " ".join(done.stdout.split()), "another run: " + done.stdout + done.stderr)
    rows = [(mesh["t"], mesh["dofs"], mesh["iterations"], mesh["energy"]) for mesh in summary_of(outs[0])["meshes"]]
    check(rows == whole, "parts of another run are used")


def other_files(place):
    """A resumed run with fewer files than it had: none stays of before."""
    scene, out = os.path.join(place, "files.prm"), os.path.join(place, "files")
    with open(SCENE) as file:
        text = file.read()

    def entries(wanted):
        with open(scene, "w") as file:
            file.write(text + f"\nsubsection Output\n set VTU = {wanted}\n set Report = {wanted}\n set Contact tables = {wanted}\nend\n")

    entries("true")
    process = start([scene, "--output", out] + LONG[:-2], place)
    wait_for(os.path.join(out, "contact_0003.csv"))
    process.send_signal(signal.SIGTERM)
    process.communicate(timeout=300)
    before = os.listdir(out)
    check({"bodies.pvd", "contact_0000.vtu", "report.html", "checkpoint"} <= set(before), f"other files: {before}")
    entries("false")
    stopped = run(["--resume", out, "--time-limit", "0.001s"])
    aside = os.path.join(out, "earlier_run")
    check(stopped.returncode == 2 and {"bodies.pvd", "report.html"} <= set(os.listdir(aside)) and "checkpoint" in os.listdir(out), f"other files, resumed: {os.listdir(out)} {stopped.stderr}")
    done = run(["--resume", out])
    left = sorted(os.listdir(out))
    check(done.returncode == 0 and left == ["amontons.log", "contact.csv", "history.csv", "progress.json", "summary.json"], f"other files: left are {left} {done.stderr}")


def other_mesh_file(place):
    """With the same vertices: only the name of a boundary is another one."""
    for name in ("patch_3d_irregular.prm", "patch_3d_upper.msh", "patch_3d_lower.msh"):
        shutil.copy(os.path.join(HERE, "../parameters/verification", name), place)
    scene, mesh, out = os.path.join(place, "patch_3d_irregular.prm"), os.path.join(place, "patch_3d_lower.msh"), os.path.join(place, "meshes")
    stopped = run([scene, "--output", out, "--set", "Increments = 3", "--time-limit", "0.001s"])
    check(stopped.returncode == 2, "mesh file: " + stopped.stdout + stopped.stderr)
    with open(mesh, "a") as stream:
        stream.write("\n")
    done = run(["--resume", out])
    check(done.returncode == 1 and "patch_3d_lower.msh" in done.stderr and "checksum" in done.stderr, "mesh file: " + done.stderr)


def full_disk(place):
    """No file may be larger than 50 kB: the answer is on the screen all the same."""
    out = os.path.join(place, "full")

    def small_files():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (50000, 50000))

    done = run([SCENE, "--output", out, "--set", "Contact solver/Tolerance = 1e-9"], preexec_fn=small_files)
    check(done.returncode == 2 and "cannot write this file" in " ".join(done.stdout.split()), f"full disk: {done.returncode} {done.stdout[-300:]} {done.stderr}")
    check("peak pressure" in done.stdout, "full disk: no answer on the screen")
    check(os.path.exists(os.path.join(out, "contact.csv")), "full disk: small files are not written")
    check(not [name for name in os.listdir(out) if name.endswith(".tmp")], "full disk: halves of files are left")


def two_at_once(place):
    out = os.path.join(place, "two")
    process = start([SCENE, "--output", out] + LONG, place)
    wait_for(os.path.join(out, "history.csv"))
    second = run([QUICK, "--output", out])
    check(second.returncode == 1 and f"in use by another run, process {process.pid} on" in second.stderr, "two at once: " + second.stderr)
    process.kill()
    process.communicate()
    third = run([QUICK, "--output", out])  # the lock of a dead process counts no longer
    check(third.returncode == 0, "after a kill: " + third.stderr)
    check(summary_of(out)["scene"] == QUICK and not os.path.exists(os.path.join(out, "earlier_run")), "after a kill: mixed folder")
    check(not os.path.exists(os.path.join(out, "history.csv.tmp")), "after a kill: halves of files")


def earlier_run(place):
    """Stays until there is an answer; not touched where there is none."""
    out = os.path.join(place, "earlier")
    check(run([QUICK, "--output", out]).returncode == 0, "first run")
    before = sorted(os.listdir(out))
    open(os.path.join(out, "mine.txt"), "w").write("mine")
    wrong = run([QUICK, "--output", out, "--set", "Contact interface/Slave = neither"])
    check(wrong.returncode == 1 and sorted(os.listdir(out)) == sorted(before + ["mine.txt"]), "a refused run changes the folder")
    process = start([SCENE, "--output", out] + LONG, place)
    wait_for(os.path.join(out, "history.csv"))
    wait_for(os.path.join(out, "earlier_run", "summary.json"))
    process.send_signal(signal.SIGKILL)
    process.communicate()
    check(summary_of(os.path.join(out, "earlier_run"))["scene"] == QUICK, "the earlier run is not set aside")
    check(run([SCENE, "--output", out, "--set", "Output/VTU = false"]).returncode == 0, "run after a kill")
    check("earlier_run" not in os.listdir(out) and "bodies.pvd" not in os.listdir(out) and "mine.txt" in os.listdir(out), "files of the earlier run are left")


def links(place):
    out, victim = os.path.join(place, "links"), os.path.join(place, "victim")
    os.mkdir(out)
    open(victim, "w").write("precious")
    for name in ["summary.json", "summary.json.tmp", "contact.csv", "amontons.log", "history.csv.tmp", ".lock"]:
        os.symlink(victim, os.path.join(out, name))
    run([QUICK, "--output", out])
    check(open(victim).read() == "precious", "a link is written through")


def tables(place):
    out = os.path.join(place, "tables")
    run([SCENE, "--output", out, "--set", "Output/Contact tables = true", "--quiet"])
    for k in range(2):
        check(os.path.exists(os.path.join(out, f"contact_000{k}.csv")), "no table of increment %d" % (k + 1))
    check("iteration" in open(os.path.join(out, "amontons.log")).read(), "no log")


def inputs(place):
    """Each is refused at once."""
    deep, fifo, circle, large = (os.path.join(place, name) for name in ["deep.json", "fifo", "circle.prm", "large.prm"])
    open(deep, "w").write('{"a":' * 1000000 + "1" + "}" * 1000000)
    os.mkfifo(fifo)
    open(circle, "w").write("include circle.prm\n")
    with open(large, "w") as file:
        file.truncate(10 ** 9)
    for name, words in [(deep, "nested more than 100"), (fifo, "no regular file"), ("/dev/zero", "no regular file"), (place, "no regular file"),
                        (circle, "without end"), (large, "larger than 16 MB")]:
        done = subprocess.run([program, name], capture_output=True, text=True, timeout=60, env=launch.surroundings(place))
        check(done.returncode == 1 and words in done.stderr, f"{name}: {done.returncode} {done.stderr[-300:]}")


signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell ignores it for what it starts aside, and so would the runs
program = os.path.abspath(sys.argv[1])
with tempfile.TemporaryDirectory(prefix="amontons-stopped-") as folder:
    check(run([SCENE, "--output", os.path.join(folder, "whole")] + LONG).returncode == 0, "the run itself")
    whole = [(mesh["t"], mesh["dofs"], mesh["iterations"], mesh["energy"]) for mesh in summary_of(os.path.join(folder, "whole"))["meshes"]]
    stopped_by(signal.SIGTERM, folder)
    stopped_by(signal.SIGINT, folder)
    for part in (in_a_long_solve, by_a_second_signal, in_the_first_solve, time_limit, other_entries, damaged_part, missing_part, refused_while_it_runs, killed_again, parts_of_another_run, other_files, other_mesh_file, full_disk, two_at_once, earlier_run, links, tables, inputs):
        part(folder)
print("\n".join(failures) or "all right")
sys.exit(1 if failures else 0)
