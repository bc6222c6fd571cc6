# SPDX-License-Identifier: Apache-2.0
"""A process that solves one scene after the other, on some ranks: starting the program takes longer than most scenes."""

import json
import os
import select
import signal
import subprocess
import time

ANSWER = "\x1eanswer "  # what stands before the worker's answers; other lines on its output are those of libraries


class Run:
    """What became of a scene."""

    def __init__(self, code, out, err=""):
        self.code, self.out, self.err = code, out, err  # exit code of the program; None: the process has died


class Worker:
    """run_scenes.cc on a number of ranks; started when it is first asked, and again after it has died."""

    SECONDS = 300  # for one scene

    def __init__(self, executable, mpiexec, ranks):
        # One rank alone starts faster without mpiexec.
        self.command = ([mpiexec, "-n", str(ranks)] if ranks > 1 else []) + [executable]
        self.process = None
        self.buffer = b""

    def run(self, scene, sets=(), check=False):
        if self.process is None:
            self.process = subprocess.Popen(self.command, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                            stderr=subprocess.STDOUT, start_new_session=True)
            self.buffer = b""
        request = {"scene": str(scene), "set": list(sets), "check": check}
        noise = []
        try:
            self.process.stdin.write(json.dumps(request).encode() + b"\n")
            self.process.stdin.flush()
            deadline = time.monotonic() + self.SECONDS
            while True:
                line = self._line(deadline)
                if line.startswith(ANSWER):
                    answer = json.loads(line[len(ANSWER):])
                    return Run(answer["code"], "".join(noise) + answer["out"], answer["err"])
                noise.append(line + "\n")
        except (EOFError, BrokenPipeError, TimeoutError) as error:
            died = f"{type(error).__name__}: {error}; exit code {self.stop()}"
            return Run(None, "".join(noise), died)

    def _line(self, deadline):
        while b"\n" not in self.buffer:
            ready, _, _ = select.select([self.process.stdout], [], [], max(0, deadline - time.monotonic()))
            if not ready:
                raise TimeoutError(f"no answer in {self.SECONDS} s")
            data = os.read(self.process.stdout.fileno(), 1 << 16)
            if not data:
                raise EOFError("the process has ended: " + self.buffer.decode(errors="replace"))
            self.buffer += data
        line, self.buffer = self.buffer.split(b"\n", 1)
        return line.decode(errors="replace")

    def stop(self):
        """Ends the process, gently if it waits for a request; its exit code."""
        if self.process is None:
            return None
        process, self.process = self.process, None
        try:
            process.stdin.close()
        except BrokenPipeError:
            pass
        try:
            return process.wait(timeout=20)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            return process.wait()
