# SPDX-License-Identifier: Apache-2.0
"""The whole benchmark in one run: SEAR and other engines in the same worlds, in turns. scripts/benchmark runs it; --help
lists the options."""
import argparse
import json
import os
import re
import shutil
import statistics
import subprocess
import sys
import time

import bodies
import cameras
import cores
import joints
import machine
import page
from program import Program

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", "..", ".."))
INSTALLED = os.path.join(ROOT, "build", "install", "sear")
HERE = os.path.dirname(os.path.abspath(__file__))
PACKAGE = "org.SEAR.benchmark."
PEERS = ("embree", "mujoco", "pybullet")
# Casts rays and has no bodies
ONLY_BEAMS = ("embree",)
# Load per core above which the machine is too busy to measure
BUSY = 0.25
# Maximum seconds of one world in another engine
LONGEST_WORLD = 300

FULL = {
    "beams": ["room-20", "room-100", "room-1000", "hall-10", "hall-100", "hall-1000", "hall-10000", "hills-1000", "hills-10000", "hills-110000",
              "hills-1000000"],
    "fields": ["field-100000", "field-13000000"],
    "drives": ["drive-room-20", "drive-room-1000", "lidar-room-20", "lidar-room-1000", "lidar-hall-10", "lidar-hall-100", "lidar-hall-1000",
               "lidar-hall-9900", "lidars2-room-20", "lidars4-room-20", "lidars8-room-20"],
    "own": ["all-room-20", "all-room-1000", "camera-room-20", "blind-room-20", "asleep-1000"],
    "drops": ["drop-10", "drop-30", "drop-100", "drop-300", "drop-1000"],
    "meshes": [1000, 10000, 110000, 1000000],
    "runs": ["all-room-20", "all-room-1000"],
    "jmh": ["-i", "2"],
    "rounds": 3,
    "steps": 3600,
    "seconds": 0.4,
    "scans": 30,
    "bodies": bodies.SCENES,
    "structures": bodies.STRUCTURES,
}
QUICK = {
    "beams": ["hall-10", "hills-1000"],
    "fields": ["field-1000"],
    "drives": ["lidar-room-20"],
    "own": ["all-room-20"],
    "drops": ["drop-10"],
    "meshes": [1000],
    "runs": ["all-room-20"],
    "steps": 60,
    "jmh": ["-f", "0", "-wi", "1", "-w", "50ms", "-i", "1", "-r", "50ms"],
    "rounds": 1,
    "seconds": 0.1,
    "scans": 2,
    "bodies": bodies.QUICK_SCENES,
    "structures": bodies.QUICK_STRUCTURES,
}


def launcher_options(installed):
    """Returns the launcher's JVM options for memory, compiler and class archive. installed: sear's folder, or None."""
    with open(os.path.join(ROOT, "src", "dist", "bin", "sear")) as launcher:
        told = " ".join(re.findall('^(?:memory|compiler)="(.*)"$', launcher.read(), re.MULTILINE)).split()
    return told + (["-Xlog:cds=off", "-XX:SharedArchiveFile=" + os.path.join(installed, "lib", "sear.jsa")] if installed else [])


