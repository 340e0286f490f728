# SPDX-License-Identifier: Apache-2.0
"""Tables of several cores and many robots, which org.SEAR.benchmark.Cores measures."""
GOALS = {"speedup": 1.7, "growth": 1.3, "realtime": 1}
FLEETS = ["1x1", "10x1", "50x1", "1x0", "50x0", "200x0"]
QUICK_FLEETS = ["1x1", "3x1", "3x0"]
STEPS_A_SECOND = 60
ABOUT = ["Eight LIDARs of 361 beams on one robot are due in the same step, among 20 boxes on 100 m². Median microseconds until all",
         "are read. *With noise* each beam has an error of its own.", ""]
ABOUT_FLEETS = ["Robots drive in circles, each among 20 fixed boxes on 100 m². All LIDARs are read in the same step, ten times per",
                "simulated second. Microseconds are processor time on one thread, speeds are by the clock; medians.", ""]


def measure(run, quick):
    """Measures; returns the path of the results."""
    run.say("several cores and many robots")
    target = run.path("cores.json")
    run.call_java("Cores", target, *((1, 60, *QUICK_FLEETS) if quick else (30, 6000, *FLEETS)))
    return target


def verdict(value, goal, more=True):
    return "%.2g, %s" % (goal, "met" if (value >= goal if more else value <= goal) else "**missed**")


def row(cells):
    return "| %s |" % " | ".join(cells)


def lidar_rows(found):
    lines = [row(["8 LIDARs", "one thread, µs", "two threads, µs", "faster", "goal"]), "|---|---|---|---|---|"]
    for one in found:
        if "lidars" in one:
            lines.append(row(["with noise" if one["noise"] else "without noise", "%.3g" % one["one"], "%.3g" % one["two"], "×%.3g" % one["ratio"],
                              verdict(one["ratio"], GOALS["speedup"])]))
    return lines


def fleet_rows(found):
    lines = [row(["robots", "LIDARs of each", "µs per step and robot", "relative to one robot", "goal", "times real time, one thread", "two threads", "goal"]),
             "|---|---|---|---|---|---|---|---|"]
    fleets = [one for one in found if "fleet" in one]
    alone = {one["fleet"].partition("x")[2]: one["cpu"] for one in fleets if one["robots"] == 1}
    for one in fleets:
        lidars = one["fleet"].partition("x")[2]
        each = one["cpu"] / one["robots"]
        growth = each / alone[lidars] if one["robots"] > 1 and lidars in alone else None
        real = [1e6 / STEPS_A_SECOND / one[threads] for threads in ("one", "two")]
        lines.append(row([str(one["robots"]), lidars, "%.3g" % each, "–" if growth is None else "×%.3g" % growth,
                          "–" if growth is None or one["robots"] > 50 else verdict(growth, GOALS["growth"], False),
                          "%.3g" % real[0], "%.3g" % real[1], verdict(real[1], GOALS["realtime"])]))
    return lines


def table(found):
    """Returns the lines of both tables in Markdown."""
    return ABOUT + lidar_rows(found) + [""] + ABOUT_FLEETS + fleet_rows(found)
