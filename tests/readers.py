"""Asks read_inputs, which reads inputs in one process: some hundred in a second."""
import os
import select
import subprocess
import time

import launch


class Readers:
    """One process of read_inputs, which is started again when it dies. `memory`: of addresses, kB. What libraries print is in `errors`."""

    def __init__(self, executable, folder, memory):
        self.executable, self.memory = executable, memory
        self.errors = open(os.path.join(folder, "errors"), "w+b", buffering=0)
        self.tmp = os.path.join(folder, "tmp")
        os.makedirs(self.tmp)
        self.process = None

    def start(self):
        self.process = subprocess.Popen(["bash", "-c", f'ulimit -v {self.memory}; exec "$@"', "readers", self.executable], env=launch.surroundings(self.tmp),
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self.errors)

    def stop(self):
        if self.process:
            self.process.kill()
            self.process.wait()
            self.process = None

    def read(self, stop):
        """Bytes of the answer, b"" if the process has died; None after the time `stop`."""
        ready, _, _ = select.select([self.process.stdout], [], [], max(0, stop - time.monotonic()))
        return os.read(self.process.stdout.fileno(), 65536) if ready else None

    def ask(self, line, seconds):
        """What is answered to a line ("scene FILE", "study FILE", "folder DIR"): exit code as of a run ("hang", "error" where there is none), and what was said."""
        if self.process is None:
            self.start()
        stop, answer = time.monotonic() + seconds, b""
        self.process.stdin.write(line.encode() + b"\n")
        self.process.stdin.flush()
        while True:
            head, _, words = answer.partition(b"\n")
            kind, _, size = head.partition(b" ")
            if b"\n" in answer and len(words) >= int(size or 0):
                return {b"answer": 0, b"refusal": 1}.get(kind, kind.decode()), words
            part = self.read(stop)
            if not part:
                code = "hang" if part is None else self.process.wait()
                self.stop()
                return code, b""
            answer += part

    def noise(self):
        """What libraries have printed since this was asked for last."""
        self.errors.seek(0)
        text = self.errors.read()
        self.errors.seek(0)
        self.errors.truncate()
        return text
