# SPDX-License-Identifier: Apache-2.0
"""The registered environments: example projects, each with a reward. Arguments of SearEnv override the values set
here."""
from math import hypot

from ._env import SearEnv, crashed

# ---- SEAR/WallFollow-v0 -------------------------------------------------------------------------------------------------------------------------
WALL_WANTED = 0.5     # metres from the scanner to the wall on the right
WALL_WIDTH = 0.3      # metres from the wanted distance at which the reward ends
WALL_CRASH = -3
WALL_STARTS = [(1.2, 2.45, 0), (0.4, 2.45, 0), (2.3, -2.5, 180), (-0.2, -2.5, 180), (-3.45, -1.6, 90)]    # walls on the right
WALL_ACTIONS = [(0.25, 0.25), (0.18, 0.3), (0.3, 0.18), (-0.12, 0.12), (0.25, 0.05)]    # straight, left, right, left in place, sharp right


def wall_reward(robot):
    """Returns the metres driven forward, weighted by how close the distance on the right is to the wanted one."""
    right = float(robot["myLidar"][:61].min())
    share = max(0.0, 1 - abs(right - WALL_WANTED) / WALL_WIDTH)
    return robot.moved * share + (WALL_CRASH if crashed(robot) else 0)


class WallFollow(SearEnv):
    """A Roomba with a LIDAR of 181 beams in an office has to keep half a metre from objects on its right."""

    def __init__(self, **given):
        super().__init__(**{"project": "examples/office.sear", "sensors": ["myLidar"], "actions": WALL_ACTIONS, "reward": wall_reward,
                            "start": WALL_STARTS, **given})


# ---- SEAR/LineFollow-v0 -------------------------------------------------------------------------------------------------------------------------
LINE_SENSORS = ["leftLine", "middleLine", "rightLine"]
LINE_DARK = 50        # per cent of light
LINE_PATIENCE = 0.5   # seconds without the line
LINE_ACTIONS = [(0.2, 0.2), (0.08, 0.2), (0.2, 0.08), (-0.05, 0.15), (0.15, -0.05)]


def _dark(robot):
    return [robot[name] < LINE_DARK for name in LINE_SENSORS]


def line_reward(robot):
    """Returns the metres driven forward on the line; half of them if only an outer sensor sees the line."""
    left, middle, right = _dark(robot)
    return robot.moved * (1 if middle else 0.5 if left or right else -1)


def line_done(robot):
    """Whether the robot has lost the line or crashed."""
    if any(_dark(robot)):
        robot.memory["seen"] = robot.time
    return robot.time - robot.memory.get("seen", 0) > LINE_PATIENCE or crashed(robot)


def line_start(random):
    """Returns a start on the tape, looking roughly along it."""
    return 0.85, 0.0, 90 + random.uniform(-15, 15)


class LineFollow(SearEnv):
    """A small robot with three line sensors has to follow a track of black tape."""

    def __init__(self, **given):
        super().__init__(**{"project": "examples/line.sear", "sensors": LINE_SENSORS, "actions": LINE_ACTIONS, "reward": line_reward,
                            "done": line_done, "start": line_start, **given})


# ---- SEAR/Maze-v0 -------------------------------------------------------------------------------------------------------------------------------
MAZE_CELL = 0.8
MAZE_GOAL = 0.45      # metres to the middle of the cone
MAZE_ACTIONS = [(0.3, 0.3), (0.15, 0.3), (0.3, 0.15), (-0.15, 0.15), (0.15, -0.15)]


def maze_reward(robot):
    """Returns 1 for each newly entered cell, 10 for the goal, less a little for time and bumps."""
    cells = robot.memory.setdefault("cells", {(-3, -3)})
    cell = (int(robot.x // MAZE_CELL), int(robot.z // MAZE_CELL))
    new = cell not in cells
    cells.add(cell)
    return new - 0.01 - 0.1 * robot.bumped + 10 * _at_goal(robot)


def _at_goal(robot):
    ahead, left = robot["goal"][:2]
    return hypot(ahead, left) < MAZE_GOAL


def maze_done(robot):
    """Whether the robot is at the goal, or has overturned."""
    return _at_goal(robot) or robot.tilt > 60


class Maze(SearEnv):
    """A Roomba with three infrared sensors, which observes the goal's pose, has to find its way to the goal."""

    def __init__(self, **given):
        super().__init__(**{"project": "examples/maze.sear", "sensors": ["frontEye", "leftEye", "rightEye"], "things": ["goal"],
                            "actions": MAZE_ACTIONS, "reward": maze_reward, "done": maze_done, **given})


# ---- SEAR/Docking-v0 ----------------------------------------------------------------------------------------------------------------------------
DOCK = (2.787, -0.4)  # x and z of a docked robot: its front is 4 cm from the dock
DOCK_NEAR = 0.03      # tolerances of a docked robot: metres, and degrees from north
DOCK_STRAIGHT = 8
DOCK_ACTIONS = 0.3    # m/s


def _away(robot):
    return hypot(DOCK[0] - robot.x, DOCK[1] - robot.z)


def docked(robot):
    """Whether the robot is at its place and looks at the dock."""
    return _away(robot) < DOCK_NEAR and abs(robot.heading) < DOCK_STRAIGHT


def dock_reward(robot):
    """Returns the metres by which the robot has approached its place; 5 when docked, -2 for a bump."""
    before = robot.memory.get("away", _away(robot))
    robot.memory["away"] = _away(robot)
    return before - _away(robot) + 5 * docked(robot) - 2 * crashed(robot)


def dock_done(robot):
    """Whether the robot has docked or crashed."""
    return docked(robot) or crashed(robot)


def dock_start(random):
    """Returns a start in the middle of the room, looking roughly towards the dock."""
    return random.uniform(0.2, 1.2), random.uniform(-1.2, 0.4), random.uniform(-25, 25)


class Docking(SearEnv):
    """A Create 2, which observes the pose of the dock's marker like a camera does, has to stop right in front of it."""

    def __init__(self, **given):
        super().__init__(**{"project": "examples/dock.sear", "sensors": [], "things": ["dock marker"], "actions": DOCK_ACTIONS,
                            "reward": dock_reward, "done": dock_done, "start": dock_start, **given})
