"""Rewards and ends of a custom environment, and their arguments."""
from math import hypot

import gymnasium
import numpy
from sear.gym import SearEnv

seen = []


def reward(robot):
    """Stores its arguments."""
    robot.memory["times"] = robot.memory.get("times", 0) + 1
    seen.append((robot.time, robot.x, robot.z, robot.moved, robot.memory["times"], robot.action))
    return 2 * robot.moved


env = SearEnv("examples/office.sear", actions=[(0.2, 0.2), (0.1, -0.1)], reward=reward, done=lambda robot: robot.x > -1.5, steps_per_action=12,
              max_seconds=4, things=["plant"])
observation, _ = env.reset(seed=1)
parts = env.parts(observation)
assert list(parts) == ["myLidar", "leftFrontPing", "rightFrontPing", "plant"]
assert parts["myLidar"].shape == (181,) and parts["leftFrontPing"].shape == (1,)
assert abs(hypot(*parts["plant"][:2]) - hypot(3.6 + 2, 2.6 + 1)) < 0.01, "how far the plant is"
total = 0
ended = late = False
while not (ended or late):
    observation, gain, ended, late, _ = env.step(0)
    total += gain
    assert numpy.array_equal(env.robot["myLidar"], env.parts(observation)["myLidar"])
    assert isinstance(env.robot["leftFrontPing"], float) and isinstance(env.robot.bumped, (bool, numpy.bool_))
assert ended and not late and env.robot.x > -1.5, env.robot
assert abs(total - 2 * env.robot.path) < 1e-6 and abs(env.robot.path - 0.5) < 0.06, "north, from x = -2"
assert [one[4] for one in seen] == list(range(1, len(seen) + 1)) and seen[0][0] == 12 / 60

seen.clear()
env.reset()
while not late:
    observation, gain, ended, late, _ = env.step(1)
assert len(seen) == 20 and seen[0][4] == 1, "4 s; what was remembered is forgotten"
assert env.robot.turned < -90 and -180 < env.robot.heading <= 180 and abs((env.robot.heading + env.robot.turned + 180) % 360 - 180) < 0.01 and seen[-1][5] == 1, "to the right"

# default: distance moved, less 1 for a bump, which ends the episode
env = SearEnv("examples/office.sear", sensors=["myLidar"], actions=[(0.5, 0.5)], start=[(3.2, 0.6, 90)])
env.reset(seed=2)
assert abs(env.robot.x - 3.2) < 1e-6 and abs(env.robot.heading - 90) < 1e-3
gains = []
ended = False
while not ended:
    _, gain, ended, late, _ = env.step(0)
    gains.append(gain)
assert env.robot.bumped and -1 <= gains[-1] < -0.9 and all(gain >= 0 for gain in gains[:-1]), gains
assert abs(sum(gains) + 1 - env.robot.path) < 1e-6
# the maze: a new cell, then the goal
env = gymnasium.make("SEAR/Maze-v0")
env.reset(seed=1, options={"start": (-2, 0.4, 90)})
gains = []
ended = late = False
while not (ended or late):
    _, gain, ended, late, _ = env.step(0)
    gains.append(round(gain, 6))
assert ended and gains[0] == 0.99 and sorted(set(gains)) == [-0.01, 0.99, 9.99] and gains.count(0.99) == 2 and gains[-1] == 9.99, gains
print("rewards as they are to be")
