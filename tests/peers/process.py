"""One process, measured."""
import os
import subprocess
import threading
import time


def measured(command, folder, limit):
    """Runs it in `folder` on one thread: exit code (negative: killed, as after `limit` seconds), seconds of wall and processor, megabytes. What it prints goes to `log`."""
    one = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", MKL_NUM_THREADS="1")
    begin = time.monotonic()
    with open(os.path.join(folder, "log"), "w") as log:
        process = subprocess.Popen(command, cwd=folder, env=one, stdout=log, stderr=subprocess.STDOUT)
        timer = threading.Timer(limit, process.kill)
        timer.start()
        _, status, usage = os.wait4(process.pid, 0)
        timer.cancel()
    process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, {"wall": time.monotonic() - begin, "cpu": usage.ru_utime + usage.ru_stime, "memory_MB": usage.ru_maxrss / 1024}
