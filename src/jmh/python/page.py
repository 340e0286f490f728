# SPDX-License-Identifier: Apache-2.0
"""Writes the measured part of docs/performance.md, and its curves, from the JSON of a run."""
import os
import re
import textwrap

import bodies
import cameras
import cores
import curves
import goals

BEGIN = "<!-- measured: scripts/benchmark writes from here -->"
END = "<!-- measured: to here -->"
# Share of a core below which rates are in CPU time
QUIET = 0.9
# Smaller shares of a core are not measurable: a short run may take no tick of the processor clock.
LEAST_SHARE = 0.01
PEERS = ("Embree", "MuJoCo", "pybullet", "jbullet")
STEPS_A_SECOND = 60.0
NOTHING = "–"
COLUMNS = 120
AGAIN = {"runs": "start and memory", "script": "what a script sees", "cores": "several cores and many robots"}


def size_of(world):
    return int(world.rsplit("-", 1)[1])


def digits(value, count=3):
    """Formats a number with this many significant digits."""
    if value is None:
        return NOTHING
    text = "%.*g" % (count, value)
    if "e" not in text and value < 1000:
        return text
    if value < 1:
        return "%.*f" % (count + 2, value)
    return "{:,.0f}".format(round(value, min(0, count - len("%.0f" % value)))).replace(",", " ")


def row(cells):
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def table(head, rows):
    return [row(head), "|" + "---|" * len(head)] + [row(cells) for cells in rows] + [""]


def wrapped(text):
    """Returns the lines of a paragraph or list item of Markdown."""
    return textwrap.wrap(text, COLUMNS, subsequent_indent="  " if text.startswith("- ") else "", break_long_words=False, break_on_hyphens=False)


class Results:
    """The results of a run's JSON."""

    def __init__(self, found):
        self.found = found
        self.rates = {(rate["engine"], rate["world"]): rate for rate in found["rates"]}
        self.judged = []
        # Columns of the beam tables
        self.peers = [peer for peer in PEERS if any(engine == peer for engine, _ in self.rates)]

    def is_busy(self, engine, world):
        rate = self.rates.get((engine, world))
        return rate is not None and rate["cpuShare"] < QUIET

    def rate(self, engine, world):
        """Returns units per second, in CPU time if the process had too little of a core; None if not measured."""
        rate = self.rates.get((engine, world))
        if rate is None:
            return None
        return rate["perSecond"] / (max(rate["cpuShare"], LEAST_SHARE) if rate["cpuShare"] < QUIET else 1)

    def shown(self, engine, world, unit):
        """Formats a rate, in units; a star marks CPU time."""
        rate = self.rate(engine, world)
        return NOTHING if rate is None else digits(rate / unit) + ("*" if self.is_busy(engine, world) else "")

    def ratio(self, a, b, world):
        ours = self.rate(a, world)
        theirs = self.rate(b, world)
        return NOTHING if ours is None or theirs is None else "**×%s**" % digits(ours / theirs, 2)

    def worlds(self, prefix):
        return sorted({world for _, world in self.rates if re.match(prefix + r"-\d+$", world)}, key=size_of)

    def judge(self, key, value, more_is_better=True):
        """Returns a goal's cell; records whether the goal is met."""
        goal = goals.GOALS.get(key)
        if goal is None or value is None:
            return NOTHING if goal is None else goals.shown(key)
        met = value >= goal if more_is_better else value <= goal
        self.judged.append((key, value, met))
        return "%s, %s" % (goals.shown(key), "met" if met else "**missed**")


# ---- sections ------------------------------------------------------------------------------------------------------------

def machine(results):
    found = results.found
    about = found["machine"]
    cpu = about["cpu"] + (" at %s MHz" % about["mhz"] if about["mhz"] != "unknown" else "")
    lines = ["Measured on %s: %s, %s cores, %s GiB of memory; %s; %s; Python %s." % (
        found["date"], cpu, about["cores"], about["memoryGiB"], about["system"], about["java"], about["python"]),
             "Each engine had one thread. The run took %.0f minutes." % found["minutes"]]
    if "again" in found:
        lines.append("Measured in a second run, because other programs disturbed the first: %s."
                     % ", ".join(AGAIN[part] for part in found["again"]))
    if "rounds" in found:
        lines.append("In each world the engines went in turns; the tables show the median of %d rounds." % found["rounds"])
    versions = {rate["engine"]: rate["version"] for rate in found["rates"] if "version" in rate}
    lines.append("Engines: SEAR (this commit), jbullet%s."
                 % "".join(", %s %s" % pair for pair in sorted(versions.items())))
    for what, why in sorted(found["missing"].items()):
        lines.append("Not measured: %s %s." % (what, why))
    if any(rate["cpuShare"] < QUIET for rate in found["rates"]):
        lines.append("Numbers with a star are by CPU time, because other programs used the processor (load average %.1f before the run)."
                     % found["loadBefore"])
        lines.append("A JVM then spends much of its time compiling, so SEAR and jbullet look too slow.")
    if found["quick"]:
        lines.append("This was a quick run, which only tests the benchmark: its numbers mean nothing.")
    return [part for line in lines for part in wrapped(line)] + [""]


