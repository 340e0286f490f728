# SPDX-License-Identifier: Apache-2.0
"""Compares models as SEAR reads them with trimesh: number of triangles, bounding box, area, volume, centre, inertia.

./gradlew -q modelReport -Pmodels=FOLDER > report.txt
pip install trimesh pycollada scipy
python src/test/trimesh/compare.py FOLDER report.txt
"""
import json
import os
import re
import sys

import numpy
import trimesh

UP = {"X_UP": [[0, -1, 0], [1, 0, 0], [0, 0, 1]], "Z_UP": [[1, 0, 0], [0, 0, 1], [0, -1, 0]]}


def load(path):
    """Returns one mesh, in SEAR's frame and metres."""
    mesh = trimesh.load(path, force="mesh", process=False, ignore_broken=True)
    turn = numpy.eye(4)
    if path.lower().endswith(".dae"):
        text = open(path, encoding="utf-8").read()
        unit = re.search(r"<unit[^>]*meter=['\"]([^'\"]*)", text)
        axis = re.search(r"<up_axis>(\w+)", text)
        turn[:3, :3] = UP.get(axis.group(1) if axis else "", numpy.eye(3))
        turn *= float(unit.group(1)) if unit else 1
        turn[3, 3] = 1
    mesh.apply_transform(turn)
    mesh.merge_vertices(merge_tex=True, merge_norm=True)
    return mesh


def compare(path, seen):
    """Returns the largest relative difference of each measure."""
    mesh = load(path)
    used = mesh.vertices[numpy.unique(mesh.faces)]
    triangles, box, area, volume, centre, inertia = seen
    size = max(used.max(0) - used.min(0))
    found = {"triangles": abs(triangles - len(mesh.faces)) / len(mesh.faces),
             "box": numpy.abs(numpy.r_[used.min(0), used.max(0)] - box).max() / size,
             "area": abs(area - mesh.area) / mesh.area}
    closed = mesh.is_watertight and mesh.is_winding_consistent and mesh.volume > 0
    if closed:
        found["volume"] = abs(volume - mesh.volume) / mesh.volume
        found["centre"] = numpy.abs(mesh.center_mass - centre).max() / size
        tensor = mesh.moment_inertia / mesh.volume
        found["inertia"] = numpy.abs(tensor - inertia).max() / numpy.abs(tensor).max()
    return found


def main(folder, report):
    worst, loaded, refused = {}, 0, 0
    for line in open(report):
        name, *texts, seen = json.loads(line)
        if isinstance(seen, str):
            refused += 1
            print(name, "REFUSED", seen)
            continue
        loaded += 1
        for text in texts:
            print(name, "WARNING", text)
        try:
            found = compare(os.path.join(folder, name), seen)
        except Exception as error:  # pylint: disable=broad-except
            print(name, "trimesh:", repr(error)[:100])
            continue
        for measure, value in found.items():
            if value > worst.get(measure, (-1,))[0]:
                worst[measure] = (float(value), name)
        if max(found.values()) > 1e-3:
            print(name, {measure: "%.2g" % value for measure, value in found.items() if value > 1e-3})
    print(loaded, "loaded,", refused, "refused; largest relative differences:")
    for measure, value in worst.items():
        print("%10s %.2g %s" % (measure, *value))


if __name__ == "__main__":
    main(*sys.argv[1:])
