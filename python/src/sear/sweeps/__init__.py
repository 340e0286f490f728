# SPDX-License-Identifier: Apache-2.0
"""Many runs of a function or a script, on many processes or computers, with Dask Distributed: docs/sweeps.md."""
import hashlib
import importlib.util
import inspect
import os
import sys
import time

from . import _plan
from ._folder import Folder, columns, flat, lines

LIMIT = 600
NEEDED = {"distributed": "distributed", "pyarrow": "pyarrow", "jpype": "JPype1", "numpy": "numpy"}
TERMINAL_SECONDS = 0.5
FILE_SECONDS = 30


def sweep(function, grid=None, seeds=1, *, workers=None, scheduler=None, scheduler_file=None, limit=LIMIT, memory=None, out=None, fresh=False,
          again=None, quiet=False):
    """Calls a function once for each seed and each combination of values: function(seed=7, speed=0.1).

    function: returns a dictionary of results (numbers, texts, True, False), a single result, or None.
    grid: names of parameters and their values, for example {"speed": [0.1, 0.2]}.
    seeds: a number of seeds, counted from 1, or a list of them.
    workers: number of processes on this computer. Default: its number of processors.
    scheduler, scheduler_file: the address of a running Dask scheduler, or the file with it.
    limit: seconds after which a run is aborted.
    memory: MB above which a run's process is aborted; None: no limit.
    out: a folder for rows.csv and rows.parquet, in which an interrupted sweep continues. None: writes nothing.
    fresh: whether to delete existing rows and start over.
    again: number of a row of the sweep in the folder: reruns and returns only that row.
    quiet: whether to print no progress.

    Returns the rows as dictionaries, in the order of their numbers. Raises ValueError for illegal arguments, RuntimeError
    if runs are impossible, or if a repeated row differs.
    """
    if not callable(function):
        raise ValueError("function is %r, legal: a function of seed and parameters" % (function,))
    checked = _plan.checked_grid(grid)
    try:
        inspect.signature(function).bind(seed=0, **{name: None for name, _ in checked})
    except TypeError as error:
        names = ", ".join(["seed"] + [name for name, _ in checked])
        raise ValueError("function %s can't be called with %s: %s" % (_name(function), names, error)) from None
    _missing(("distributed", "jpype", "numpy") + (("pyarrow",) if out is not None else ()))
    import cloudpickle
    plan = {"kind": "function", "name": _name(function), "digest": _digest(function)}
    return _Sweep(plan, cloudpickle.dumps(function), "", checked, _plan.seeds_of("seeds", seeds), limit, memory, out, quiet).run(
        workers, scheduler, scheduler_file, fresh, again)


def sweep_script(script, grid, seeds, *, python3=False, workers=None, scheduler=None, scheduler_file=None, limit=LIMIT, memory=None, out=None,
                 fresh=False, again=None):
    """Sweeps a script, which reads its parameters with sear.getParameter and reports results with sear.setResult."""
    try:
        with open(script, "rb") as file:
            source = file.read()
    except OSError as error:
        raise ValueError("script %s can't be read: %s" % (script, error.strerror)) from None
    _missing(tuple(NEEDED))
    is_python3 = python3 or source[:3].strip(b"\xef\xbb\xbf#!") != source[:3] and b"python3" in source.split(b"\n", 1)[0]
    plan = {"kind": "python3" if is_python3 else "jython", "name": os.path.basename(script), "digest": hashlib.sha256(source).hexdigest()}
    return _Sweep(plan, source, os.path.abspath(script), _plan.checked_grid(grid), seeds, limit, memory, out, False).run(
        workers, scheduler, scheduler_file, fresh, again)


def _missing(modules):
    lacking = [NEEDED[one] for one in modules if importlib.util.find_spec(one) is None]
    if lacking:
        raise RuntimeError("this Python (%s) lacks %s: %s -m pip install %s" % (sys.executable, " and ".join(lacking), sys.executable,
                                                                               " ".join(lacking)))


def _name(function):
    return getattr(function, "__qualname__", type(function).__name__)


def _digest(function):
    """Returns the digest of the function's file, else of its source, else of its code."""
    try:
        with open(inspect.getsourcefile(function), "rb") as file:
            return hashlib.sha256(file.read()).hexdigest()
    except (OSError, TypeError):
        pass
    try:
        return hashlib.sha256(inspect.getsource(function).encode("utf-8")).hexdigest()
    except (OSError, TypeError):
        return hashlib.sha256(getattr(getattr(function, "__code__", None), "co_code", b"")).hexdigest()


