# SPDX-License-Identifier: Apache-2.0
"""SEAR's worlds as Gymnasium environments for machine learning.

    import gymnasium
    import sear.gym
    env = gymnasium.make("SEAR/WallFollow-v0")

or with your own project: sear.gym.SearEnv("my.sear", actions=[(0.2, 0.2), (-0.1, 0.1)],
reward=lambda robot: robot.moved). See docs/learning.md.
"""
try:
    import gymnasium as _gymnasium
except ImportError as _error:
    raise ImportError("sear.gym needs Gymnasium: pip install gymnasium") from _error

from ._env import SearEnv
from ._robot import RobotState

__all__ = ["SearEnv", "RobotState"]

for _name, _seconds, _steps in (("Maze", 120, 12), ("WallFollow", 60, 6), ("LineFollow", 60, 3), ("Docking", 60, 6)):
    _gymnasium.register(id="SEAR/%s-v0" % _name, entry_point="sear.gym._tasks:%s" % _name,
                        kwargs={"max_seconds": _seconds, "steps_per_action": _steps})
