# SPDX-License-Identifier: Apache-2.0
"""Scenes of bodies that end at rest, in several engines: processor time, and its validity: deepest overlap below 1 mm, no
movement."""
import json
import math
import os
import subprocess
import sys

SCENES = ["single-10", "single-100", "single-1000", "pile-10", "pile-100", "pile-1000", "dominoes-30", "stack-10"]
STRUCTURES = ["wall-10", "wall-20", "bond-20", "pyramid-10", "pyramid-15", "jenga-18", "logs-3", "logs-6"]
QUICK_SCENES = ["single-10", "pile-10"]
QUICK_STRUCTURES = ["jenga-18", "logs-3"]
ENGINES = {"sear": "SEAR", "bullet": "Bullet", "mujoco": "MuJoCo", "jbullet": "jbullet"}
# jbullet only shows what its contacts would be like
DEFAULT = "sear,bullet,mujoco"
# Overlap in metres above which a speed is invalid
DEEPEST = 1e-3
# Displacement in metres at which a structure does not stand, and at which it has collapsed
DRIFTED = 0.01
COLLAPSED = 0.1
# Limits of movement in half a second for a body at rest, metres and radians
MOVED = 1e-4
TURNED = 2e-3
NOTHING = 1e-9
# Length of a cross product below which two axes count as parallel
PARALLEL = 1e-6
HEAD = ("name", "side", "mass", "friction", "seconds", "watch", "round")


# ---- judging ---------------------------------------------------------------------------------------------------------------

def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


class Cuboid:
    """A box at a pose: {x, y, z, qx, qy, qz, qw}."""

    def __init__(self, half, pose):
        x, y, z, w = pose[3:]
        self.at = pose[:3]
        self.half = half
        self.axes = ((1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)),
                     (2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)),
                     (2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)))
        self.reaches = [self.reach(unit) for unit in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]

    def reach(self, axis):
        return sum(half * abs(dot(own, axis)) for half, own in zip(self.half, self.axes))

    def along(self, axis, other):
        apart = [b - a for a, b in zip(self.at, other.at)]
        return self.reach(axis) + other.reach(axis) - abs(dot(apart, axis))

    def near(self, other):
        return all(abs(a - b) < r + s for a, b, r, s in zip(self.at, other.at, self.reaches, other.reaches))

    def depth(self, other):
        """Returns the penetration depth by the fifteen separating axes of two boxes, metres; at most 0 if they are
        apart."""
        least = min(self.along(axis, other) for axis in self.axes + other.axes)
        for a in self.axes:
            for b in other.axes:
                axis = cross(a, b)
                length = math.sqrt(dot(axis, axis))
                if length > NOTHING:
                    least = min(least, self.along(axis, other) / length)
        return least


class Log(Cuboid):
    """A cylinder along its y axis; its half sizes are radius, half of its length, radius."""

    def reach(self, axis):
        along = min(1.0, abs(dot(self.axes[1], axis)))
        return self.half[1] * along + self.half[0] * math.sqrt(1 - along * along)

    def depth(self, other):
        """Returns the smallest overlap along both axes, the common perpendicular, and the perpendiculars from each axis to
        the other's centre, metres; at most 0 if they are apart. Exact for parallel and crossing logs, otherwise an upper
        bound."""
        apart = [b - a for a, b in zip(self.at, other.at)]
        own, others = self.axes[1], other.axes[1]
        directions = [own, others, cross(own, others)]
        for axis in (own, others):
            directions.append([a - dot(apart, axis) * n for a, n in zip(apart, axis)])
        least = math.inf
        for direction in directions:
            length = math.sqrt(dot(direction, direction))
            if length > PARALLEL:
                least = min(least, self.along([a / length for a in direction], other))
        return least


def deepest(world, poses):
    """Returns the deepest overlap between bodies and with the floor, metres."""
    kind = Log if world["round"] else Cuboid
    cuboids = sorted((kind(box[:3], pose) for box, pose in zip(world["boxes"], poses)),
                     key=lambda one: one.at[0] - one.reaches[0])
    most = 0.0
    for i, one in enumerate(cuboids):
        most = max(most, one.reaches[1] - one.at[1])
        for other in cuboids[i + 1:]:
            if other.at[0] - other.reaches[0] > one.at[0] + one.reaches[0]:
                break
            if one.near(other):
                most = max(most, one.depth(other))
    return most


def moving(before, after):
    """Counts bodies that have moved or turned between two snapshots, or whose pose is not finite."""
    count = 0
    for a, b in zip(before, after):
        turn = min(1.0, abs(sum(p * q for p, q in zip(a[3:], b[3:]))))
        still = math.dist(a[:3], b[:3]) <= MOVED and 2 * math.acos(turn) <= TURNED
        count += 0 if still else 1
    return count


def fallen(world, after):
    """Counts boxes whose vertical axis leans by more than 25 degrees, for dominoes."""
    return sum(1 for box, pose in zip(world["boxes"], after) if abs(Cuboid(box[:3], pose).axes[1][1]) < 0.9)


