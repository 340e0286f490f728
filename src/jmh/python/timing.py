# SPDX-License-Identifier: Apache-2.0
"""Measures the other engines, each in the same way: wall time, and the process's share of a core."""
import resource
import time

KIB = 1024


def rate(run, units, seconds, prepare=None):
    """Measures how often per second run() does one of its units, for some seconds; prepare() runs before each, uncounted.

    Returns (rate, share): share of a core of the process; rate / share is the rate per second of CPU time.
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
    """Returns the result of run(), and {"wall", "cpu"}: its seconds."""
    cpu_from = time.process_time()
    wall_from = time.perf_counter()
    answer = run()
    return answer, {"wall": time.perf_counter() - wall_from, "cpu": time.process_time() - cpu_from}


def peak_resident():
    """Returns the peak memory of the process, bytes."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * KIB


def resident():
    """Returns the present memory of the process, bytes."""
    with open("/proc/self/statm") as statm:
        return int(statm.read().split()[1]) * resource.getpagesize()
