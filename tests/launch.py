"""Starts Amontons for a test."""
import os
import pathlib
import subprocess
import tempfile
import threading


def surroundings(folder=None):
    """Environment of a run. One rank needs no daemon of Open MPI, which is much of the time of a small scene. Its session folder has no name of its own
    then: runs that start at once would share it, so each gets its own place."""
    environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    if folder:
        environment.update(OMPI_MCA_ess_singleton_isolated="1", OMPI_MCA_pml="ob1", OMPI_MCA_btl="self", TMPDIR=folder)
    return environment


def run(command, ranks=1, **options):
    """subprocess.run of the program and its arguments, on so many ranks."""
    # A build has a server that saves the 0.4 s of linking 200 libraries: see fork_server.cc. The runs of a study would get the surroundings that the server began
    # with, and limits and signals that are set here are not passed on.
    client = pathlib.Path(command[0]).parent / "tests" / "fork_client"
    if client.exists() and "study" not in command and "preexec_fn" not in options:
        command = [client] + command
    if int(ranks) > 1:
        return subprocess.run(["mpirun", "--allow-run-as-root", "--oversubscribe", "-np", str(ranks)] + command, env=surroundings(), **options)
    with tempfile.TemporaryDirectory(prefix="amontons-") as folder:
        return subprocess.run(command, env=surroundings(folder), **options)


def timed(command, limit, log):
    """Runs on one rank: exit code (negative: a signal, as after `limit` seconds), processor seconds. What it prints goes to the file `log`."""
    with tempfile.TemporaryDirectory(prefix="amontons-") as folder, open(log, "w") as out:
        process = subprocess.Popen(command, env=surroundings(folder), stdout=out, stderr=subprocess.STDOUT)
        timer = threading.Timer(limit, process.kill)
        timer.start()
        _, status, usage = os.wait4(process.pid, 0)
        timer.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, usage.ru_utime + usage.ru_stime
