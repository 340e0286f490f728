# SPDX-License-Identifier: Apache-2.0
"""A process that performs runs one by one. Requests arrive on its standard input, answers go to its standard output.

Java starts once. Output of scripts goes to standard error, which the parent redirects to a file. The process ends when
its standard input is closed.
"""
import importlib
import json
import os
import pickle
import queue
import random
import re
import shutil
import struct
import sys
import tempfile
import threading
import time
import types

from . import _plan

LENGTH = struct.Struct(">I")
FRAME = re.compile(r'^ +File "(.*)", line (\d+)')
MESSAGE_LENGTH = 2000
PROJECT = "SEARproject"


def _streams():
    """Returns the streams of requests and answers; hides both from scripts."""
    questions = os.fdopen(os.dup(0), "rb")
    answers = os.fdopen(os.dup(1), "wb")
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    os.dup2(2, 1)
    return questions, answers


def _listen(questions, asked):
    """Reads requests on its own thread, so that the end of the parent also ends an endless script."""
    try:
        while True:
            head = questions.read(LENGTH.size)
            if len(head) < LENGTH.size:
                break
            asked.put(pickle.loads(questions.read(LENGTH.unpack(head)[0])))
    finally:
        os._exit(0)


def _answer(answers, what):
    text = json.dumps(what).encode("ascii")
    answers.write(LENGTH.pack(len(text)) + text)
    answers.flush()


def shortened(traceback, script):
    """Returns the message of a row: the line of the script and the error, printable."""
    return _plan.printable(_shortened(traceback, script))


def _shortened(traceback, script):
    lines = traceback.rstrip().split("\n")
    frames = [found for found in map(FRAME.match, lines) if found]
    if not frames:
        return " ".join(traceback.split())[:MESSAGE_LENGTH]
    own = [one.group(2) for one in frames if script is not None and os.path.basename(one.group(1)) == os.path.basename(script)]
    last = max(at for at, line in enumerate(lines) if line.startswith("  "))
    said = " ".join(" ".join(lines[last + 1:]).split())
    where = "line %s: " % own[-1] if own else "%s, line %s: " % (os.path.basename(frames[-1].group(1)), frames[-1].group(2))
    return (where + said)[:MESSAGE_LENGTH]


