# SPDX-License-Identifier: Apache-2.0
"""Code of a Dask worker: passes runs to child processes, which are reused, and kills those that exceed their time or
memory."""
import json
import os
import pickle
import queue
import signal
import subprocess
import sys
import tempfile
import threading
import time

from ._child import LENGTH

START_SECONDS = 180
LOOK_SECONDS = 0.2
LOG_BYTES = 64 * 1024 * 1024
RUNS = 2000    # maximum runs of one process
SHELL = "/bin/sh"
# Stays the parent of its arguments, so that signals of a script to its parent don't end the Dask worker
PARENT = (SHELL, "-c", '"$@"; exit $?', "sear") if os.access(SHELL, os.X_OK) else ()
BY_SIGNAL = 128    # a shell's exit status for a signal's number


class Child:
    """A child process. One thread at a time."""

    def __init__(self, folder, kind):
        self._log = tempfile.TemporaryFile(mode="a+b")
        self._process = subprocess.Popen([*PARENT, sys.executable, "-m", "sear.sweeps._child", kind], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                         stderr=self._log, cwd=folder if os.path.isdir(folder) else None, start_new_session=True)
        self._answers = queue.Queue()
        self.runs = 0
        threading.Thread(target=self._listen, name="answers", daemon=True).start()
        hello = self._wait(START_SECONDS, None)
        self.version = hello.get("version")
        if self.version is None:
            said = self.output().strip().split("\n")[-1]
            self.end()
            raise RuntimeError("SEAR does not start on %s: %s" % (os.uname().nodename if hasattr(os, "uname") else "a worker",
                                                                  hello.get("problem") or said or hello["message"]))

    def _listen(self):
        stream = self._process.stdout
        while True:
            head = stream.read(LENGTH.size)
            if len(head) < LENGTH.size:
                self._answers.put(None)
                return
            self._answers.put(json.loads(stream.read(LENGTH.unpack(head)[0])))

    def run(self, task):
        """Returns the row's status, message and results."""
        self.runs += 1
        os.ftruncate(self._log.fileno(), 0)
        question = pickle.dumps(task)
        try:
            self._process.stdin.write(LENGTH.pack(len(question)) + question)
            self._process.stdin.flush()
        except OSError:
            pass    # detected below
        return self._wait(task["limit"], task["memory"])

    def _wait(self, limit, memory):
        end = time.monotonic() + limit
        while True:
            left = end - time.monotonic()
            if left <= 0:
                return _lost("time", "the run took longer than %g s" % limit)
            try:
                answer = self._answers.get(timeout=min(LOOK_SECONDS, left))
            except queue.Empty:
                if self._process.poll() is not None:    # the script has ended its parent
                    return _lost("died", self._death())
                if memory is not None and self._bytes() > memory * 2 ** 20:
                    return _lost("memory", "the run's process used more than %g MB" % memory)
                if os.fstat(self._log.fileno()).st_size > LOG_BYTES:
                    os.ftruncate(self._log.fileno(), 0)
                continue
            return _lost("died", self._death()) if answer is None else answer

    def _bytes(self):
        import psutil
        try:
            process = psutil.Process(self._process.pid)
            return sum(one.memory_info().rss for one in [process] + process.children(recursive=True))
        except psutil.Error:
            return 0

    def _death(self):
        status = self._process.wait()
        number = -status if status < 0 else status - BY_SIGNAL if PARENT else 0
        if number in set(signal.Signals):
            return "the run's process was ended by %s" % signal.Signals(number).name
        return "the run ended its process with status %d" % status

    def output(self):
        """Returns what the run has printed."""
        self._log.seek(0)
        return self._log.read(LOG_BYTES).decode("utf-8", "replace")

    def end(self):
        """Kills the process and its children."""
        try:
            if hasattr(os, "killpg"):
                os.killpg(self._process.pid, signal.SIGKILL)
            else:
                self._process.kill()
        except (ProcessLookupError, PermissionError):
            pass
        self._process.wait()
        self._process.stdin.close()
        self._log.close()


def _lost(status, message):
    return {"status": status, "message": message, "results": {}, "clean": False}


class _Children:
    """Free and busy children of this worker."""
    lock = threading.Lock()
    free = {}
    busy = set()


def run(task):
    """Performs one run: returns a dictionary of status, message and results, with task["output"] also the printed text.

    Raises RuntimeError if no run is possible here.
    """
    key = task["folder"], task["kind"]
    with _Children.lock:
        waiting = _Children.free.setdefault(key, [])
        child = waiting.pop() if waiting else None
    if child is None:
        child = Child(*key)
    with _Children.lock:
        _Children.busy.add(child)
    try:
        if child.version != task["version"]:
            raise RuntimeError("a worker has SEAR %s, but the sweep started with %s: install that version there" % (child.version, task["version"]))
        answer = child.run(task)
        if task.get("output"):
            answer["output"] = child.output()
    except BaseException:
        child.end()
        raise
    finally:
        with _Children.lock:
            _Children.busy.discard(child)
    if answer.pop("clean") and child.runs < RUNS:
        with _Children.lock:
            _Children.free[key].append(child)
    else:
        child.end()
    return answer


def run_all(common, parts):
    """Performs several runs, each with its own data; the answers include the seconds of each."""
    answers = []
    for part in parts:
        begun = time.monotonic()
        answer = run({**common, **part})
        answers.append({**answer, "seconds": time.monotonic() - begun})
    return answers


def close():
    """Ends all child processes of this worker."""
    with _Children.lock:
        children = list(_Children.busy) + [one for some in _Children.free.values() for one in some]
        _Children.free.clear()
        _Children.busy.clear()
    for one in children:
        one.end()
