# SPDX-License-Identifier: Apache-2.0
"""Takes pictures of one world in another engine on request: picture_peer.py ENGINE WORLD.json. ENGINE is mujoco, mujoco-fast
or pybullet.

Reads the lines "colors SECONDS" or "depths SECONDS", answered by "PICTURES CPU_SECONDS SECONDS" (of the whole process), and
"save TURN FILE".
"""
import importlib
import json
import sys
import time


def take(take_one, turns, seconds):
    count = 0
    cpu = time.process_time()
    wall = time.perf_counter()
    while count == 0 or time.process_time() - cpu < seconds:
        for turn in range(turns):
            take_one(turn)
            count += 1
    return "%d %.6f %.6f" % (count, time.process_time() - cpu, time.perf_counter() - wall)


def main():
    answers = sys.stdout
    sys.stdout = sys.stderr
    name, _, setting = sys.argv[1].partition("-")
    engine = importlib.import_module(name + "_pictures")
    with open(sys.argv[2]) as file:
        world = json.load(file)
    scene = engine.Scene(world, setting == "fast")
    print("ready", file=answers, flush=True)
    for line in sys.stdin:
        words = line.rstrip("\n").split(" ", 2)
        if words[0] == "save":
            scene.depths(int(words[1])).astype("<f4").tofile(words[2])
            answer = "saved"
        else:
            answer = take(scene.colors if words[0] == "colors" else scene.depth_buffer, len(world["poses"]), float(words[1]))
        print(answer, file=answers, flush=True)


if __name__ == "__main__":
    main()
