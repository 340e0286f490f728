# SPDX-License-Identifier: Apache-2.0
"""The command: python3 -m sear.sweeps SCRIPT.py, started by `sear sweep`."""
import argparse
import os
import signal
import sys
import threading

ENDS_WITH_INPUT = "SEAR_ENDS_WITH_INPUT"


class _Parser(argparse.ArgumentParser):
    def error(self, message):
        raise ValueError(message)


def _parser():
    parser = _Parser(prog="sear sweep", allow_abbrev=False, description="Runs a script once for each seed and each combination of parameters: "
                     "sear sweep --help lists the options.")
    parser.add_argument("script")
    for name in ("--seeds", "--workers", "--scheduler", "--scheduler-file", "--limit", "--memory", "--out", "--again"):
        parser.add_argument(name)
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--fresh", action="store_true")
    parser.add_argument("--python3", action="store_true")
    return parser


def _interrupt(number, frame):
    """Interrupts once: writing the finished rows takes time, during which further signals are ignored."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    raise KeyboardInterrupt


def _end_with_input():
    """Interrupts the sweep when standard input is closed, if `sear sweep` asks for it: that process has ended then,
    even by kill -9."""
    if os.environ.pop(ENDS_WITH_INPUT, None) is not None:
        threading.Thread(target=_await_end, name="parent", daemon=True).start()


def _await_end():
    while os.read(0, 4096):
        pass
    os.kill(os.getpid(), signal.SIGTERM)


def _report(text):
    from . import _plan
    try:
        print(_plan.printable(text), file=sys.stderr)
    except OSError:
        pass    # the terminal or the reader of a pipe has gone; the tables have everything


def main(arguments):
    """Returns the exit status."""
    from . import LIMIT, _plan, sweep_script
    folder = None
    try:
        given = _parser().parse_args(arguments)
        grid = {}
        for one in given.set:
            name, values = _plan.values_of(one)
            if name in grid:
                raise ValueError('--set is "%s", legal: each parameter once' % one)
            grid[name] = values
        seeds = _plan.seeds_of("--seeds", "1" if given.seeds is None else given.seeds)
        folder = given.out or os.path.splitext(os.path.basename(given.script))[0] + "-sweep"
        limit = LIMIT if given.limit is None else _plan.positive("--limit", given.limit)
        memory = None if given.memory is None else _plan.positive("--memory", given.memory)
        workers = None if given.workers is None else _plan.whole("--workers", given.workers, 1, 1024)
        signal.signal(signal.SIGINT, _interrupt)
        signal.signal(signal.SIGTERM, _interrupt)
        _end_with_input()
        rows = sweep_script(given.script, grid, seeds, python3=given.python3, workers=workers, scheduler=given.scheduler,
                            scheduler_file=given.scheduler_file, limit=limit, memory=memory, out=folder, fresh=given.fresh, again=given.again)
    except ValueError as error:
        _report("sear sweep: %s" % error)
        return 2
    except (RuntimeError, OSError) as error:
        _report("sear sweep: %s" % error)
        return 1
    except KeyboardInterrupt:
        _report("\nsear sweep: interrupted; the finished rows are in %s, and the same command continues" % folder)
        return 130
    if given.again is not None:
        return 0
    print("%d rows in %s: %s" % (len(rows), folder, _counts(rows)))
    failed = sorted({row["status"] for row in rows} - {"ok"})
    for status in failed:
        first = next(row for row in rows if row["status"] == status)
        _report("%s: row %d: %s" % (status, first["row"], first["message"]))
    return 1 if failed else 0


def _counts(rows):
    counts = {}
    for row in rows:
        counts[row["status"]] = counts.get(row["status"], 0) + 1
    return ", ".join("%d %s" % (counts[status], status) for status in sorted(counts, key=lambda one: (one != "ok", one)))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
