"""Cameras are observed as pictures, GPS receivers in metres."""
import gymnasium
import numpy
import sear.gym
from gymnasium import spaces
from gymnasium.utils.env_checker import check_env
from sear.gym import SearEnv

LINE = "examples/line.sear"

alone = SearEnv(LINE, sensors=["eye"], steps_per_action=12)
height, width, _ = alone.observation_space.shape
assert alone.observation_space == spaces.Box(0, 255, (height, width, 3), numpy.uint8), alone.observation_space
first, _ = alone.reset(seed=1)
assert first in alone.observation_space and len(numpy.unique(first)) > 3
kept = first.copy()
second = alone.step([0.5, 0.2])[0]
assert numpy.array_equal(first, kept) and not numpy.array_equal(first, second)
assert numpy.array_equal(alone.robot["eye"], second) and list(alone.robot) == ["eye"]
assert numpy.array_equal(alone.parts(second)["eye"], second)
assert numpy.array_equal(alone.reset(seed=1)[0], kept)
check_env(alone)

both = SearEnv(LINE, sensors=["eye", "leftLine"], things=[], steps_per_action=12)
assert isinstance(both.observation_space, spaces.Dict)
assert {name: (space.shape, space.dtype) for name, space in both.observation_space.items()} == {
    "leftLine": ((1,), numpy.float32), "eye": ((height, width, 3), numpy.uint8)}
seen = both.reset(seed=1)[0]
assert seen in both.observation_space and numpy.array_equal(seen["eye"], kept) and both.parts(seen)["leftLine"] == both.robot["leftLine"]
check_env(both)
assert list(SearEnv(LINE).robot) == ["leftLine", "middleLine", "rightLine"], "no pictures unless asked for"

sear.start(headless=True)
runtime = sear.Runtime.start("sear", "SEAR")
runtime.newProject()
sear.Floor("floor", 20, 20)
rover = sear.Robots.rover("rover")
rover.addComponent(sear.GPS("gps", 47.5, 300, 11.25))
rover.move(1.5, 0, -2.25)
env = SearEnv("SEARproject", sensors=["gps"])
at = env.reset(seed=1)[0]
assert env.observation_space.shape == (3,) and abs(at[0] - 1.5) < 1e-3 and abs(at[2] + 2.25) < 1e-3, at
start = env.robot.z
for step in range(20):
    at = env.step([0.02, 0.02])[0]
assert env.robot.z - start > 0.03 and abs((at[2] + 2.25) - (env.robot.z - start)) < 1e-3, (at, env.robot.z)

for text, given in (("robot rover observes nothing: sensors and things are empty, legal: sensors of gps, or names of objects in things",
                     {"sensors": []}),):
    try:
        SearEnv("SEARproject", **given)
    except ValueError as error:
        assert str(error) == text, error
    else:
        raise AssertionError(text)
runtime.newProject()
sear.Floor("floor", 20, 20)
sear.Robots.rover("rover")
try:
    SearEnv("SEARproject")
except ValueError as error:
    assert str(error) == ("robot rover observes nothing: sensors and things are empty, legal: names of objects in things, because the robot has "
                          "no sensors"), error
else:
    raise AssertionError("no sensors")
assert gymnasium.make("SEAR/Docking-v0").reset(seed=1)
print("pictures and metres")