def judge(world, found):
    result = {"perSecond": found["cpu"] / world["seconds"], "overlap": deepest(world, found["after"]),
              "moving": moving(found["before"], found["after"])}
    if world["name"].startswith("dominoes"):
        result["fallen"] = fallen(world, found["after"])
    if world["name"].startswith("stack"):
        top = world["boxes"][-1]
        result["topOff"] = found["after"][-1][1] - top[4]
    if world["name"].split("-")[0] in {name.split("-")[0] for name in STRUCTURES}:
        result["drift"] = max(math.dist(box[3:6], pose[:3]) for box, pose in zip(world["boxes"], found["after"]))
    result["counts"] = result["overlap"] < DEEPEST and result["moving"] == 0 and result.get("drift", 0) < DRIFTED
    return result


# ---- running ---------------------------------------------------------------------------------------------------------------

class Bodies:
    """All scenes in all requested engines."""

    def __init__(self, run, engines, scenes, longest):
        self.run = run
        self.engines = engines
        self.scenes = scenes
        self.longest = longest

    def measure(self):
        """Returns a list of results, and why an engine or a scene is missing."""
        results = []
        missing = {}
        for engine in self.engines:
            reason = self.run.install("mujoco") if engine == "mujoco" else None
            if engine == "bullet" and self.run.bullet() is None:
                reason = "no class path of it: ./gradlew benchmarkPath writes it on Linux"
            if reason:
                missing[ENGINES[engine]] = reason
        for scene in self.scenes:
            for engine in [one for one in self.engines if ENGINES[one] not in missing]:
                self.run.say("%s: %s" % (ENGINES[engine], scene))
                try:
                    results.append(dict(self.one(engine, scene), engine=ENGINES[engine], scene=scene))
                except subprocess.TimeoutExpired:
                    missing["%s in %s" % (ENGINES[engine], scene)] = "(it took longer than %g s)" % self.longest
                except subprocess.CalledProcessError as e:
                    missing["%s in %s" % (ENGINES[engine], scene)] = "(it ended with status %d)" % e.returncode
                except ValueError as e:
                    missing["%s in %s" % (ENGINES[engine], scene)] = "(%s)" % str(e)[:200]
        return results, missing

    def one(self, engine, scene):
        scene_file = self.run.path(scene + ".json")
        target = self.run.path("bodies.json")
        if engine == "sear":
            command = [self.run.java, "-cp", self.run.options.classpath, "org.SEAR.benchmark.Bodies", scene, scene_file, target]
        else:
            subprocess.run([self.run.java, "-cp", self.run.options.classpath, "org.SEAR.benchmark.Bodies", scene, scene_file], check=True,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            command = self.peer(engine, scene_file, target)
        if os.path.exists(target):
            os.remove(target)
        with open(self.run.path("bodies-%s.log" % engine), "a") as log:
            subprocess.run(command, check=True, stdout=log, stderr=log, timeout=self.longest, cwd=self.run.folder,
                           env=dict(os.environ, MUJOCO_GL="disable"))
        return judge(read(scene_file), read(target))

    def peer(self, engine, scene_file, target):
        if engine == "mujoco":
            python = os.path.join(self.run.root, "build", "peers-mujoco", "bin", "python")
            return [python, os.path.join(os.path.dirname(os.path.abspath(__file__)), "mujoco_bodies.py"), scene_file, target]
        world = read(scene_file)
        numbers = scene_file + ".txt"
        with open(numbers, "w") as out:
            for line in [[world[key] for key in HEAD[1:]]] + world["boxes"]:
                out.write(" ".join(repr(float(number)) for number in line) + "\n")
        if engine == "jbullet":
            return [self.run.java, "-cp", self.run.options.classpath, "org.SEAR.benchmark.JBulletBodies", numbers, target]
        return [self.run.java, "-cp", self.run.bullet(), "org.SEAR.benchmark.bullet.BulletBodies", numbers, target]


def read(path):
    with open(path) as file:
        return json.load(file)


# ---- output ----------------------------------------------------------------------------------------------------------------

def remark(one):
    """Returns the last column of the table."""
    if "fallen" in one:
        return "%d fallen" % one["fallen"]
    if "topOff" in one:
        return "top %+.2f mm" % (1000 * one["topOff"])
    if "drift" in one:
        return "collapsed" if one["drift"] > COLLAPSED else "drift %.2f mm" % (1000 * one["drift"])
    return ""


def table(results):
    """Returns the lines of a Markdown table; invalid speeds are in brackets."""
    lines = ["| scene | engine | CPU s per simulated s | times real time | deepest overlap, mm | still moving | |", "|---|---|---|---|---|---|---|"]
    for one in results:
        speed = "%.0f" % (1 / one["perSecond"]) if one["perSecond"] < 0.1 else "%.2g" % (1 / one["perSecond"])
        more = remark(one)
        lines.append("| %s | %s | %.4f | %s | %.2f | %d | %s |" % (one["scene"], one["engine"], one["perSecond"],
                                                                  speed if one["counts"] else "(%s)" % speed, 1000 * one["overlap"], one["moving"],
                                                                  more))
    return lines


if __name__ == "__main__":
    sys.exit("scripts/benchmark --bodies runs it")
