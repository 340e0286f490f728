# SPDX-License-Identifier: Apache-2.0
"""The worlds of the benchmark in pybullet: default settings except for the step of 1/60 s; one thread."""
import os
import tempfile

import numpy
import pybullet

NAME = "pybullet"
VERSION = "3.2.7"
try:
    from importlib.metadata import version
    VERSION = version("pybullet")
except ImportError:
    pass
STEP = 1 / 60
NONE = -1
# Rotations of a Bullet cylinder's axis from z to y and to x
UPRIGHT = (0.70710678, 0, 0, 0.70710678)
AXLE = (0, 0.70710678, 0, 0.70710678)


def start():
    pybullet.connect(pybullet.DIRECT)
    pybullet.setGravity(0, -9.81, 0)
    pybullet.setTimeStep(STEP)


def add_box(box, mass=0.0):
    shape = pybullet.createCollisionShape(pybullet.GEOM_BOX, halfExtents=box[0:3])
    return pybullet.createMultiBody(mass, shape, basePosition=box[3:6], baseOrientation=box[6:10])


def add_floor(world):
    half = world["side"] / 2
    add_box((half, 0.05, half, 0, -0.05, 0, 0, 0, 0, 1))


def add_hills(vertices, indices):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "hills.obj")
        with open(path, "w") as out:
            for i in range(0, len(vertices), 3):
                out.write("v %.9g %.9g %.9g\n" % tuple(vertices[i:i + 3]))
            for i in range(0, len(indices), 3):
                out.write("f %d %d %d\n" % (indices[i] + 1, indices[i + 1] + 1, indices[i + 2] + 1))
        shape = pybullet.createCollisionShape(pybullet.GEOM_MESH, fileName=path, flags=pybullet.GEOM_FORCE_CONCAVE_TRIMESH)
    pybullet.createMultiBody(0, shape)


class Beams:
    """Scans of a beam world, with rayTestBatch."""

    def __init__(self, world):
        start()
        self.range = world["range"]
        if world["indices"]:
            add_hills(world["vertices"], world["indices"])
        for box in world["boxes"]:
            add_box(box)
        count = world["beams"]
        directions = numpy.array(world["directions"]).reshape(len(world["origins"]), count, 3)
        self.starts = [[origin] * count for origin in world["origins"]]
        self.ends = [(numpy.array(origin) + self.range * fan).tolist() for origin, fan in zip(world["origins"], directions)]

    def scan(self, i):
        return pybullet.rayTestBatch(self.starts[i], self.ends[i], numThreads=1)

    def ranges(self, i):
        """Returns metres, NONE without a hit within the range."""
        return [hit[2] * self.range if hit[0] >= 0 else NONE for hit in self.scan(i)]


class Drop:
    """Boxes that fall on a floor."""

    def __init__(self, world):
        start()
        add_floor(world)
        self.boxes = world["boxes"]
        self.bodies = [add_box(box, world["mass"]) for box in self.boxes]

    def reset(self):
        for body, box in zip(self.bodies, self.boxes):
            pybullet.resetBasePositionAndOrientation(body, box[3:6], box[6:10])
            pybullet.resetBaseVelocity(body, (0, 0, 0), (0, 0, 0))

    def step(self):
        pybullet.stepSimulation()

    def heights(self):
        return [pybullet.getBasePositionAndOrientation(body)[0][1] for body in self.bodies]


class Drive:
    """A robot on four wheels, two of them driven, in a room; LIDARs on top."""

    def __init__(self, world):
        start()
        self.world = world
        add_floor(world)
        for box in world["boxes"]:
            add_box(box)
        hull = pybullet.createCollisionShape(pybullet.GEOM_CYLINDER, radius=0.1666875, height=0.0762, collisionFrameOrientation=UPRIGHT)
        wheel = pybullet.createCollisionShape(pybullet.GEOM_CYLINDER, radius=0.0381, height=0.03, collisionFrameOrientation=AXLE)
        places = ((0.16, -0.03, 0), (-0.16, -0.03, 0), (0, -0.03, 0.16), (0, -0.03, -0.16))
        straight = [(0, 0, 0, 1)] * 4
        self.robot = pybullet.createMultiBody(
            40, hull, basePosition=(-world["circle"], world["startHeight"], 0), linkMasses=[0.2] * 4, linkCollisionShapeIndices=[wheel] * 4,
            linkVisualShapeIndices=[-1] * 4, linkPositions=places, linkOrientations=straight, linkInertialFramePositions=[(0, 0, 0)] * 4,
            linkInertialFrameOrientations=straight, linkParentIndices=[0] * 4, linkJointTypes=[pybullet.JOINT_REVOLUTE] * 4,
            linkJointAxis=[(1, 0, 0)] * 4)
        for joint, side in ((0, -1), (1, 1)):
            speed = world["speed"] * (1 + side * 0.16 / world["circle"]) / 0.0381
            pybullet.changeDynamics(self.robot, joint, lateralFriction=1)
            pybullet.setJointMotorControl2(self.robot, joint, pybullet.VELOCITY_CONTROL, targetVelocity=speed, force=10)
        for joint in (2, 3):
            pybullet.changeDynamics(self.robot, joint, lateralFriction=0)
            pybullet.setJointMotorControl2(self.robot, joint, pybullet.VELOCITY_CONTROL, force=0)
        angles = numpy.radians(numpy.arange(361) * 0.5 - 90)
        self.fans = []
        for i in range(world["lidars"]):
            turned = angles + 2 * numpy.pi * i / world["lidars"]
            self.fans.append(world["range"] * numpy.stack([numpy.sin(turned), numpy.zeros(361), numpy.cos(turned)], axis=1))
        self.steps = 0

    def step(self):
        pybullet.stepSimulation()
        self.steps += 1
        if self.steps % self.world["scanEvery"] == 0:
            position, orientation = pybullet.getBasePositionAndOrientation(self.robot)
            turn = numpy.array(pybullet.getMatrixFromQuaternion(orientation)).reshape(3, 3)
            for i, fan in enumerate(self.fans):
                origin = position + turn[:, 1] * (self.world["lidarHeight"] + i * self.world["lidarPitch"])
                pybullet.rayTestBatch([origin.tolist()] * 361, (origin + fan @ turn.T).tolist(), numThreads=1)

    def position(self):
        """Returns x and z of the robot, metres."""
        position = pybullet.getBasePositionAndOrientation(self.robot)[0]
        return position[0], position[2]