def beams(results):
    rows = []
    for world in results.worlds("room") + results.worlds("hall") + results.worlds("hills") + results.worlds("field"):
        fan, single = results.rate("SEAR fan", world), results.rate("SEAR single", world)
        rows.append([world] + [results.ratio("SEAR fan", peer, world) for peer in results.peers]
                    + [results.shown("SEAR fan", world, 1e6), results.judge("fan " + world, fan and fan / 1e6),
                       results.shown("SEAR single", world, 1e6), results.judge("single " + world, single and single / 1e6)]
                    + [results.shown(peer, world, 1e6) for peer in results.peers])
    fields = ["- `field-N`: a height field of N grid posts, 6 cm apart; 100 000 posts cover 20 m × 20 m"] if results.worlds("field") else []
    return ["### Beams", "",
            "Millions of beams per second. A fan is a LIDAR scan of 361 beams over 180° with 8 m range, from 100 poses in turn;",
            "single beams are cast one by one. Columns with / show how many times faster SEAR's fan is.", "",
            "- `room-N`: N rotated boxes in a room of 10 m × 10 m",
            "- `hall-N`: N boxes in a hall with 20 boxes per 100 m²",
            "- `hills-N`: N triangles on 20 m × 20 m",
            *fields, ""] + table(
                ["world"] + ["/ " + peer for peer in results.peers] + ["fan", "goal", "single", "goal"] + results.peers, rows)


def agreement(results):
    shown = {}
    beams = max((one["beams"] for one in results.found["agreement"]), default=0)
    for one in results.found["agreement"]:
        shown[one["engine"], one["world"]] = digits(one["over1mm"], 9) + (" of %s" % digits(one["beams"], 9) if one["beams"] < beams else "") + (
            ", worst %.2g m" % one["worst"] if one["over1mm"] else "")
    engines = [engine for engine in ("SEAR single",) + PEERS if any(key[0] == engine for key in shown)]
    worlds = list(dict.fromkeys(one["world"] for one in results.found["agreement"]))
    return ["### Do they measure the same?", "",
            *wrapped("Every engine casts the same %s beams. The table counts those whose distance differs from the fan's by more than 1 mm, or"
                     " that hit in only one of the two." % digits(beams, 9)), ""] + table(
                ["world"] + engines, [[world] + [shown.get((engine, world), NOTHING) for engine in engines] for world in worlds])


def steps(results):
    rows = []
    what = {"drive": "no sensor", "lidar": "a LIDAR", "all": "everything", "camera": "a camera, each picture read",
            "blind": "a camera, no picture read"}
    for equipment in ("drive", "lidar", "camera", "blind", "all"):
        for world in results.worlds(equipment + "-room"):
            rate = results.rate("SEAR", world)
            rows.append(["%s, %d boxes" % (what[equipment], size_of(world)), results.ratio("SEAR", "MuJoCo", world),
                         results.ratio("SEAR", "pybullet", world),
                         results.shown("SEAR", world, STEPS_A_SECOND), results.judge(world, rate and rate / STEPS_A_SECOND),
                         results.shown("MuJoCo", world, STEPS_A_SECOND), results.shown("pybullet", world, STEPS_A_SECOND)])
    growth = results.worlds("lidar-hall")
    lidars = [world for world in ("lidar-room-20", "lidars2-room-20", "lidars4-room-20", "lidars8-room-20") if ("SEAR", world) in results.rates]
    more = [["%d boxes in a hall" % size_of(world), world] for world in growth]
    more += [["%s LIDARs, 20 boxes" % re.sub(r"\D", "", world.split("-")[0]), world] for world in lidars[1:]]
    lines = ["### Steps", "",
             "Simulated seconds per second, at 60 steps per simulated second. A robot with four wheels, two of them driven, drives in",
             "circles among fixed boxes and reads each LIDAR of 361 beams ten times per simulated second. *Everything* adds four",
             "PING))) sensors, GPS, compass, accelerometer, gyroscope, and serial devices that send all the time.", ""]
    lines += table(["sensors", "/ MuJoCo", "/ pybullet", "SEAR", "goal", "MuJoCo", "pybullet"], rows)
    if more:
        lines += ["With one LIDAR in growing halls, and with several LIDARs:", ""]
        lines += table(["what", "/ MuJoCo", "/ pybullet", "SEAR", "MuJoCo", "pybullet"],
                       [[name, results.ratio("SEAR", "MuJoCo", world), results.ratio("SEAR", "pybullet", world)]
                        + [results.shown(engine, world, STEPS_A_SECOND) for engine in ("SEAR", "MuJoCo", "pybullet")] for name, world in more])
    return lines


