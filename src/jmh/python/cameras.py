# SPDX-License-Identifier: Apache-2.0
"""Camera pictures: the same worlds from the same places in SEAR and in the software renderers of MuJoCo and pybullet, in
turns in one run."""
import array
import os
import statistics

from program import Program

WORLDS = ["room-20", "sensors"]
OWN_WORLDS = ["mountain"]
ENGINES = {"sear": "SEAR", "mujoco": "MuJoCo", "mujoco-fast": "MuJoCo, reduced", "pybullet": "pybullet"}
KINDS = {"colors": "colours", "depths": "depths"}
# Pictures per second and core
GOALS = {"colors": 30, "depths": 60}
# Relative tolerance of equal depths, and the maximum depth of the other engines
SAME = 0.01
COMPARED = 90
ROUNDS = 5
ABOUT = ["Pictures of 320 x 240 pixels with 60° field of view from the same places, on one thread. Rates are the median of five",
         "rounds, with least and greatest in brackets. All engines draw the same textured scene with one sun and shadows. MuJoCo",
         "uses Mesa's llvmpipe (EGL, `LP_NUM_THREADS=0`) with its defaults; *reduced* means no antialiasing and a shadow map of a",
         "sixteenth. pybullet uses its TinyRenderer. The last column shows pixels with the same depth within 1 %."]
QUICK_ROUNDS = 1


def depths(path):
    values = array.array("f")
    with open(path, "rb") as file:
        values.frombytes(file.read())
    return values


class Cameras:
    """All worlds in all available engines."""

    def __init__(self, run, quick):
        self.run = run
        self.seconds = 0.1 if quick else 1.5
        self.rounds = QUICK_ROUNDS if quick else ROUNDS
        self.worlds = WORLDS[:1] if quick else WORLDS + OWN_WORLDS

    def measure(self):
        """Returns a list of results, and why an engine or a world is missing."""
        results = []
        missing = {}
        engines = ["sear"]
        for engine in [] if self.run.options.no_peers else list(ENGINES)[1:]:
            reason = self.run.install(engine.partition("-")[0])
            if reason:
                missing[ENGINES[engine]] = reason
            else:
                engines.append(engine)
        for world in self.worlds:
            self.run.say("pictures of " + world)
            results += self.world(world, engines if world in WORLDS else ["sear"], missing)
        return results, missing

    def start(self, engine, world):
        file = self.run.path("pictures-%s.json" % world)
        log = self.run.path("pictures-%s.log" % engine)
        if engine == "sear":
            command = [self.run.java, "-Dsear.root=" + self.run.root, "-cp", self.run.options.classpath, "org.SEAR.benchmark.Cameras", world]
            command += [file] if world in WORLDS else []
            return Program(command, {}, self.run.folder, log)
        here = os.path.dirname(os.path.abspath(__file__))
        python = os.path.join(self.run.root, "build", "peers-" + engine.partition("-")[0], "bin", "python")
        # Mesa's llvmpipe renders in the calling thread
        environment = {"MUJOCO_GL": "egl", "LIBGL_ALWAYS_SOFTWARE": "1", "LP_NUM_THREADS": "0"}
        return Program([python, os.path.join(here, "picture_peer.py"), engine, file], environment, self.run.folder, log)

    def world(self, world, engines, missing):
        painters = {}
        for engine in engines:
            try:
                painters[engine] = self.start(engine, world)
            except ValueError as e:
                if engine == "sear":
                    raise SystemExit("benchmark: pictures in SEAR: %s" % e)
                missing["%s in %s" % (ENGINES[engine], world)] = "(%s)" % e
        found = {}
        try:
            for kind in KINDS:
                for painter in painters.values():
                    painter.ask("%s %g" % (kind, 2 * self.seconds))
                for _ in range(self.rounds):
                    for engine, painter in painters.items():
                        count, cpu = painter.ask("%s %g" % (kind, self.seconds))[:2]
                        found.setdefault((engine, kind), []).append(int(count) / float(cpu))
            same = {engine: self.same(painters["sear"], painters[engine]) for engine in painters}
        finally:
            for painter in painters.values():
                painter.close()
        results = []
        for (engine, kind), rates in found.items():
            own = found["sear", kind]
            ratios = [mine / other for mine, other in zip(own, rates)]
            results.append({"world": world, "engine": ENGINES[engine], "kind": kind, "perSecond": statistics.median(rates),
                            "slowest": min(rates), "fastest": max(rates), "ratio": statistics.median(ratios), "same": same[engine]})
        return results

    def same(self, own, other):
        """Returns the fraction of a picture's pixels with the same depth in both engines."""
        files = [self.run.path("pictures-%d.depths" % i) for i in range(2)]
        own.ask("save 0 " + files[0])
        other.ask("save 0 " + files[1])
        pairs = [(a, b) for a, b in zip(depths(files[0]), depths(files[1])) if a < COMPARED]
        return sum(abs(a - b) < SAME * a for a, b in pairs) / len(pairs)


def table(results):
    """Returns the lines of a Markdown table."""
    lines = ["| world | what | engine | pictures per CPU second | goal | SEAR is faster | same depths |", "|---|---|---|---|---|---|---|"]
    for one in results:
        sear = one["engine"] == "SEAR"
        goal = "%d, %s" % (GOALS[one["kind"]], "met" if one["perSecond"] >= GOALS[one["kind"]] else "**missed**") if sear else ""
        faster = "" if sear else "×%.2g%s" % (one["ratio"], "" if one["ratio"] > 1 else ", **missed**")
        same = "" if sear else "%.1f %%" % (100 * one["same"])
        lines.append("| %s | %s | %s | %.3g (%.3g to %.3g) | %s | %s | %s |" % (one["world"], KINDS[one["kind"]], one["engine"], one["perSecond"],
                                                                              one["slowest"], one["fastest"], goal, faster, same))
    return lines
