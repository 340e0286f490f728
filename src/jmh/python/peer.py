# SPDX-License-Identifier: Apache-2.0
"""Runs one world of the benchmark in another engine on request: peer.py ENGINE WORLD.json OUT.json. ENGINE is mujoco,
pybullet or embree.

OUT.json receives one-time results. Then it answers each line with a number of seconds by "RATE SHARE" of timing.rate.
"""
import importlib
import json
import math
import sys

import timing

# Number of poses whose beams are compared if a scan takes long
FEW_POSES = 10
LONG_SCAN = 0.05


def beams(engine, world):
    before = timing.resident()
    scene, build = timing.once(lambda: engine.Beams(world))
    grown = timing.resident() - before
    poses = len(world["origins"])
    first, took = timing.once(lambda: scene.ranges(0))
    compared = poses if took["wall"] < LONG_SCAN else FEW_POSES
    ranges = first + [distance for i in range(1, compared) for distance in scene.ranges(i)]
    at = [0]

    def scan():
        at[0] = (at[0] + 1) % poses
        scene.scan(at[0])

    found = {"ranges": ranges, "build": build["wall"], "buildCpu": build["cpu"], "bytes": grown}
    return found, lambda seconds: timing.rate(scan, world["beams"], seconds)


def drop(engine, world):
    scene = engine.Drop(world)

    def run():
        for _ in range(world["steps"]):
            scene.step()

    scene.reset()
    for _ in range(world["restSteps"]):
        scene.step()
    return {"heights": scene.heights()}, lambda seconds: timing.rate(run, world["steps"], seconds, scene.reset)


def drive(engine, world):
    scene = engine.Drive(world)
    way = 0.0
    last = scene.position()
    for _ in range(world.get("checkSteps", 0)):
        scene.step()
        now = scene.position()
        way += math.hypot(now[0] - last[0], now[1] - last[1])
        last = now

    def run():
        for _ in range(60):
            scene.step()

    run()
    return {"way": way} if "way" in world else {}, lambda seconds: timing.rate(run, 60, seconds)


def main():
    answers = sys.stdout
    sys.stdout = sys.stderr
    engine = importlib.import_module(sys.argv[1] + "_engine")
    with open(sys.argv[2]) as file:
        world = json.load(file)
    kind = beams if "beams" in world else drop if "mass" in world else drive
    found, rate = kind(engine, world)
    found.update(engine=engine.NAME, version=engine.VERSION, world=world["name"], peakResident=timing.peak_resident())
    with open(sys.argv[3], "w") as out:
        json.dump(found, out)
    print("ready", file=answers, flush=True)
    for line in sys.stdin:
        print("%r %r" % rate(float(line)), file=answers, flush=True)


if __name__ == "__main__":
    main()
