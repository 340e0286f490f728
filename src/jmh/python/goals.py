"""The goals that measurements are held against, and why those that are missed are missed."""

GOALS = {
    "fan room-20": 12, "fan room-100": 12, "fan room-1000": 12, "fan hills-110000": 12,
    "single room-20": 4, "single room-100": 3.5, "single room-1000": 3, "single hills-110000": 2.5,
    "lidar-room-20": 1000, "lidar-room-1000": 500, "all-room-20": 300, "all-room-1000": 200,
    "mesh seconds": 3, "mesh bytes": 150, "start": 1, "memory": 256,
}
UNITS = {"mesh seconds": "below %g s", "mesh bytes": "below %g", "start": "below %g s", "memory": "below %g MiB"}
NAMES = {"mesh seconds": "seconds to build the hierarchy of a million triangles", "mesh bytes": "bytes a triangle",
         "start": "seconds from the start to the first reading", "memory": "MiB of memory"}
# By the start of the goal's name
REASONS = {}


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
    return next((why for start, why in REASONS.items() if key.startswith(start)), "")