def moving(results):
    worlds = results.worlds("drop")
    engines = ("SEAR", "MuJoCo", "pybullet")
    rows = [[size_of(world), results.ratio("SEAR", "MuJoCo", world), results.ratio("SEAR", "pybullet", world)]
            + [digits(1e6 / results.rate(engine, world)) if results.rate(engine, world) else NOTHING for engine in engines] for world in worlds]
    lines = ["### Moving bodies", "",
             "Microseconds per step. Boxes of 20 kg fall from about a metre onto a floor and tumble. The first 1.25 simulated seconds",
             "count, in which no engine lets a body sleep.", ""]
    lines += table(["boxes", "/ MuJoCo", "/ pybullet", "SEAR", "MuJoCo", "pybullet"], rows)
    asleep = [digits(1e6 / results.rate("SEAR", world)) + " µs per step for %d bodies" % size_of(world) for world in results.worlds("asleep")]
    if asleep:
        lines += ["When all bodies sleep, SEAR takes %s." % ", ".join(asleep), ""]
    heights = ["%s %.3f m" % (one["engine"], one["meanHeight"]) for one in results.found["outcomes"] if worlds and one["world"] == worlds[-1]]
    ways = ["%s %.2f m" % (one["engine"], one["way"]) for one in results.found["outcomes"] if one["world"] == "drive-room-20"]
    if heights:
        lines += wrapped("The physics agree. Mean height of the centres of %d boxes after 3 s: %s." % (size_of(worlds[-1]), ", ".join(heights)))
    if ways:
        lines += wrapped("Distance of the robot above in 20 simulated seconds at 0.4 m/s: %s." % ", ".join(ways))
    return lines + [""]


def resting(results):
    """Returns the section of bodies that end at rest; empty if not measured."""
    found = results.found.get("bodies")
    if not found:
        return []
    return ["### Bodies that end at rest", "",
            "Cubes of 0.1 to 0.3 m fall separately (`single-`) or onto one pile (`pile-`); dominoes; a stack. All have 1 kg and",
            "friction 0.64. Runs take 10 simulated seconds (piles 15) at 1/60 s, with the defaults of Bullet and MuJoCo. Brackets",
            "mark speeds that do not count: the final overlap reaches 1 mm, or a body moves 0.1 mm in the last half second.", ""] + bodies.table(found) + [""]


def seen(results):
    """Returns the section of camera pictures; empty if not measured."""
    found = results.found.get("cameras")
    if not found:
        return []
    return ["### Pictures of cameras", "", *cameras.ABOUT, ""] + cameras.table(found) + [""]


def fleets(results):
    """Returns the section of several cores and many robots; empty if not measured."""
    found = results.found.get("cores")
    if not found:
        return []
    return ["### Several cores, many robots", ""] + cores.table(found) + [""]


def meshes(results):
    rows = []
    for mesh in results.found["meshes"]:
        million = mesh["triangles"] >= 1e6
        peers = []
        for peer in ("MuJoCo", "pybullet"):
            found = [rate for (engine, world), rate in results.rates.items()
                     if engine == peer and world.startswith("hills") and abs(size_of(world) / mesh["triangles"] - 1) < 0.1]
            # Other memory hides the size of a small model
            size = ", %s bytes" % digits(found[0]["bytes"] / mesh["triangles"]) if found and mesh["triangles"] > 1e5 else ""
            peers.append(digits(found[0]["buildCpu"]) + " s" + size if found else NOTHING)
        first = mesh["first"] if mesh["firstCpu"] > QUIET * mesh["first"] else mesh["firstCpu"]
        star = "*" if first != mesh["first"] else ""
        total = mesh["bytes"] + mesh["modelBytes"]
        rows.append([digits(mesh["triangles"], 9), digits(first) + star, results.judge("mesh seconds", first, False) if million else NOTHING,
                     digits(mesh["medianCpu"]), digits(total), results.judge("mesh bytes", total, False) if million else NOTHING,
                     digits(mesh["jbulletCpu"]) + " s"] + peers)
    return ["### Building the hierarchy of a model", "",
            "Seconds until the first beam: in a fresh JVM, and as CPU time in a warm one. Bytes per triangle include vertices and",
            "indices. Other engines: CPU time and process growth while loading the same model.", ""] + table(
                ["triangles", "seconds, first time", "goal", "seconds, warm", "bytes per triangle", "goal", "jbullet", "MuJoCo", "pybullet"], rows)


