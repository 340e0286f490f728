"""throughput.py ROWS TURNS [SIMULATED]: the same runs by a sweep on two workers, and by two processes without Dask, in turns.

Excludes the start on both sides: the measurement begins when Java runs and the first runs are done.
"""
import statistics
import subprocess
import sys
import time

import psutil

SIMULATED = 30
WARM = 200         # runs before the measurement: both processes are busy, and Java has compiled most code


def spent(process):
    """Returns the processor time of a process and its children, seconds."""
    total = 0
    for one in [process] + process.children(recursive=True):
        try:
            times = one.cpu_times()
            total += times.user + times.system
        except psutil.NoSuchProcess:
            pass
    return total


def by_hand(seeds, seconds):
    """Runs in its own process: waits for a line between start and runs."""
    import sear
    from maze import chance
    sear.start(headless=True, speed="max", threads=1)
    for seed in range(-WARM // 2, 0):
        chance(-seed, seconds)
    print("ready", flush=True)
    sys.stdin.readline()
    for seed in seeds:
        chance(seed, seconds)
    print("done", flush=True)
    sys.stdin.readline()


def two_by_hand(rows, seconds):
    """Returns the runs per second of two such processes, and the processor time per run, seconds."""
    half = rows // 2
    both = [subprocess.Popen([sys.executable, __file__, "by-hand", str(first), str(half), str(seconds)], stdin=subprocess.PIPE,
                             stdout=subprocess.PIPE, text=True) for first in (1, half + 1)]
    for one in both:
        one.stdout.readline()
    before = sum(spent(psutil.Process(one.pid)) for one in both)
    begun = time.perf_counter()
    for one in both:
        one.stdin.write("\n")
        one.stdin.flush()
    for one in both:
        one.stdout.readline()
    lasted = time.perf_counter() - begun
    after = sum(spent(psutil.Process(one.pid)) for one in both)
    for one in both:
        one.communicate("\n")
    return 2 * half / lasted, (after - before) / (2 * half)


def swept(rows, seconds):
    """Returns the same for a sweep, measured after as many warm-up runs as in the other processes."""
    import sear
    from maze import chance
    from sear.sweeps import _Sweep
    marks = []
    told = _Sweep._progress

    def noted(self, done, before, begun):
        if len(done) >= WARM and not marks or len(done) == len(self._rows):
            marks.append((len(done), time.perf_counter(), spent(psutil.Process())))
        told(self, done, before, begun)

    _Sweep._progress = noted
    sear.sweep(chance, {"seconds": [seconds]}, seeds=rows + WARM, workers=2, quiet=True)
    _Sweep._progress = told
    (first, begun, before), (last, ended, after) = marks
    return (last - first) / (ended - begun), (after - before) / (last - first)


def main(rows, turns, seconds):
    """Prints both, and their ratio."""
    import sear.gym
    dealt, alone = [], []
    for turn in range(turns):
        for kind, run in ((dealt, swept), (alone, two_by_hand))[::1 if turn % 2 else -1]:
            kind.append(run(rows, seconds))
        print("turn %d: by a sweep %.1f runs per second, %.1f ms of processor time each, by hand %.1f, %.1f ms"
              % (turn + 1, dealt[-1][0], 1000 * dealt[-1][1], alone[-1][0], 1000 * alone[-1][1]), flush=True)
    medians = [statistics.median(one[at] for one in kind) for at in (0, 1) for kind in (dealt, alone)]
    print("median: %.1f runs per second by a sweep, %.1f by hand, ratio %.3f" % (medians[0], medians[1], medians[0] / medians[1]))
    print("median: %.1f ms of processor time by a sweep, %.1f by hand, ratio %.3f" % (1000 * medians[2], 1000 * medians[3], medians[2] / medians[3]))


if __name__ == "__main__":
    if sys.argv[1] == "by-hand":
        first = int(sys.argv[2])
        by_hand(range(first, first + int(sys.argv[3])), int(sys.argv[4]))
    else:
        main(int(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]) if len(sys.argv) > 3 else SIMULATED)
