"""Starts Amontons for a test."""
import os
import subprocess
import tempfile


def run(command, ranks=1, **options):
    """subprocess.run of the program and its arguments, on so many ranks."""
    environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    if int(ranks) > 1:
        return subprocess.run(["mpirun", "--allow-run-as-root", "--oversubscribe", "-np", str(ranks)] + command, env=environment, **options)
    # One rank needs no daemon of Open MPI, which is much of the time of a small scene. Its session folder has no name of its own then: runs that start
    # at once would share it, so each gets its own place.
    environment.update(OMPI_MCA_ess_singleton_isolated="1", OMPI_MCA_pml="ob1", OMPI_MCA_btl="self")
    with tempfile.TemporaryDirectory(prefix="amontons-") as folder:
        return subprocess.run(command, env=dict(environment, TMPDIR=folder), **options)