class Run:
    """One run: options, files, results."""

    def __init__(self, options):
        self.options = options
        self.plan = QUICK if options.quick else FULL
        self.folder = os.path.abspath(options.work)
        os.makedirs(self.folder, exist_ok=True)
        home = os.environ.get("JAVA_HOME")
        self.java = os.path.join(home, "bin", "java") if home else "java"
        self.root = ROOT
        self.began = time.time()

    def say(self, what):
        print("%4.0f s  %s" % (time.time() - self.began, what), flush=True)

    def path(self, name):
        return os.path.join(self.folder, name)

    def call_java(self, name, *args, options=(), before=""):
        """before: start of the class path"""
        command = [self.java, *options, "-Djmh.ignoreLock=true", "-cp", before + self.options.classpath, PACKAGE + name] + [str(arg) for arg in args]
        with open(self.path("java.log"), "a") as log:
            if subprocess.call(command, stdout=log, stderr=log, cwd=self.folder) != 0:
                raise SystemExit("benchmark: %s failed; its messages are in %s" % (name, log.name))

    def measure(self, *args, options=(), before=""):
        target = self.path("measure.json")
        self.call_java("Measures", target, *args, options=options, before=before)
        return read(target)

    # ---- measurements ----------------------------------------------------------------------------------------------------

    def worlds(self):
        self.say("writing the worlds")
        self.call_java("WorldFiles", self.folder, *(self.plan["beams"] + self.plan["drives"] + self.plan["drops"]))

    def in_turns(self):
        """Returns the rates of all engines by (engine, world), and why an engine or a world is missing.

        In each world the engines go in turns, one repetition each per round, so that a busy machine affects all alike. The
        median counts.
        """
        plan = self.plan
        engines, missing = self.installed()
        steps = [world for world in plan["own"] if not world.startswith("asleep")]
        asleep = [world for world in plan["own"] if world.startswith("asleep")]
        results = []
        for benchmark, worlds, peers in (("Beams.", plan["beams"], engines), ("Beams.(fan|single)$", plan["fields"], []),
                                         ("Steps.", plan["drives"], [engine for engine in engines if engine not in ONLY_BEAMS]),
                                         ("Steps.", steps, []),
                                         ("Drops.", plan["drops"], [engine for engine in engines if engine not in ONLY_BEAMS]),
                                         ("Drops.", asleep, [])):
            for world in worlds:
                self.say("%s: SEAR%s" % (world, "".join(", " + engine for engine in peers)))
                results += self.world(benchmark, world, peers, missing)
        return results, missing

    def world(self, benchmark, world, engines, missing):
        programs = self.start(world, engines, missing)
        turns = {}
        for _ in range(self.plan["rounds"]):
            for engine, rate, share in self.jmh(benchmark, world):
                turns.setdefault(engine, []).append((rate, share))
            for engine in list(programs):
                try:
                    turns.setdefault(engine, []).append(tuple(float(word) for word in programs[engine].ask(str(self.plan["seconds"]))))
                except ValueError as e:
                    missing["%s in %s" % (engine, world)] = "(%s)" % e
                    del programs[engine], turns[engine]
        results = []
        for engine, pairs in turns.items():
            result = {"engine": engine, "world": world}
            if engine in programs:
                programs[engine].close()
                result = read(self.peer_file(engine))
            rates, shares = zip(*pairs)
            results.append(dict(result, perSecond=statistics.median(rates), cpuShare=statistics.mean(shares)))
        return results

    def jmh(self, benchmark, world):
        """Performs one repetition of SEAR, and of jbullet if requested: (engine, rate, share of a core)."""
        target = self.path("jmh.json")
        self.call_java("Report", target, PACKAGE + benchmark, "-p", "world=" + world, *self.plan["jmh"])
        found = []
        for result in read(target):
            method = result["benchmark"].rsplit(".", 1)[1]
            scale = 1e6 if result["primaryMetric"]["scoreUnit"] == "ops/us" else 1.0
            found.append(({"fan": "SEAR fan", "single": "SEAR single", "step": "SEAR"}.get(method, method),
                          result["primaryMetric"]["score"] * scale, result["secondaryMetrics"]["cpuShare"]["score"]))
        return found

    def meshes(self):
        found = []
        for size in self.plan["meshes"]:
            self.say("building the hierarchy of %d triangles" % size)
            found.append(self.measure("mesh", size))
        return found

    def runs(self):
        found = {}
        installed = None if self.options.no_script else INSTALLED
        before = os.path.join(INSTALLED, "plugin", "*") + ":" + os.path.join(INSTALLED, "lib", "*") + ":" if installed else ""
        for world in self.plan["runs"]:
            self.say("start and memory, " + world)
            folder = self.project(world)
            shutil.rmtree(folder, ignore_errors=True)
            os.makedirs(folder)
            self.measure("project", world, folder)
            found[world] = self.measure("run", world, folder, self.plan["steps"], options=launcher_options(installed), before=before)
        return found

    def project(self, world):
        return self.path("project-" + world)

    def script(self):
        """Measures a script in the embedded MyRobotLab; returns None without a built distribution."""
        if self.options.no_script:
            return None
        self.say("start, latency and memory of a script")
        target = self.path("latency.json")
        environment = dict(os.environ, SEAR_BENCHMARK_OUT=target, SEAR_BENCHMARK_SCANS=str(self.plan["scans"]))
        launched = time.time()
        with open(self.path("sear.log"), "w") as log:
            status = subprocess.call([os.path.join(INSTALLED, "bin", "sear"),
                                      os.path.join(ROOT, "src", "jmh", "jython", "latency.py"), "--headless", "--port", "none"],
                                     cwd=self.project(self.plan["runs"][0]), env=environment, stdout=log, stderr=log)
        if status != 0:
            raise SystemExit("benchmark: the script failed; its messages are in " + log.name)
        found = read(target)
        found["launchToReading"] = found["readingAt"] - launched
        return found

    # ---- other engines ---------------------------------------------------------------------------------------------------

    def install(self, engine):
        """Installs an engine. Returns None if it is available, else why not."""
        if self.options.no_peers:
            return "left out by --no-peers"
        lock = os.path.join(ROOT, "config", "pypi", engine + ".txt")
        wanted = read_text(lock)
        home = os.path.join(ROOT, "build", "peers-" + engine)
        stamp = os.path.join(home, "installed.txt")
        if os.path.exists(stamp) and read_text(stamp) == wanted:
            return None
        self.say("installing " + engine)
        shutil.rmtree(home, ignore_errors=True)
        for command in ([sys.executable, "-m", "venv", home],
                        [os.path.join(home, "bin", "python"), "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-deps",
                         "--require-hashes", "--only-binary", ":all:", "-r", lock]):
            done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
            if done.returncode != 0:
                lines = [line for line in done.stdout.splitlines() if "ERROR" in line] or done.stdout.splitlines() or ["no message"]
                return "did not install: " + lines[-1].strip()
        with open(stamp, "w") as file:
            file.write(wanted)
        return None

    def installed(self):
        """Returns the available engines, and why others are missing."""
        engines = []
        missing = {}
        for engine in PEERS:
            reason = self.install(engine)
            if reason:
                missing[engine] = reason
            else:
                engines.append(engine)
        return engines, missing

    def peer_file(self, engine):
        return self.path("peer-%s.json" % engine)

    def start(self, world, engines, missing):
        """Starts a program for each engine that can make the world; the programs wait for their turn."""
        programs = {}
        for engine in engines:
            command = [os.path.join(ROOT, "build", "peers-" + engine, "bin", "python"), os.path.join(HERE, "peer.py"), engine,
                       self.path(world + ".json"), self.peer_file(engine)]
            try:
                programs[engine] = Program(command, {"MUJOCO_GL": "disable"}, self.folder, self.path("%s.log" % engine), LONGEST_WORLD)
            except ValueError as e:
                missing["%s in %s" % (engine, world)] = "(%s)" % e
        return programs

    def bullet(self):
        """Returns the class path of native Bullet; None without it."""
        written = os.path.join(ROOT, "build", "benchmark", "bullet.txt")
        return read_text(written) if os.path.exists(written) else None

    def bodies(self):
        """Measures scenes that end at rest; also returns what is missing."""
        option = "structures" if self.options.structures else "bodies"
        scenes = self.plan[option]
        engines = getattr(self.options, option)
        engines = engines.split(",") if engines else ["sear"] if self.options.no_peers else bodies.DEFAULT.split(",")
        if self.options.scenes:
            scenes = self.options.scenes.split(",")
        for engine in engines:
            if engine not in bodies.ENGINES:
                raise SystemExit("benchmark: --%s %s, legal: %s" % (option, engine, ", ".join(bodies.ENGINES)))
        return bodies.Bodies(self, engines, scenes, LONGEST_WORLD).measure()

    def cores(self):
        return read(cores.measure(self, self.options.quick))

    def compare(self, peers):
        """Counts the beams in which each engine differs from SEAR, and collects physics results; removes the long lists
        from the peers' results."""
        agreement = []
        outcomes = []
        for world in self.plan["beams"]:
            data = read(self.path(world + ".json"))
            sides = [("SEAR single", data["single"]), ("jbullet", data["jbullet"])]
            sides += [(peer["engine"], peer.pop("ranges")) for peer in peers if peer["world"] == world]
            agreement += [dict(differences(data["fan"], ranges), engine=engine, world=world) for engine, ranges in sides]
        for world in self.plan["drops"] + self.plan["drives"]:
            data = read(self.path(world + ".json"))
            for engine, result in [("SEAR", data)] + [(peer["engine"], peer) for peer in peers if peer["world"] == world]:
                if "heights" in result:
                    heights = result.pop("heights")
                    outcomes.append({"world": world, "engine": engine, "meanHeight": sum(heights) / len(heights), "lowest": min(heights)})
                elif "way" in result:
                    outcomes.append({"world": world, "engine": engine, "way": result["way"]})
        return agreement, outcomes

    def everything(self):
        load = os.getloadavg()[0]
        if load > BUSY * os.cpu_count() and not self.options.quick:
            self.say("this machine is busy (load average %.1f, %d cores): the numbers are unreliable" % (load, os.cpu_count()))
        self.worlds()
        found = {"date": time.strftime("%Y-%m-%d"), "quick": self.options.quick, "machine": machine.describe(self.java), "loadBefore": load}
        found["rates"], found["missing"] = self.in_turns()
        found["rounds"] = self.plan["rounds"]
        found["meshes"] = self.meshes()
        found["runs"] = self.runs()
        found["script"] = self.script()
        found["agreement"], found["outcomes"] = self.compare([rate for rate in found["rates"] if "version" in rate])
        found["bodies"], missing = self.bodies()
        found["missing"].update(missing)
        found["cameras"], missing = cameras.Cameras(self, self.options.quick).measure()
        found["missing"].update(missing)
        found["cores"] = self.cores()
        found["minutes"] = (time.time() - self.began) / 60
        return found


    def again(self, found):
        """Repeats the requested parts and keeps all others."""
        parts = self.options.again.split(",")
        for part in parts:
            if part not in ("runs", "script", "cores"):
                raise SystemExit("benchmark: --again %s, legal: runs, script, cores" % part)
            found[part] = getattr(self, part)()
        found["again"] = sorted(set(parts) | set(found.get("again", [])))
        return found


