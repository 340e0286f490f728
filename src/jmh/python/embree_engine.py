# SPDX-License-Identifier: Apache-2.0
"""The beam worlds of the benchmark in Embree, which knows only triangles: a box is twelve of them. Default settings;
one thread."""
from importlib.metadata import version

import numpy
from embreex.mesh_construction import TriangleMesh
from embreex.rtcore_scene import EmbreeScene

NAME = "Embree"
VERSION = version("embreex")
NONE = -1
CORNERS = numpy.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
# Corners of the triangles of a box, two per side
SIDES = numpy.array([(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1),
                     (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3)])


def corners(box):
    """Returns the eight corners of a box, metres."""
    x, y, z, w = box[6:10]
    turn = numpy.array(((1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
                        (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
                        (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y))))
    return numpy.array(box[3:6]) + (CORNERS * box[0:3]) @ turn.T


class Beams:
    """Scans of a beam world, with embreex's run method."""

    def __init__(self, world):
        if world["indices"]:
            vertices = numpy.array(world["vertices"]).reshape(-1, 3)
            indices = numpy.array(world["indices"]).reshape(-1, 3)
        else:
            vertices = numpy.concatenate([corners(box) for box in world["boxes"]])
            indices = numpy.concatenate([SIDES + len(CORNERS) * i for i in range(len(world["boxes"]))])
        self.scene = EmbreeScene()
        self.mesh = TriangleMesh(self.scene, vertices.astype(numpy.float32), indices.astype(numpy.int32))
        count = world["beams"]
        self.starts = [numpy.tile(numpy.array(origin, dtype=numpy.float32), (count, 1)) for origin in world["origins"]]
        self.directions = numpy.array(world["directions"], dtype=numpy.float32).reshape(len(self.starts), count, 3)
        self.range = world["range"]
        self.limits = numpy.full(count, self.range, dtype=numpy.float32)
        # Builds the hierarchy, which happens in the first scan
        self.scan(0)

    def scan(self, i):
        # It writes into the limits and returns them
        return self.scene.run(self.starts[i], self.directions[i], dists=self.limits.copy(), query="DISTANCE")

    def ranges(self, i):
        """Returns metres, NONE without a hit within the range."""
        return [d if d < self.range else NONE for d in self.scan(i).tolist()]
