# SPDX-License-Identifier: Apache-2.0
"""Goals of the measurements, and why some are missed."""

GOALS = {
    "fan room-20": 12, "fan room-100": 12, "fan room-1000": 12, "fan hills-110000": 12, "fan field-100000": 12, "fan field-13000000": 6,
    "single room-20": 4, "single room-100": 3.5, "single room-1000": 3, "single hills-110000": 2.5,
    "lidar-room-20": 1000, "lidar-room-1000": 500, "all-room-20": 300, "all-room-1000": 200,
    "camera-room-20": 10, "blind-room-20": 10,
    "mesh seconds": 3, "mesh bytes": 150, "start": 1, "launch": 1.2, "memory": 256,
}
UNITS = {"mesh seconds": "below %g s", "mesh bytes": "below %g", "start": "below %g s", "launch": "below %g s", "memory": "below %g MiB"}
NAMES = {"mesh seconds": "seconds to build the hierarchy of a million triangles", "mesh bytes": "bytes per triangle",
         "start": "seconds from the start to the first reading", "launch": "seconds from the command to the script's first reading", "memory": "MiB of memory"}
# By the longest start of the goal's name that fits; counted, not estimated
REASONS = {
    "fan hills": "A scan's plane cuts about 300 triangles and opens 190 nodes; in `room-1000` it cuts 24 boxes and opens 81 nodes.",
    "fan field": "A scan's plane cuts about 400 triangles and opens 140 blocks of the pyramid.",
    "fan room-1000": "A scan opens 81 nodes and cuts 24 boxes; in `room-20` it opens 26 and cuts 10.",
    "single room-20": "It varies from run to run, 2.6 to 4.8 on such machines. By a profile, each of 10 nodes takes about 13 ns and each box 25 ns.",
    "single room-1000": "The boxes overlap: a beam opens 44 nodes and tests 12 boxes; in `room-20` it opens 10 and tests 1.",
    "single hills": "A beam opens 28 nodes and tests 3 triangles.",
    "single room-100": "So many boxes in 100 m² overlap; in `hall-100` as many do not.",
    "lidar-room-20": "The machine is slow: so are the other engines, as the line above shows.",
    "lidar-room-1000": "LIDAR and wheels search 1000 boxes that overlap; in `1000 boxes in a hall` they do not.",
    "all-room": "Beams and wheels search 1000 boxes that overlap.",
    "camera-room": "A picture of 320 x 240 with shadows takes about 15 ms on one core; two cores share it.",
    "start": "Each object is a file, read and checked while the JVM still compiles. The project with 1000 objects takes longest.",
    "launch": "The JVM, Jython, the tabs' server and SEAR load in parallel where they are independent; two cores share the work.",
    "mesh seconds": "One thread builds the hierarchy.",
    "memory": "Garbage accumulates between collections; the table shows the size of the live objects.",
}
# Millions of beams per second of the other engines on the goals' machine
REFERENCE = {("MuJoCo", "room-20"): 5.5, ("pybullet", "room-20"): 0.55, ("jbullet", "room-20"): 0.27, ("pybullet", "hall-100"): 0.45,
             ("MuJoCo", "hall-100"): 3.7, ("pybullet", "hall-1000"): 0.41, ("MuJoCo", "hall-1000"): 1.1}
UNKNOWN = "The reason is unknown."


def shown(key):
    return UNITS.get(key, "%g") % GOALS[key]


def name(key):
    if key in NAMES:
        return NAMES[key]
    if " " in key:
        return "million beams per second, " + key
    return "simulated seconds per second, " + key


def reason(key):
    """Returns why a goal is missed."""
    fitting = [start for start in REASONS if key.startswith(start)]
    return REASONS[max(fitting, key=len)] if fitting else UNKNOWN