def differences(truth, ranges):
    """Counts beams that hit only in one engine, or at distances that differ by more than 1 mm (and 1 cm)."""
    count = {"beams": min(len(truth), len(ranges)), "over1mm": 0, "over1cm": 0, "worst": 0.0}
    for a, b in zip(truth, ranges):
        apart = float("inf") if (a < 0) != (b < 0) else abs(a - b)
        count["over1mm"] += apart > 1e-3
        count["over1cm"] += apart > 1e-2
        if apart != float("inf"):
            count["worst"] = max(count["worst"], apart)
    return count


def read_text(path):
    with open(path) as file:
        return file.read()


def read(path):
    return json.loads(read_text(path))


def main():
    parser = argparse.ArgumentParser(description="Measures SEAR and other engines, and writes the tables and curves of docs/performance.md.")
    parser.add_argument("--quick", action="store_true", help="tiny worlds and times: only checks that everything runs; writes nothing into docs")
    parser.add_argument("--no-peers", action="store_true", help="omit the engines from PyPI")
    parser.add_argument("--no-script", action="store_true", help="omit the run in the embedded MyRobotLab")
    parser.add_argument("--bodies", metavar="ENGINES", nargs="?", const=bodies.DEFAULT,
                        help="measure only bodies that end at rest, in these engines (default: sear,bullet,mujoco), and"
                        " print the table; writes nothing into docs")
    parser.add_argument("--structures", metavar="ENGINES", nargs="?", const=",".join(bodies.ENGINES),
                        help="measure only structures at rest, in these engines (default: sear,bullet,mujoco,jbullet), and"
                        " print the table; writes nothing into docs")
    parser.add_argument("--scenes", metavar="SCENES", help="scenes of bodies, for example pile-100,stack-10 (default: all; with --quick two)")
    parser.add_argument("--joints", metavar="MECHANISMS", nargs="?", const=",".join(joints.MECHANISMS),
                        help="measure only mechanisms, and print the table; writes nothing into docs")
    parser.add_argument("--cameras", action="store_true", help="measure only pictures of cameras, and print the table; writes nothing into docs")
    parser.add_argument("--cores", action="store_true", help="measure only several cores and many robots, and print the tables;"
                        " writes nothing into docs")
    parser.add_argument("--again", metavar="PARTS", help="repeat only these parts (runs, script, cores), and store them in"
                        " docs/performance.json, for example after a disturbance by another program")
    parser.add_argument("--page-only", metavar="JSON", help="measure nothing: write the page from an earlier run's JSON")
    parser.add_argument("--docs", help="folder for performance.md, performance.json and images (default: docs; with --quick: that of --work)")
    parser.add_argument("--work", default=os.path.join(ROOT, "build", "benchmark"), help="folder for worlds and logs (default: build/benchmark)")
    parser.add_argument("--classpath", help="class path of the benchmark's Java part (default: that in build/benchmark/classpath.txt)")
    options = parser.parse_args()
    docs = options.docs or (options.work if options.quick else os.path.join(ROOT, "docs"))
    if options.page_only:
        found = read(options.page_only)
    else:
        if options.classpath is None:
            options.classpath = read_text(os.path.join(ROOT, "build", "benchmark", "classpath.txt"))
        run = Run(options)
        if options.bodies or options.structures:
            results, missing = run.bodies()
            print("\n".join(bodies.table(results) + ["%s: %s" % one for one in missing.items()]))
            return
        if options.joints:
            results, missing = joints.measure(run, options.joints.split(","))
            print("\n".join(joints.table(results) + ["%s: %s" % one for one in missing.items()]))
            return
        if options.cameras:
            results, missing = cameras.Cameras(run, options.quick).measure()
            print("\n".join(cameras.table(results) + ["%s: %s" % one for one in missing.items()]))
            return
        if options.cores:
            print("\n".join(cores.table(run.cores())))
            return
        found = run.again(read(os.path.join(docs, "performance.json"))) if options.again else run.everything()
        os.makedirs(docs, exist_ok=True)
        with open(os.path.join(docs, "performance.json"), "w") as out:
            json.dump(found, out, indent=1, sort_keys=True)
            out.write("\n")
        run.say("measured")
    for line in page.write(found, os.path.join(ROOT, "docs", "performance.md"), docs):
        print(line)


if __name__ == "__main__":
    main()
