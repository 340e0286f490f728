# SPDX-License-Identifier: Apache-2.0
"""A mechanism of boxes and hinges in MuJoCo, which has reduced coordinates: mujoco_joints.py MECHANISM.json OUT.json.

OUT.json receives the exact path, by RK4 at 0.1 ms, and path and processor time per simulated second at each step.
"""
import json
import sys
import time

import mujoco

EXACT = 1e-4
FRAME = 1 / 60
# Steps in a frame
DIVISIONS = (1, 2, 4, 8, 16, 32)
INTEGRATORS = ("implicitfast", "RK4")
AXES = ("1 0 0", "0 1 0", "0 0 1")
HEAD = '<mujoco><option timestep="%.17g" gravity="0 -9.81 0" integrator="%s"/><worldbody>'
# 0.64: that of two boxes of SEAR
FLOOR = '<geom type="box" size="5 0.05 5" pos="0 -0.05 0" friction="0.64 0.005 0.0001"/>'


def body_xml(world, number, parent):
    """Returns a body and, within it, those that hang on it."""
    hx, hy, hz, mass, *place = world["boxes"][number]
    start = world["boxes"][parent][4:] if parent is not None else (0, 0, 0)
    joint = "<freejoint/>"
    for hinge in world["hinges"]:
        if hinge[1] == number:
            joint = '<joint type="hinge" pos="%r %r %r" axis="%s" stiffness="%r" damping="%r"/>' % (
                *(a - b for a, b in zip(hinge[2:5], place)), AXES[int(hinge[5])], hinge[6], hinge[7])
    children = "".join(body_xml(world, int(hinge[1]), number) for hinge in world["hinges"] if hinge[0] == number)
    # Boxes of one mechanism do not collide, nor do they here with each other in SEAR's worlds
    return '<body pos="%r %r %r">%s<geom type="box" size="%r %r %r" mass="%r" friction="0.64 0.005 0.0001" contype="2"/>%s</body>' % (
        *(a - b for a, b in zip(place, start)), joint, hx, hy, hz, mass, children)


def xml(world, step, integrator):
    roots = [int(hinge[1]) for hinge in world["hinges"] if hinge[0] < 0] or [0]
    return (HEAD % (step, integrator) + (FLOOR if world["floor"] else "")
            + "".join(body_xml(world, root, None) for root in roots) + "</worldbody></mujoco>")


def run(world, step, integrator):
    """Returns the path of the marked box, once a frame, and the processor time per simulated second."""
    model = mujoco.MjModel.from_xml_string(xml(world, step, integrator))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    marked = 1 if world["floor"] else model.nbody - 1
    track = []
    cpu = 0.0
    for frame in range(1, round(world["seconds"] / FRAME) + 1):
        steps = round(frame * FRAME / step) - round((frame - 1) * FRAME / step)
        began = time.thread_time()
        for _ in range(steps):
            mujoco.mj_step(model, data)
        cpu += time.thread_time() - began
        mujoco.mj_kinematics(model, data)
        track.append(data.xpos[marked].tolist())
    return {"cpu": cpu / world["seconds"], "track": track}


def main():
    with open(sys.argv[1]) as file:
        world = json.load(file)
    exact = run(world, EXACT, "RK4")
    runs = [dict(run(world, FRAME / division, integrator), step=FRAME / division, integrator=integrator)
            for integrator in INTEGRATORS for division in DIVISIONS]
    with open(sys.argv[2], "w") as out:
        json.dump({"exact": exact, "runs": runs}, out)


if __name__ == "__main__":
    main()
