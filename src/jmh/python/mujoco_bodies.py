# SPDX-License-Identifier: Apache-2.0
"""A scene of bodies in MuJoCo, at 1/60 s with default settings except for the friction: mujoco_bodies.py SCENE.json
OUT.json."""
import json
import sys
import time

import mujoco

from mujoco_engine import HEAD, STEP, box_xml


def poses(data):
    """Returns position and quaternion {x, y, z, w} of each body."""
    rows = data.qpos.reshape(-1, 7).tolist()
    return [row[:3] + row[4:] + row[3:4] for row in rows]


def main():
    with open(sys.argv[1]) as file:
        world = json.load(file)
    friction = 'friction="%r 0.005 0.0001"' % world["friction"]
    half = world["side"] / 2
    bodies = []
    for hx, hy, hz, x, y, z, qx, qy, qz, qw in world["boxes"]:
        # a cylinder of MuJoCo lies along z
        geom = 'type="cylinder" quat="1 1 0 0" size="%r %r"' % (hx, hy) if world["round"] else 'type="box" size="%r %r %r"' % (hx, hy, hz)
        bodies.append('<body pos="%r %r %r" quat="%r %r %r %r"><freejoint/><geom %s mass="%r" %s/></body>'
                      % (x, y, z, qw, qx, qy, qz, geom, world["mass"], friction))
    model = mujoco.MjModel.from_xml_string(HEAD + "<worldbody>" + box_xml((half, 0.05, half, 0, -0.05, 0, 0, 0, 0, 1), friction) + "".join(bodies)
                                           + "</worldbody></mujoco>")
    data = mujoco.MjData(model)

    def run(seconds):
        began = time.thread_time()
        for _ in range(round(seconds / STEP)):
            mujoco.mj_step(model, data)
        return time.thread_time() - began

    cpu = run(world["seconds"] - world["watch"])
    before = poses(data)
    cpu += run(world["watch"])
    with open(sys.argv[2], "w") as out:
        json.dump({"cpu": cpu, "before": before, "after": poses(data)}, out)


if __name__ == "__main__":
    main()