def start(results):
    rows = []
    mebi = 1024.0 ** 2
    for world, run in sorted(results.found["runs"].items(), key=lambda one: size_of(one[0])):
        busy = run["toReadingCpu"] < QUIET * run["toReading"] and results.is_busy("SEAR", world)
        seconds = run["toReadingCpu"] if busy else run["toReading"]
        rows.append(["core only, all sensors, %d boxes: from opening to the first LIDAR reading" % size_of(world),
                     digits(seconds) + " s" + ("*" if busy else ""), results.judge("start", seconds, False)])
        rows.append(["peak memory with JVM over 60 simulated seconds", digits(run["peakResident"] / mebi) + " MiB",
                     results.judge("memory", run["peakResident"] / mebi, False)])
        rows.append(["of it, heap objects at the end", digits(run["heap"] / mebi) + " MiB", NOTHING])
    script = results.found["script"]
    if script:
        busy = any(rate["cpuShare"] < QUIET for rate in results.found["rates"] if rate["engine"] == "SEAR")
        seconds = script["toReadingCpu"] if busy else script["toReading"]
        rows.append(["in the embedded MyRobotLab: `sear.startSimulation()` to the first LIDAR reading",
                     digits(seconds) + " s" + ("*" if busy else ""), results.judge("start", seconds, False)])
        rows.append(["from the command `sear SCRIPT.py` to that reading",
                     digits(script["launchToReading"]) + " s", results.judge("launch", script["launchToReading"], False)])
        rows.append(["its peak memory", digits(script["peakResident"] / mebi) + " MiB", NOTHING])
        rows.append(["`sear.getLidarResult(name)` in real time: median (longest of %d)" % script["call"]["count"],
                     "%s ms (%s ms)" % (digits(1e3 * script["call"]["median"]), digits(1e3 * script["call"]["max"])), NOTHING])
        for baud in (38400, 500000):
            scan = script["scan%d" % baud]
            wire = 10.0 * (2 * script["values"] + 10) / baud
            rows.append(["`lidar.singleScan()` to `publishLidarData` in real time at %d baud, including %.0f ms for the telegram on the wire" % (
                baud, 1e3 * wire), "%s ms (%s ms)" % (digits(1e3 * scan["median"]), digits(1e3 * scan["max"])), NOTHING])
    return ["### Start, memory, latency", ""] + table(["what", "measured", "goal"], rows)


def reference(results):
    """Returns the speed of the goals' machine relative to this one, for each engine measured on both."""
    return sorted(1e6 * made / results.rate(engine, world) for (engine, world), made in goals.REFERENCE.items() if results.rate(engine, world))


