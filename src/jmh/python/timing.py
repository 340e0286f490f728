"""Times what other engines do, the same way for each: wall time, and the share of a core that the process had meanwhile."""
import resource
import time

KIB = 1024


def rate(run, units, seconds, prepare=None):
    """How often a second run() does one of its units, for so many seconds; prepare() runs before each and is not counted.

    Answers (rate, share): the share of a core that the process had; the rate divided by it is the rate per second of CPU time.
    """
    done = 0
    cpu = 0.0
    wall = 0.0
    began = time.perf_counter()
    while done == 0 or time.perf_counter() - began < seconds:
        if prepare:
            prepare()
        cpu_from = time.process_time()
        wall_from = time.perf_counter()
        run()
        wall += time.perf_counter() - wall_from
        cpu += time.process_time() - cpu_from
        done += units
    return done / wall, cpu / wall


def once(run):
    """What run() answers, and {"wall", "cpu"}: its seconds."""
    cpu_from = time.process_time()
    wall_from = time.perf_counter()
    answer = run()
    return answer, {"wall": time.perf_counter() - wall_from, "cpu": time.process_time() - cpu_from}


def peak_resident():
    """The most memory the process ever had, bytes."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * KIB


def resident():
    """The memory the process has now, bytes."""
    with open("/proc/self/statm") as statm:
        return int(statm.read().split()[1]) * resource.getpagesize()
