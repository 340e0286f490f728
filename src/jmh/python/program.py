# SPDX-License-Identifier: Apache-2.0
"""A program that measures on request, so that several can go in turns: it reads lines, and answers each with one
line."""
import os
import subprocess
import threading


class Program:
    """A started program that has reported ready; a request raises ValueError if the program ends."""

    def __init__(self, command, environment, folder, log, longest=None):
        """longest: maximum seconds of an answer."""
        self.longest = longest
        self.late = False
        self.log = open(log, "a")
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self.log, universal_newlines=True, cwd=folder,
                                        env=dict(os.environ, **environment))
        self.answer()

    def stop(self):
        self.late = True
        self.process.kill()

    def answer(self):
        watch = threading.Timer(self.longest, self.stop) if self.longest else None
        if watch:
            watch.start()
        line = self.process.stdout.readline()
        if watch:
            watch.cancel()
        if not line:
            self.close()
            raise ValueError("no answer within %d s" % self.longest if self.late else "it ended; its messages are in " + self.log.name)
        return line.split()

    def ask(self, line):
        try:
            self.process.stdin.write(line + "\n")
            self.process.stdin.flush()
        except BrokenPipeError:
            pass
        return self.answer()

    def close(self):
        try:
            self.process.stdin.close()
        except BrokenPipeError:
            pass
        self.process.wait()
        self.process.stdout.close()
        self.log.close()