def missed(results):
    lines = []
    faster = reference(results)
    machine = faster[(len(faster) - 1) // 2] if faster else 0
    for key, value, met in results.judged:
        if not met:
            there = ", about %s there" % digits(machine * value) if machine and key not in goals.UNITS else ""
            lines.append("- %s: %s%s, goal %s. %s" % (goals.name(key), digits(value), there, goals.shown(key), goals.reason(key)))
    lines = list(dict.fromkeys(line.strip() for line in lines))
    count = len(results.judged)
    head = "%d of %d goals are met." % (sum(met for _, _, met in results.judged), count)
    if faster:
        head += " On the goals' machine the other engines are %s times as fast (median of %d measurements)." % (digits(machine), len(faster))
    listed = [part for line in lines for part in wrapped(line)]
    return ["### Goals", ""] + wrapped(head + (" Missed goals:" if lines else "")) + ([""] + listed if lines else []) + [""]


def summary(results):
    """Returns how many times faster SEAR is, in the worlds with goals."""
    rows = []
    for label, engine, worlds in (("LIDAR fan", "SEAR fan", ("room-20", "room-100", "room-1000", "hills-110000")),
                                  ("a robot with a LIDAR", "SEAR", ("lidar-room-20", "lidar-room-1000")),
                                  ("bodies that all move", "SEAR", ("drop-10", "drop-100", "drop-1000"))):
        for world in worlds:
            if (engine, world) in results.rates:
                rows.append(["%s, %s" % (label, world)] + [results.ratio(engine, peer, world) for peer in results.peers])
    return ["### At a glance", "", "How many times faster SEAR is (below 1: slower):", ""] + table(
        ["what"] + ["than " + peer for peer in results.peers], rows)


# ---- pictures ------------------------------------------------------------------------------------------------------------

def pictures(results):
    """Returns {file name: (alternative text, SVG)}."""
    def series(engines, worlds, value, x=size_of):
        made = []
        for engine in engines:
            points = [(x(world), value(results.rate(engine, world))) for world in worlds if results.rate(engine, world)]
            if points:
                made.append((engine, points))
        return made

    casters = ("SEAR fan", "SEAR single") + PEERS
    steppers = ("SEAR", "MuJoCo", "pybullet")
    lidars = ["lidar-room-20"] + sorted({world for _, world in results.rates if re.match(r"lidars\d+-room-20$", world)}, key=lidar_count)
    wanted = (
        ("speed-boxes.svg", "Cost of a beam by the number of boxes", "boxes (20 on 100 m²)", "ns a beam",
         series(casters, results.worlds("hall"), lambda rate: 1e9 / rate)),
        ("speed-triangles.svg", "Cost of a beam by the number of triangles", "triangles", "ns a beam",
         series(casters, results.worlds("hills"), lambda rate: 1e9 / rate)),
        ("speed-moving.svg", "Cost of a step by the number of moving bodies", "moving boxes", "µs a step",
         series(steppers, results.worlds("drop"), lambda rate: 1e6 / rate)),
        ("speed-steps.svg", "Speed of a robot with a LIDAR by the number of fixed boxes", "fixed boxes (20 on 100 m²)", "simulated seconds a second",
         series(steppers, results.worlds("lidar-hall"), lambda rate: rate / STEPS_A_SECOND)),
        ("speed-lidars.svg", "Speed of a robot by the number of its LIDARs", "LIDARs, 361 beams, 10 Hz each", "simulated seconds a second",
         series(steppers, lidars, lambda rate: rate / STEPS_A_SECOND, lidar_count)),
    )
    return {name: (title, curves.draw(title, x, y, lines)) for name, title, x, y, lines in wanted if lines}


def lidar_count(world):
    return int(re.sub(r"\D", "", world.split("-")[0]) or 1)


def growth(results):
    """Returns the cost of a thousandfold size as text."""
    lines = []
    for label, prefix in (("boxes", "hall"), ("triangles", "hills")):
        worlds = results.worlds(prefix)
        if len(worlds) < 2 or not all(results.rate("SEAR fan", world) for world in worlds):
            continue
        low, high = worlds[0], worlds[-1]
        parts = ["%s ×%s" % (engine, digits(results.rate(engine, low) / results.rate(engine, high), 2))
                 for engine in ("SEAR fan", "SEAR single") + PEERS
                 if results.rate(engine, low) and results.rate(engine, high)]
        lines.append("Growth of the cost of a beam from %s to %s %s: %s." % (digits(size_of(low), 9), digits(size_of(high), 9), label, ", ".join(parts)))
    return [part for line in lines for part in wrapped(line)] + [""] if lines else []


def measured(results, drawn):
    shown = {name: ["![%s](images/%s)" % (title, name), ""] for name, (title, _) in drawn.items()}
    body = beams(results) + shown.get("speed-boxes.svg", []) + shown.get("speed-triangles.svg", []) + growth(results) + agreement(results)
    body += steps(results) + shown.get("speed-steps.svg", []) + shown.get("speed-lidars.svg", [])
    body += fleets(results) + moving(results) + shown.get("speed-moving.svg", []) + resting(results) + seen(results) + meshes(results) + start(results)
    return machine(results) + summary(results) + missed(results) + body


def write(found, template, docs):
    """Writes performance.md (the template with a new measured part) and images into docs; returns the measured lines."""
    results = Results(found)
    drawn = pictures(results)
    os.makedirs(os.path.join(docs, "images"), exist_ok=True)
    for name, (_, svg) in drawn.items():
        with open(os.path.join(docs, "images", name), "w", encoding="utf-8") as out:
            out.write(svg)
    lines = measured(results, drawn)
    with open(template, encoding="utf-8") as file:
        text = file.read()
    if text.count(BEGIN) != 1 or text.count(END) != 1:
        raise SystemExit("%s: the lines \"%s\" and \"%s\" have to be there once each; the measured part goes between them" % (template, BEGIN, END))
    before, rest = text.split(BEGIN)
    with open(os.path.join(docs, "performance.md"), "w", encoding="utf-8") as out:
        out.write(before + BEGIN + "\n\n" + "\n".join(lines) + END + rest.split(END)[1])
    return lines
