# SPDX-License-Identifier: Apache-2.0
"""The worlds of the benchmark in MuJoCo: default settings except for the step of 1/60 s, and the implicitfast
integrator, which such a long step needs."""
import mujoco
import numpy

NAME = "MuJoCo"
VERSION = mujoco.__version__
STEP = 1 / 60
NONE = -1
# Arena for contacts, bytes: the default is too small for a thousand bodies
ARENA = "2G"
HEAD = '<mujoco><size memory="%s"/><option timestep="%.17g" gravity="0 -9.81 0" integrator="implicitfast"/>' % (ARENA, STEP)


def box_xml(box, attributes=""):
    hx, hy, hz, x, y, z, qx, qy, qz, qw = box
    return '<geom type="box" size="%r %r %r" pos="%r %r %r" quat="%r %r %r %r" %s/>' % (hx, hy, hz, x, y, z, qw, qx, qy, qz, attributes)


class Beams:
    """Scans of a beam world, with mj_multiRay."""

    def __init__(self, world):
        self.range = world["range"]
        self.origins = numpy.array(world["origins"])
        self.directions = numpy.array(world["directions"]).reshape(len(self.origins), -1)
        self.count = world["beams"]
        if world["indices"]:
            spec = mujoco.MjSpec()
            mesh = spec.add_mesh(name="hills")
            mesh.uservert = numpy.array(world["vertices"], dtype=numpy.float32)
            mesh.userface = numpy.array(world["indices"], dtype=numpy.int32)
            mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL
            spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname="hills", contype=0, conaffinity=0)
            self.model = spec.compile()
        else:
            self.model = mujoco.MjModel.from_xml_string(
                "<mujoco><worldbody>" + "".join(box_xml(box) for box in world["boxes"]) + "</worldbody></mujoco>")
        self.data = mujoco.MjData(self.model)
        mujoco.mj_forward(self.model, self.data)
        self.geoms = numpy.zeros(self.count, dtype=numpy.int32)
        self.distances = numpy.zeros(self.count)

    def scan(self, i):
        mujoco.mj_multiRay(self.model, self.data, self.origins[i], self.directions[i], None, True, -1, self.geoms, self.distances, None,
                           self.count, self.range)
        return self.distances

    def ranges(self, i):
        """Returns metres, NONE without a hit within the range."""
        return [d if 0 <= d <= self.range else NONE for d in self.scan(i).tolist()]


class Drop:
    """Boxes that fall on a floor."""

    def __init__(self, world):
        half = world["side"] / 2
        bodies = []
        for box in world["boxes"]:
            hx, hy, hz, x, y, z, qx, qy, qz, qw = box
            bodies.append('<body pos="%r %r %r" quat="%r %r %r %r"><freejoint/><geom type="box" size="%r %r %r" mass="%r"/></body>'
                          % (x, y, z, qw, qx, qy, qz, hx, hy, hz, world["mass"]))
        self.model = mujoco.MjModel.from_xml_string(HEAD + "<worldbody>" + box_xml((half, 0.05, half, 0, -0.05, 0, 0, 0, 0, 1)) + "".join(bodies)
                                                    + "</worldbody></mujoco>")
        self.data = mujoco.MjData(self.model)

    def reset(self):
        mujoco.mj_resetData(self.model, self.data)

    def step(self):
        mujoco.mj_step(self.model, self.data)

    def heights(self):
        return self.data.qpos[1::7].tolist()


# Rotations of a MuJoCo cylinder's axis from z to y and to x
UPRIGHT = "0.70710678 0.70710678 0 0"
AXLE = "0.70710678 0 0.70710678 0"


def wheel_xml(name, x, z, driven):
    contact = 'friction="1 0.005 0.0001"' if driven else 'condim="1" priority="1"'
    return ('<body pos="%r -0.03 %r"><joint name="%s" type="hinge" axis="1 0 0"/>' % (x, z, name)
            + '<geom type="cylinder" size="0.0381 0.015" quat="%s" mass="0.2" %s/></body>' % (AXLE, contact))


class Drive:
    """A robot on four wheels, two of them driven, in a room; LIDARs on top."""

    def __init__(self, world):
        self.world = world
        half = world["side"] / 2
        walls = box_xml((half, 0.05, half, 0, -0.05, 0, 0, 0, 0, 1)) + "".join(box_xml(box) for box in world["boxes"])
        robot = ('<body name="robot" pos="%r %r 0"><freejoint/><geom type="cylinder" size="0.1666875 0.0381" quat="%s" mass="40"/>'
                 % (-world["circle"], world["startHeight"], UPRIGHT)
                 + wheel_xml("left", 0.16, 0.0, True) + wheel_xml("right", -0.16, 0.0, True)
                 + wheel_xml("front", 0.0, 0.16, False) + wheel_xml("back", 0.0, -0.16, False) + "</body>")
        motors = '<actuator><velocity joint="left" kv="10"/><velocity joint="right" kv="10"/></actuator>'
        self.model = mujoco.MjModel.from_xml_string(HEAD + "<worldbody>" + walls + robot + "</worldbody>" + motors + "</mujoco>")
        self.data = mujoco.MjData(self.model)
        self.data.ctrl[:] = [world["speed"] * (1 + side * 0.16 / world["circle"]) / 0.0381 for side in (-1, 1)]
        mujoco.mj_forward(self.model, self.data)
        self.robot = self.model.body("robot").id
        angles = numpy.radians(numpy.arange(361) * 0.5 - 90)
        self.fans = []
        for i in range(world["lidars"]):
            turned = angles + 2 * numpy.pi * i / world["lidars"]
            self.fans.append(numpy.stack([numpy.sin(turned), numpy.zeros(361), numpy.cos(turned)], axis=1))
        self.geoms = numpy.zeros(361, dtype=numpy.int32)
        self.distances = numpy.zeros(361)
        self.steps = 0

    def step(self):
        mujoco.mj_step(self.model, self.data)
        self.steps += 1
        if self.steps % self.world["scanEvery"] == 0:
            turn = self.data.xmat[self.robot].reshape(3, 3)
            for i, fan in enumerate(self.fans):
                origin = self.data.xpos[self.robot] + turn[:, 1] * (self.world["lidarHeight"] + i * self.world["lidarPitch"])
                mujoco.mj_multiRay(self.model, self.data, origin, (fan @ turn.T).ravel(), None, True, self.robot, self.geoms, self.distances, None,
                                   361, self.world["range"])

    def position(self):
        """Returns x and z of the robot, metres."""
        return self.data.xpos[self.robot][0], self.data.xpos[self.robot][2]