class _Runs:
    """The runs of this process."""

    def __init__(self, kind):
        import sear
        from sear import _errors, _modules, _objects
        sear.start(headless=True, speed="max", threads=1)
        self._sear = sear
        self._errors = _errors
        self._java = _objects.connection.backend
        self._system = self._java.raw_class("java.lang.System")
        self._scripts = self._java.raw_class("org.SEAR.cli.sweep.ScriptRuns")
        self._parameters = self._java.raw_class("org.myrobotlab.service.sear.run.RunParameters")
        self._modules = _modules
        self._home = os.getcwd()
        self._function = (None, None)
        if kind == "jython":
            self._scripts.prepare()

    def run(self, task):
        """Performs one run. Returns status, message, results, and whether the process is clean afterwards."""
        folder = tempfile.mkdtemp(prefix="sear-sweep")
        project = os.path.join(folder, PROJECT)
        if os.path.isdir(PROJECT):
            shutil.copytree(PROJECT, project)
        given = {"sear.seed": str(task["seed"]), "sear.project": project}
        for name, value in task["parameters"].items():
            given["sear.parameter." + name] = str(value).lower() if isinstance(value, bool) else str(value)
        for name, value in given.items():
            self._system.setProperty(name, value)
        self._parameters.takeResults()
        self._sear.python.failed = False
        random.seed(task["seed"])
        import numpy
        numpy.random.seed(task["seed"] % 2 ** 32)
        threads = threading.active_count()
        try:
            answered, message = self._carried_out(task, folder)
            results = {str(name): self._java.to_python(value) for name, value in self._parameters.takeResults().items()}
            results.update(answered or {})
            wrong = None if message else _wrong(results, task["parameters"])
            return {"status": "failed" if message or wrong else "ok", "message": message or wrong or "", "results": {} if wrong else results,
                    "unasked": [] if task["kind"] == "function" else [str(name) for name in self._parameters.unasked()],
                    "clean": threading.active_count() <= threads}
        finally:
            for name in given:
                self._system.clearProperty(name)
            os.chdir(self._home)
            shutil.rmtree(folder, ignore_errors=True)

    def _carried_out(self, task, folder):
        """Returns the result of a function or script, and its error."""
        if task["kind"] == "function":
            return self._python(lambda: self._call(task), None)
        script = task["path"]
        if not _same(script, task["payload"]):
            script = os.path.join(folder, os.path.basename(script))
            with open(script, "wb") as file:
                file.write(task["payload"])
        if task["kind"] == "python3":
            return self._python(lambda: self._execute(script, task["payload"]), script)
        said = str(self._scripts.run(script) or "")
        print(said, file=sys.stderr)
        return None, shortened(said, script) if said else None

    def _python(self, work, script):
        threads = threading.active_count()
        modules = set(sys.modules)
        main = sys.modules["__main__"]
        path, arguments = list(sys.path), list(sys.argv)
        answer = message = None
        try:
            answer = work()
        except SystemExit as end:
            if end.code not in (None, 0):
                message = "exit status %s" % end.code if isinstance(end.code, int) else _plan.printable(str(end.code))
        except BaseException as error:
            told = self._errors.told(error)
            print(told, file=sys.stderr)
            message = shortened(told, script)
        finally:
            self._sear.python.end()
            self._scripts.release()
            sys.modules["__main__"] = main
            sys.path[:], sys.argv[:] = path, arguments
            if script is not None:
                _forget(modules, os.path.dirname(script))
            _settle(threads)
        if not message and self._sear.python.failed:
            message = "a callback failed"
        return answer, message

    def _call(self, task):
        """Calls a function, which is unpickled once, not for each run."""
        if self._function[0] != task["digest"]:
            import cloudpickle
            for name in task["modules"]:
                importlib.import_module(name)
            sys.path.insert(0, task["imports"])
            self._function = (task["digest"], cloudpickle.loads(task["payload"]))
        answer = self._function[1](seed=task["seed"], **task["parameters"])
        if answer is None or isinstance(answer, dict):
            return answer and {name: value.item() if hasattr(value, "item") else value for name, value in answer.items()}
        return {"result": answer.item() if hasattr(answer, "item") else answer}

    def _execute(self, script, source):
        """Runs a script like `python3 -m sear`."""
        self._modules.install()
        module = types.ModuleType("__main__")
        module.__dict__.update(__file__=os.path.abspath(script), Runtime=self._sear.Runtime, python=self._sear.python, sleep=time.sleep)
        sys.modules["__main__"] = module
        sys.argv[:] = [script]
        sys.path.insert(0, os.path.dirname(os.path.abspath(script)))
        exec(compile(source, script, "exec"), module.__dict__)


def _same(path, content):
    try:
        with open(path, "rb") as file:
            return file.read() == content
    except OSError:
        return False


def _wrong(results, parameters):
    """Returns what is wrong with the results; None if nothing is."""
    for name, value in results.items():
        if not _plan.legal_name(name) or name in parameters:
            return "result name is %s, legal: %s, and no parameter's name" % (_plan.shown(name), _plan.LEGAL_NAME)
        if not isinstance(value, (int, float, str)):
            return "result %s is %s, legal: a number, a text, True or False" % (name, _plan.shown(value))
        if isinstance(value, int) and not -2 ** 63 <= value < 2 ** 63:
            return "result %s is %d, legal: -2**63 to 2**63-1" % (name, value)
    return None


def _forget(known, folder):
    """Unloads modules beside the script, so that the next run imports them again."""
    for name in set(sys.modules) - known:
        file = getattr(sys.modules[name], "__file__", None)
        if file and os.path.dirname(os.path.abspath(file)).startswith(os.path.abspath(folder)):
            del sys.modules[name]


def _settle(threads):
    """Waits for the end of the callback thread."""
    for one in threading.enumerate():
        if threading.active_count() > threads and one.name == "sear callbacks":
            one.join(1)


def main():
    """Sends hello, then answers each request."""
    questions, answers = _streams()
    asked = queue.Queue()
    threading.Thread(target=_listen, args=(questions, asked), name="questions", daemon=True).start()
    try:
        runs = _Runs(sys.argv[1])
        _answer(answers, {"version": _plan.version()})
    except Exception as error:
        _answer(answers, {"problem": "%s: %s" % (type(error).__name__, error)})
        return
    while True:
        task = asked.get()
        _answer(answers, runs.run(task))


if __name__ == "__main__":
    main()
