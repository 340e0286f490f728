"""The goals that measurements are held against, and why those that are missed are missed."""

GOALS = {
    "fan room-20": 12, "fan room-100": 12, "fan room-1000": 12, "fan hills-110000": 12, "fan field-100000": 12, "fan field-13000000": 6,
    "single room-20": 4, "single room-100": 3.5, "single room-1000": 3, "single hills-110000": 2.5,
    "lidar-room-20": 1000, "lidar-room-1000": 500, "all-room-20": 300, "all-room-1000": 200,
    "camera-room-20": 10, "blind-room-20": 10,
    "mesh seconds": 3, "mesh bytes": 150, "start": 1, "launch": 1.2, "memory": 256,
}
UNITS = {"mesh seconds": "below %g s", "mesh bytes": "below %g", "start": "below %g s", "launch": "below %g s", "memory": "below %g MiB"}
NAMES = {"mesh seconds": "seconds to build the hierarchy of a million triangles", "mesh bytes": "bytes a triangle",
         "start": "seconds from the start to the first reading", "launch": "seconds from the command to the script's first reading", "memory": "MiB of memory"}
# By the start of the goal's name, the longest that fits; what was counted, not guessed
REASONS = {
    "fan hills": "The plane of a scan cuts about 300 triangles and opens 190 nodes for its 361 beams, so that nearly every beam meets a "
                 "triangle of its own; in `room-1000` it is 24 boxes and 81 nodes.",
    "fan field": "The plane of a scan cuts about 400 triangles and opens 140 blocks of the pyramid for its 361 beams, so that nearly every beam meets "
                 "a triangle of its own.",
    "fan room-1000": "So full a room makes a scan open 81 nodes and cut 24 boxes; in `room-20` it is 26 and 10.",
    "single room-20": "It changes from run to run, 2.6 to 4.8 on machines of this kind: about 13 ns for each of the 10 nodes that a beam opens and 25 ns for "
                      "each box, by a profile, and the rest to set out.",
    "single room-1000": "The boxes of so full a room overlap: a single beam opens 44 nodes and tests 12 boxes; in `room-20` it is 10 and 1. "
                       "Nodes of four children go at 0.9 to 1.07 times this speed, a walk without branches at 0.8, other trees as fast: "
                       "what is left is arithmetic, which other engines do for eight boxes at once.",
    "single hills": "A single beam opens 28 nodes of the hierarchy and tests 3 triangles.",
    "single room-100": "So many boxes in 100 m² overlap; `hall-100` has as many with room between them.",
    "lidar-room-20": "It is the machine: the line above says how much slower the other engines were on it, too.",
    "lidar-room-1000": "LIDAR and wheels look among 1000 boxes that overlap; `1000 boxes in a hall` has as many with room between them.",
    "all-room": "Beams and wheels look among 1000 boxes that overlap.",
    "camera-room": "A picture of 320 x 240 with shadows takes some 15 ms of one core; two cores share it.",
    "start": "Each object is a file of its own, read and checked while the JVM still compiles. The longest is that of the project with 1000 "
             "objects.",
    "launch": "The JVM, Jython, the tabs' server and SEAR are loaded at once as far as one does not need the other; two cores share it.",
    "mesh seconds": "One thread builds the hierarchy.",
    "memory": "Garbage gathers between two collections; the table has what the heap's objects themselves need.",
}
# What the other engines made in millions of beams a second where the goals were set
REFERENCE = {("MuJoCo", "room-20"): 5.5, ("pybullet", "room-20"): 0.55, ("jbullet", "room-20"): 0.27, ("pybullet", "hall-100"): 0.45,
             ("MuJoCo", "hall-100"): 3.7, ("pybullet", "hall-1000"): 0.41, ("MuJoCo", "hall-1000"): 1.1}
UNKNOWN = "Why has not been looked into."


def shown(key):
    return UNITS.get(key, "%g") % GOALS[key]


def name(key):
    if key in NAMES:
        return NAMES[key]
    if " " in key:
        return "millions of beams a second, " + key
    return "simulated seconds a second, " + key


def reason(key):
    """Why it is missed, as far as it is known."""
    fitting = [start for start in REASONS if key.startswith(start)]
    return REASONS[max(fitting, key=len)] if fitting else UNKNOWN
