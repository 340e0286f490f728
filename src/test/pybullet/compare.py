#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the import of URDFs with the files, by numpy, and with PyBullet: joints, mass, tensor and frames.

./gradlew -q urdfReport -Pfolder=FOLDER > report.txt
pip install pybullet "numpy<2"
python src/test/pybullet/compare.py FOLDER report.txt
"""
import json
import os
import re
import sys
import xml.etree.ElementTree

import numpy
import pybullet

MOVABLE = (pybullet.JOINT_REVOLUTE, pybullet.JOINT_PRISMATIC)
LIGHT = 0.001       # kg: SEAR's least mass of a moving link


def numbers(element, attribute, missing):
    text = "" if element is None else element.get(attribute, "")
    text = re.sub(r"\$\(optenv\s+\S+\s*([^)]*)\)", r"\1", text)
    return [float(word) for word in text.replace(",", " ").split()][:len(missing)] or missing


def pose(of):
    """Returns the 4x4 matrix of an <origin>."""
    origin = None if of is None else of.find("origin")
    r, p, y = numbers(origin, "rpy", [0, 0, 0])
    made = numpy.eye(4)
    made[:3, :3] = turn([0, 0, 1], y) @ turn([0, 1, 0], p) @ turn([1, 0, 0], r)
    made[:3, 3] = numbers(origin, "xyz", [0, 0, 0])
    return made


def turn(axis, angle):
    x, y, z = numpy.array(axis) / numpy.linalg.norm(axis)
    k = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return numpy.eye(3) + numpy.sin(angle) * k + (1 - numpy.cos(angle)) * k @ k


def matrix(position, quaternion):
    made = numpy.eye(4)
    made[:3, :3] = numpy.array(pybullet.getMatrixFromQuaternion(quaternion)).reshape(3, 3)
    made[:3, 3] = position
    return made


def about_origin(mass, centre, tensor):
    return tensor + mass * (centre @ centre * numpy.eye(3) - numpy.outer(centre, centre))


def tensor(element):
    xx, yy, zz, xy, xz, yz = [numbers(element, name, [0])[0] for name in ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")]
    return numpy.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def from_file(path, positions):
    """Returns number of joints, frames by link, and mass and tensor about the base's frame by rigid body."""
    text = open(path, encoding="latin-1").read()
    text = re.sub(r"<(/?)\w+:", r"<\1", text)      # prefixes without a namespace
    robot = xml.etree.ElementTree.fromstring(re.sub(r"<\?xml.*?\?>", "", text[:text.index("</robot>") + 8]).strip())
    joints = {joint.find("child").get("link"): joint for joint in robot.findall("joint")}
    frames, bodies = {}, {}

    def frame(link):
        if link not in frames:
            frames[link], bodies[link] = numpy.eye(4), link
            if link in joints:
                joint = joints[link]
                above = joint.find("parent").get("link")
                moved, axis = numpy.eye(4), numbers(joint.find("axis"), "xyz", [1, 0, 0])
                if joint.get("type") == "prismatic":
                    moved[:3, 3] = numpy.array(axis) / numpy.linalg.norm(axis) * positions[joint.get("name")]
                elif joint.get("type") in ("revolute", "continuous"):
                    moved[:3, :3] = turn(axis, positions[joint.get("name")])
                frames[link] = frame(above) @ pose(joint) @ moved
                bodies[link] = bodies[above] if joint.get("type") == "fixed" else link
        return frames[link]

    masses, tensors = {}, {}
    for link in robot.findall("link"):
        name, inertial = link.get("name"), link.find("inertial")
        at = frame(name) @ pose(inertial)
        mass = 0 if inertial is None else numbers(inertial.find("mass"), "value", [0])[0]
        own = numpy.zeros((3, 3)) if inertial is None else tensor(inertial.find("inertia"))
        body = bodies[name]
        masses[body] = masses.get(body, 0) + mass
        tensors[body] = tensors.get(body, 0) + about_origin(mass, at[:3, 3], at[:3, :3] @ own @ at[:3, :3].T)
    count = sum(joint.get("type") in ("prismatic", "revolute", "continuous") for joint in joints.values())
    return count, frames, masses, tensors


def from_bullet(path, positions):
    """Returns number of joints, and frames by link relative to that of the base."""
    body = pybullet.loadURDF(path)
    info = [pybullet.getJointInfo(body, i) for i in range(pybullet.getNumJoints(body))]
    for one in info:
        if one[2] in MOVABLE:
            pybullet.resetJointState(body, one[0], positions.get(one[1].decode(), 0))
    dynamics = pybullet.getDynamicsInfo(body, -1)
    base = matrix(*pybullet.getBasePositionAndOrientation(body)) @ numpy.linalg.inv(matrix(dynamics[3], dynamics[4]))
    frames = {"": numpy.eye(4)}
    for one in info:
        state = pybullet.getLinkState(body, one[0], computeForwardKinematics=True)
        frames[one[12].decode()] = numpy.linalg.inv(base) @ matrix(state[4], state[5])
    return sum(one[2] in MOVABLE for one in info), frames


def compare(folder, line):
    path = os.path.join(folder, line["file"])
    count, frames, masses, tensors = from_file(path, line["joints"])
    errors = dict.fromkeys(("frame", "PyBullet's frame", "mass", "tensor"), 0)
    bullet_count, bullet = None, {}
    try:
        pybullet.resetSimulation()
        os.chdir(os.path.dirname(path))
        bullet_count, bullet = from_bullet(path, line["joints"])
    except Exception:           # PyBullet refuses the file
        pass
    untold = 0
    for name, (mass, at, of) in line["bodies"].items():
        link = name or line["root"]
        own = matrix(at[:3], at[3:])
        errors["frame"] = max(errors["frame"], abs(own - frames[link]).max())
        if name in bullet:
            errors["PyBullet's frame"] = max(errors["PyBullet's frame"], abs(own - bullet[name]).max())
        if masses[link] < LIGHT:
            continue
        errors["mass"] = max(errors["mass"], abs(mass / masses[link] - 1))
        if of:
            xx, yy, zz, xy, xz, yz = of[3:]
            made = about_origin(mass, own[:3, :3] @ of[:3] + own[:3, 3], own[:3, :3] @ numpy.array(
                [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) @ own[:3, :3].T)
            errors["tensor"] = max(errors["tensor"], abs(made - tensors[link]).max() / abs(tensors[link]).max())
        else:
            untold += 1
    good = count == len(line["joints"]) and max(errors.values()) < 1e-5 and bullet_count in (None, count)
    print("%s | %s | %d joints%s | %s%s | %.1f m, %.1f s | %s" % ("equal" if good else "DIFFERS", line["file"], count,
        "" if bullet_count == count else ", in PyBullet " + str(bullet_count), ", ".join("%s %.0e" % one for one in
        errors.items()), ", %d bodies with the tensor of their shapes" % untold if untold else "", line["far"],
        line["seconds"], "; ".join(line["notes"])))
    return good


def main(folder, report):
    pybullet.connect(pybullet.DIRECT)
    loaded = equal = refused = 0
    for text in open(report).readlines():
        line = json.loads(text) if text.startswith("{") else {}
        if "error" in line:
            print("refused |", line["file"], "|", line["error"])
            refused += 1
        elif line:
            loaded += 1
            equal += compare(folder, line)
    print("%d refused, %d loaded, of these %d equal" % (refused, loaded, equal))


if __name__ == "__main__":
    main(os.path.abspath(sys.argv[1]), sys.argv[2])
