# SPDX-License-Identifier: Apache-2.0
"""Environment steps per second, from Python, with a LIDAR of 181 beams: sear.gym, and Gymnasium's MuJoCo and pybullet, in one
process, in turns.

    pip install ./python[gym] mujoco pybullet imageio
    python3 src/jmh/python/environments.py

A room of 8 m by 8 m with 20 fixed boxes, and a robot with two driven wheels that drives in a circle. A step is an action,
1/60 s of physics and an observation of 181 ranges as an array of float32. Each engine has one thread.
"""
import os
import random
import statistics
import sys
import tempfile
import time

import gymnasium
import mujoco
import numpy
import pybullet
from gymnasium.envs.mujoco import MujocoEnv

import sear
import sear.gym

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import mujoco_engine    # noqa: E402
import pybullet_engine    # noqa: E402

BEAMS = 181
RANGE = 8.0
STEP = 1 / 60
HEIGHT = 0.2          # metres of the scanner above the robot's frame
ROUNDS = 12
STEPS = 2000
WHEELS = (0.2, 0.3)   # m/s, left and right
RADIUS = 0.0381       # of a wheel, metres
WARM = 20000


def boxes():
    """Returns half lengths, position and rotation, in the form of the benchmark's engines; walls first."""
    chance = random.Random(1)
    all_of_them = [(4, 0.5, 0.05, 0, 0.5, 4.05), (4, 0.5, 0.05, 0, 0.5, -4.05), (0.05, 0.5, 4, 4.05, 0.5, 0), (0.05, 0.5, 4, -4.05, 0.5, 0)]
    while len(all_of_them) < 24:
        x, z = chance.uniform(-3.5, 3.5), chance.uniform(-3.5, 3.5)
        if x * x + z * z > 2.5:
            all_of_them.append((0.2, 0.5, 0.15, x, 0.5, z))
    return [box + (0.0, 0.0, 0.0, 1.0) for box in all_of_them]


class Sear:
    """An environment of SEAR with a project made here."""
    name = "SEAR"

    def __init__(self):
        sear.start(headless=True)
        from sear import LIDAR, Box, Floor, Robots, Runtime
        Runtime.start("sear", "SEAR").newProject()
        Floor("floor", 10, 10)
        for number, (hx, hy, hz, x, y, z, *_) in enumerate(boxes()):
            Box("box %d" % number, 2 * hx, 2 * hz, 2 * hy, 0).move(x, y, z)
        robot = Robots.create("robot")
        robot.addComponent(LIDAR("lidar", RANGE, BEAMS - 1, 1, 0, HEIGHT, 0))
        self.env = sear.gym.SearEnv("SEARproject", sensors=["lidar"], actions=[WHEELS], steps_per_action=1, max_seconds=None)
        self.action = 0
        self.version = "this one"


class Rangefinders(MujocoEnv):
    """A MuJoCo environment of Gymnasium whose observation is a fan of rangefinders."""
    metadata = {"render_modes": []}

    def __init__(self, file):
        space = gymnasium.spaces.Box(-1, numpy.inf, (BEAMS,), numpy.float32)
        self.metadata = {"render_modes": ["human", "rgb_array", "depth_array", "rgbd_tuple"], "render_fps": 60}
        MujocoEnv.__init__(self, file, 1, observation_space=space)

    def step(self, action):
        self.do_simulation(action, self.frame_skip)
        return self.data.sensordata.astype(numpy.float32), 0.0, False, False, {}

    def reset_model(self):
        return self.data.sensordata.astype(numpy.float32)


class MujocoRays(Rangefinders):
    """The same, with beams cast by one call, mj_multiRay."""

    def __init__(self, file):
        super().__init__(file)
        angles = numpy.radians(numpy.arange(BEAMS) - (BEAMS - 1) / 2)
        self.fan = numpy.stack([numpy.sin(angles), numpy.zeros(BEAMS), numpy.cos(angles)], axis=1)
        self.geoms = numpy.zeros(BEAMS, dtype=numpy.int32)
        self.distances = numpy.zeros(BEAMS)
        self.body = self.model.body("robot").id

    def step(self, action):
        self.do_simulation(action, self.frame_skip)
        turn = self.data.xmat[self.body].reshape(3, 3)
        mujoco.mj_multiRay(self.model, self.data, self.data.xpos[self.body] + turn[:, 1] * HEIGHT, (self.fan @ turn.T).ravel(), None, True, self.body,
                           self.geoms, self.distances, None, BEAMS, RANGE)
        return self.distances.astype(numpy.float32), 0.0, False, False, {}


