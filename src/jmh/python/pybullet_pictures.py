# SPDX-License-Identifier: Apache-2.0
"""Camera pictures in pybullet, with getCameraImage and its single-threaded TinyRenderer."""
import os
import tempfile

import numpy
import pybullet

from pybullet_engine import UPRIGHT

NEAR = 0.02
FAR = 100.0
COLOR = (0.7, 0.7, 0.65, 1)


def write_obj(path, thing):
    with open(path, "w") as out:
        vertices = thing["vertices"]
        indices = thing["indices"]
        for i in range(0, len(vertices), 3):
            out.write("v %.9g %.9g %.9g\n" % tuple(vertices[i:i + 3]))
        for i in range(0, len(indices), 3):
            out.write("f %d %d %d\n" % tuple(index + 1 for index in indices[i:i + 3]))


class Scene:
    """The world, and matrices for each pose."""

    def __init__(self, world, fast):
        pybullet.connect(pybullet.DIRECT)
        with tempfile.TemporaryDirectory() as folder:
            for i, thing in enumerate(world["things"]):
                self.add(thing, os.path.join(folder, "m%d.obj" % i))
        self.size = (world["width"], world["height"])
        self.sun = world["sun"]
        self.projection = pybullet.computeProjectionMatrixFOV(world["fovy"], world["width"] / world["height"], NEAR, FAR)
        self.views = []
        for pose in world["poses"]:
            turn = numpy.array(pybullet.getMatrixFromQuaternion(pose[3:])).reshape(3, 3)
            eye = numpy.array(pose[:3])
            self.views.append(pybullet.computeViewMatrix(eye.tolist(), (eye + turn[:, 2]).tolist(), turn[:, 1].tolist()))

    @staticmethod
    def add(thing, path):
        frame = (0, 0, 0, 1)
        if thing["kind"] == "box":
            shape = pybullet.createVisualShape(pybullet.GEOM_BOX, halfExtents=thing["half"], rgbaColor=COLOR)
        elif thing["kind"] == "cylinder":
            shape = pybullet.createVisualShape(pybullet.GEOM_CYLINDER, radius=thing["half"][0], length=2 * thing["half"][1], rgbaColor=COLOR,
                                               visualFrameOrientation=UPRIGHT)
        else:
            write_obj(path, thing)
            shape = pybullet.createVisualShape(pybullet.GEOM_MESH, fileName=path, rgbaColor=COLOR, visualFrameOrientation=frame)
        body = pybullet.createMultiBody(0, -1, shape, basePosition=thing["pose"][:3], baseOrientation=thing["pose"][3:])
        if "picture" in thing:
            pybullet.changeVisualShape(body, -1, textureUniqueId=pybullet.loadTexture(thing["picture"]), rgbaColor=(1, 1, 1, 1))

    def image(self, turn, shadow):
        return pybullet.getCameraImage(*self.size, viewMatrix=self.views[turn], projectionMatrix=self.projection, shadow=shadow,
                                       lightDirection=self.sun, renderer=pybullet.ER_TINY_RENDERER, flags=pybullet.ER_NO_SEGMENTATION_MASK)

    def colors(self, turn):
        return self.image(turn, 1)[2]

    def depth_buffer(self, turn):
        return self.image(turn, 0)[3]

    def depths(self, turn):
        """Returns the depths along the axis, metres."""
        return FAR * NEAR / (FAR - (FAR - NEAR) * numpy.array(self.depth_buffer(turn), dtype=float))