class _Sweep:
    """One sweep."""

    def __init__(self, plan, payload, path, grid, seeds, limit, memory, out, quiet):
        self._rows = _plan.Rows(seeds, grid)
        self._limit = _plan.positive("limit", limit)
        self._memory = None if memory is None else _plan.positive("memory", memory)
        self._plan = {**plan, "version": _plan.version(), "seeds": seeds, "grid": grid, "limit": self._limit, "memory": self._memory}
        self._payload = payload
        self._path = path
        self._folder = None if out is None else Folder(os.fspath(out))
        self._quiet = quiet
        self._told = 0
        self._first = True
        self._width = 0

    def _common(self):
        """Returns the data common to all runs."""
        return {"kind": self._plan["kind"], "digest": self._plan["digest"], "version": self._plan["version"], "payload": self._payload,
                "path": self._path, "folder": os.getcwd(), "limit": self._limit, "memory": self._memory,
                "imports": os.path.abspath(sys.path[0] or "."), "modules": [one for one in ("sear.gym",) if one in sys.modules]}

    def _part(self, row):
        """Returns the data of one run."""
        seed, parameters = self._rows[row]
        return {"row": row, "seed": seed, "parameters": parameters}

    def _row(self, part, answer):
        return {**part, "results": answer["results"], "status": answer["status"], "message": answer["message"], "version": self._plan["version"],
                "digest": self._plan["digest"]}

    def run(self, workers, scheduler, scheduler_file, fresh, again):
        """Performs all missing runs. Returns the rows."""
        if scheduler is not None and scheduler_file is not None:
            raise ValueError("scheduler is %s and scheduler_file %s, legal: one of them" % (scheduler, scheduler_file))
        if scheduler_file is not None and not os.path.isfile(scheduler_file):
            raise ValueError("scheduler_file is %s, legal: a file that a Dask scheduler has written" % scheduler_file)
        if workers is not None and (scheduler or scheduler_file):
            raise ValueError("workers is %s with a scheduler, legal: one of them; a scheduler has its own workers" % workers)
        number = _plan.whole("workers", os.cpu_count() or 1 if workers is None else workers, 1, 1024)
        if again is not None:
            return self._again(again)
        done = {}
        if self._folder is not None:
            if fresh:
                self._folder.forget()
            done = self._folder.begin(self._plan)
        missing = [row for row in range(len(self._rows)) if row not in done]
        try:
            if missing:
                self._deal(missing, done, number, scheduler, scheduler_file)
            elif not self._quiet:
                self._tell("all %d rows exist already" % len(done))
        finally:
            rows = [done[row] for row in sorted(done)]
            if self._folder is not None:
                self._folder.tables(rows)
                self._folder.close()
        names = columns(rows)
        return [flat(one, names) for one in rows]

    def _deal(self, missing, done, number, scheduler, scheduler_file):
        from . import _deal
        before = len(done)
        begun = []

        def took(answers):
            made = [self._row(part, answer) for part, answer in answers]
            done.update((one["row"], one) for one in made)
            if self._folder is not None:
                self._folder.add(made)
            self._progress(done, before, begun)
            self._unasked(answers)

        with _deal.connected(number, scheduler, scheduler_file, self._tell) as client:
            begun.append(time.monotonic())
            if before:
                self._tell("%d of %d rows exist already" % (before, len(self._rows)))
            _deal.deal(client, self._common(), (self._part(row) for row in missing), took)

    def _unasked(self, answers):
        """Warns once, after the first successful run, of parameters that the script did not read, for example misspelt
        ones."""
        first = next(((part, answer) for part, answer in answers if answer["status"] == "ok"), None)
        if not self._first or first is None:
            return
        self._first = False
        part, answer = first
        for name in answer.get("unasked", ()):
            self._tell("row %d has not used parameter %s: does the script pass this name to sear.getParameter?" % (part["row"], name))

    def _tell(self, text):
        if not self._quiet:
            print(_plan.printable("sear sweep: " + text), file=sys.stderr, flush=True)

    def _progress(self, done, before, begun):
        """Prints the progress from time to time, and at the end."""
        terminal = sys.stderr.isatty()
        now = time.monotonic()
        ended = len(done) == len(self._rows)
        if self._quiet or not ended and now - self._told < (TERMINAL_SECONDS if terminal else FILE_SECONDS):
            return
        self._told = now
        rate = (len(done) - before) / max(now - begun[0], 1e-9)
        bad = sum(one["status"] != "ok" for one in done.values())
        text = "sear sweep: %d of %d rows, %d not ok, %.1f per second%s" % (
            len(done), len(self._rows), bad, rate, "" if ended else ", %.0f s left" % ((len(self._rows) - len(done)) / rate))
        self._width = max(self._width, len(text))
        print(("\r" if terminal else "") + text.ljust(self._width if terminal else 0), end="" if terminal and not ended else "\n", file=sys.stderr,
              flush=True)

    def _again(self, row):
        """Reruns one row in a local child process, without Dask."""
        there = None if self._folder is None else self._folder.plan()
        if there is None:
            raise ValueError("row %s can't be run again: %s; legal: a folder with the rows of this sweep"
                             % (row, "no folder is given" if self._folder is None else "%s has no sweep" % self._folder.path))
        if (there["kind"], there["digest"]) != (self._plan["kind"], self._plan["digest"]):
            raise ValueError("row %s can't be run again: %s differs from that of the sweep (SHA-256 %s now, %s then)"
                             % (row, self._plan["name"], self._plan["digest"][:8], there["digest"][:8]))
        self._rows = _plan.Rows(there["seeds"], there["grid"])
        number = _plan.whole("row", row, 0, len(self._rows) - 1)
        old = self._folder.rows().get(number)
        if old is None:
            raise ValueError("row %d can't be run again: it has not been run yet" % number)
        from . import _worker
        self._limit, self._memory = there["limit"], there["memory"]
        answer = _worker.run({**self._common(), **self._part(number), "output": True})
        _worker.close()
        print(_plan.printable(answer.pop("output")), end="", file=sys.stderr)
        new = self._row(self._part(number), answer)
        if old["version"] != new["version"]:
            self._tell("the row is from SEAR %s, this is %s" % (old["version"], new["version"]))
            new["version"] = old["version"]
        names = columns([old, new])
        if lines([old]) != lines([new]):
            other = ["%s was %s and is %s" % (name, _plan.shown(flat(old, names)[name]), _plan.shown(flat(new, names)[name])) for name in names
                     if repr(flat(old, names)[name]) != repr(flat(new, names)[name])]
            raise RuntimeError("row %d differs: %s" % (number, "; ".join(other) or "its results are in another order"))
        self._tell("row %d is identical to the byte" % number)
        return flat(new, names)
