"""throughput.py ROWS TURNS [SIMULATED]: the same runs by a sweep on two workers, and by two processes by hand, in turns.

The time of starting is left out on both sides: of a sweep, what the first rows wait for; by hand, until Java runs and one run was made.
"""
import statistics
import subprocess
import sys
import time

SIMULATED = 30


def by_hand(seeds, seconds):
    """In a process of its own: waits for a line between starting and running."""
    import sear
    from maze import chance
    sear.start(headless=True, speed="max", threads=1)
    chance(0, seconds)
    print("ready", flush=True)
    sys.stdin.readline()
    for seed in seeds:
        chance(seed, seconds)
    print("done", flush=True)


def two_by_hand(rows, seconds):
    """Runs a second of two such processes."""
    half = rows // 2
    both = [subprocess.Popen([sys.executable, __file__, "by-hand", str(first), str(half), str(seconds)], stdin=subprocess.PIPE,
                             stdout=subprocess.PIPE, text=True) for first in (1, half + 1)]
    for one in both:
        one.stdout.readline()
    begun = time.perf_counter()
    for one in both:
        one.stdin.write("\n")
        one.stdin.flush()
    for one in both:
        one.stdout.readline()
    lasted = time.perf_counter() - begun
    for one in both:
        one.wait()
    return 2 * half / lasted


def swept(rows, seconds):
    """Runs a second of a sweep, counted from where each of the two workers has made a run."""
    from maze import chance
    from sear.sweeps import _Sweep
    times = []
    took = _Sweep._progress

    def noted(self, done, before, begun):
        times.append((len(done), time.perf_counter()))
        took(self, done, before, begun)

    _Sweep._progress = noted
    import sear
    sear.sweep(chance, {"seconds": [seconds]}, seeds=rows, workers=2, quiet=True)
    _Sweep._progress = took
    number, begun = next((number, at) for number, at in times if number >= rows * 0.05)
    return (times[-1][0] - number) / (times[-1][1] - begun)


def main(rows, turns, seconds):
    """Prints both, and their share."""
    import sear.gym
    dealt, alone = [], []
    for turn in range(turns):
        for kind, run in ((dealt, swept), (alone, two_by_hand))[::1 if turn % 2 else -1]:
            kind.append(run(rows, seconds))
        print("turn %d: by a sweep %.1f runs a second, by hand %.1f" % (turn + 1, dealt[-1], alone[-1]), flush=True)
    print("median: %.1f by a sweep, %.1f by hand, %.3f of it" % (statistics.median(dealt), statistics.median(alone),
                                                               statistics.median(dealt) / statistics.median(alone)))


if __name__ == "__main__":
    if sys.argv[1] == "by-hand":
        first = int(sys.argv[2])
        by_hand(range(first, first + int(sys.argv[3])), int(sys.argv[4]))
    else:
        main(int(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]) if len(sys.argv) > 3 else SIMULATED)