def mujoco_xml(rangefinders):
    """Returns the room, and the robot of the benchmark."""
    sites = sensors = ""
    for number in range(BEAMS if rangefinders else 0):
        angle = numpy.radians(number - (BEAMS - 1) / 2)
        sites += '<site name="s%d" pos="0 %r 0" zaxis="%r 0 %r"/>' % (number, HEIGHT, float(numpy.sin(angle)), float(numpy.cos(angle)))
        sensors += '<rangefinder site="s%d" cutoff="%r"/>' % (number, RANGE)
    robot = ('<body name="robot" pos="0 0.0681 0"><freejoint/><geom type="cylinder" size="0.1666875 0.0381" quat="%s" mass="40"/>'
             % mujoco_engine.UPRIGHT + sites + "".join(mujoco_engine.wheel_xml(*wheel) for wheel in (
                 ("left", 0.16, 0.0, True), ("right", -0.16, 0.0, True), ("front", 0.0, 0.16, False), ("back", 0.0, -0.16, False))) + "</body>")
    return (mujoco_engine.HEAD.replace(mujoco_engine.ARENA, "64M") + "<worldbody>"
            + mujoco_engine.box_xml((5, 0.05, 5, 0, -0.05, 0, 0, 0, 0, 1)) + "".join(mujoco_engine.box_xml(box) for box in boxes()) + robot
            + '</worldbody><actuator><velocity joint="left" kv="10"/><velocity joint="right" kv="10"/></actuator><sensor>' + sensors
            + "</sensor></mujoco>")


class Mujoco:
    """An environment of Gymnasium."""

    def __init__(self, kind, name, folder):
        file = os.path.join(folder, kind.__name__ + ".xml")
        with open(file, "w") as out:
            out.write(mujoco_xml(kind is Rangefinders))
        self.env = kind(file)
        self.name = name
        self.version = mujoco.__version__
        self.action = numpy.array(WHEELS) / RADIUS


class Pybullet(gymnasium.Env):
    """The benchmark's robot and rayTestBatch, as an environment."""
    name = "pybullet, rayTestBatch"
    version = pybullet_engine.VERSION
    action = numpy.array(WHEELS) / RADIUS

    def __init__(self):
        world = {"side": 10, "boxes": boxes(), "circle": 1e-9, "startHeight": 0.0681, "speed": 0, "lidars": 1, "range": RANGE}
        self.drive = pybullet_engine.Drive(world)
        angles = numpy.radians(numpy.arange(BEAMS) - (BEAMS - 1) / 2)
        self.fan = RANGE * numpy.stack([numpy.sin(angles), numpy.zeros(BEAMS), numpy.cos(angles)], axis=1)
        self.env = self

    def reset(self, *, seed=None, options=None):
        pybullet.resetBasePositionAndOrientation(self.drive.robot, (0, 0.0681, 0), (0, 0, 0, 1))
        pybullet.resetBaseVelocity(self.drive.robot, (0, 0, 0), (0, 0, 0))
        return numpy.zeros(BEAMS, numpy.float32), {}

    def step(self, action):
        for joint in (0, 1):
            pybullet.setJointMotorControl2(self.drive.robot, joint, pybullet.VELOCITY_CONTROL, targetVelocity=action[joint], force=10)
        pybullet.stepSimulation()
        place, turn = pybullet.getBasePositionAndOrientation(self.drive.robot)
        turn = numpy.array(pybullet.getMatrixFromQuaternion(turn)).reshape(3, 3)
        origin = numpy.array(place) + turn[:, 1] * HEIGHT
        hits = pybullet.rayTestBatch([origin.tolist()] * BEAMS, (origin + self.fan @ turn.T).tolist(), numThreads=1)
        return numpy.array([hit[2] * RANGE for hit in hits], numpy.float32), 0.0, False, False, {}


def measure(engine, steps):
    """Returns the processor time per step of this thread, microseconds."""
    step, action = engine.env.step, engine.action
    begun = time.thread_time()
    for _ in range(steps):
        step(action)
    return (time.thread_time() - begun) / steps * 1e6


def main():
    folder = tempfile.mkdtemp()
    os.chdir(folder)
    engines = [Sear(), Mujoco(MujocoRays, "MuJoCo, mj_multiRay", folder), Mujoco(Rangefinders, "MuJoCo, 181 rangefinders", folder), Pybullet()]
    for engine in engines:
        engine.env.reset(seed=1)
        measure(engine, WARM if engine is engines[0] else STEPS)
        engine.env.reset(seed=1)
        for _ in range(120):
            seen = engine.env.step(engine.action)[0]
        hit = seen[(seen >= 0) & (seen < RANGE)]
        print("%s %s: %d of %d beams hit, %.2f m on average" % (engine.name, engine.version, hit.size, BEAMS, hit.mean()))
    times = {engine.name: [] for engine in engines}
    for turn in range(ROUNDS):
        for engine in engines[turn % 4:] + engines[:turn % 4]:
            engine.env.reset(seed=1)
            times[engine.name].append(measure(engine, STEPS))
    mine = statistics.median(times["SEAR"])
    for name, each in times.items():
        middle = statistics.median(each)
        print("%-25s %7.1f us per step (%.1f to %.1f), %6.0f steps per second, %.1f times SEAR's" % (name, middle, min(each), max(each), 1e6 / middle,
                                                                                                  middle / mine))


if __name__ == "__main__":
    main()
