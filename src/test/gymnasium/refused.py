"""Errors name the argument, its value and what is legal."""
import gymnasium
import numpy
import sear
import sear.gym
from sear.gym import SearEnv

OFFICE = "examples/office.sear"


def refused(kind, message, call, *given, **more):
    try:
        call(*given, **more)
    except kind as error:
        told = error.args[0]
        assert told == message, "%r instead of %r" % (told, message)
    else:
        raise AssertionError("not refused: " + message)


refused(FileNotFoundError, "project nowhere.sear does not exist; legal: a .sear file, or a folder SEARproject", SearEnv, "nowhere.sear")
refused(ValueError, "robot is \"rover\", legal: office Roomba", SearEnv, OFFICE, robot="rover")
refused(ValueError, "no sensor is called \"sonar\", legal: leftFrontPing, myLidar, rightFrontPing", SearEnv, OFFICE, sensors=["sonar"])
refused(ValueError, "robot office Roomba observes nothing: sensors and things are empty, legal: sensors of myLidar, leftFrontPing, rightFrontPing, "
        "or names of objects in things", SearEnv, OFFICE, sensors=[])
refused(ValueError, "actions is an empty list, legal: one or more (left, right)", SearEnv, OFFICE, actions=[])
refused(ValueError, "action 1 is (1,), legal: the speeds of the left and the right wheels, m/s, for example (0.2, 0.2)", SearEnv, OFFICE,
        actions=[(0, 0), (1,)])
refused(ValueError, "action 0 is (0, 11), legal: -10 to 10 m/s", SearEnv, OFFICE, actions=[(0, 11)])
refused(ValueError, "actions is -1, legal: a list of (left, right), the highest speed of the wheels, above 0 to 10 m/s, or a dictionary of "
        "the controls' ranges", SearEnv, OFFICE,
        actions=-1)
refused(ValueError, "steps_per_action is 0, legal: a whole number from 1 to 216000", SearEnv, OFFICE, steps_per_action=0)
refused(ValueError, "max_seconds is 0, legal: above 0, or None", SearEnv, OFFICE, max_seconds=0)
refused(ValueError, "render_mode is 'human', legal: \"rgb_array\" or None", SearEnv, OFFICE, render_mode="human")
refused(ValueError, "start is an empty list, legal: None, a list of (x, z, heading), or a function that returns one", SearEnv, OFFICE, start=[])
refused(ValueError, "start 0 is 0, legal: x and z in metres and heading in degrees", SearEnv, OFFICE, start=(0, 1, 90))
refused(ValueError, "steps_per_action is 1099511627776, legal: a whole number from 1 to 216000", SearEnv, OFFICE, steps_per_action=2 ** 40)
refused(ValueError, "max_seconds is 'a', legal: above 0, or None", SearEnv, OFFICE, max_seconds="a")
refused(ValueError, "actions is None, legal: a list of (left, right), the highest speed of the wheels, above 0 to 10 m/s, or a dictionary of "
        "the controls' ranges", SearEnv, OFFICE,
        actions=None)
refused(ValueError, "sensors is 'myLidar', legal: a list of names", SearEnv, OFFICE, sensors="myLidar")
refused(ValueError, "sensors is ['myLidar', 'myLidar'], legal: each name once", SearEnv, OFFICE, sensors=["myLidar", "myLidar"])
refused(ValueError, "reward is 3, legal: a function of the robot", SearEnv, OFFICE, reward=3)
refused(ValueError, "size is 5, legal: width and height in pixels, for example (480, 360)", SearEnv, OFFICE, size=5)
try:
    SearEnv(OFFICE, things=["moon"])
    raise AssertionError("there is no moon")
except sear.IllegalArgumentException as error:
    assert str(error).startswith("nothing is named \"moon\"; there are "), error

env = SearEnv(OFFICE, actions=[(0.2, 0.2)], sensors=["leftFrontPing"])
refused(RuntimeError, "call reset() before step()", env.step, 0)
env.reset(seed=1)
refused(ValueError, "action is 1, legal: a whole number from 0 to 0", env.step, 1)
refused(ValueError, "options has speed, legal: start, noise", env.reset, options={"speed": 1})
refused(KeyError, "myLidar is not observed, legal: leftFrontPing", env.robot.__getitem__, "myLidar")
refused(ValueError, "start is (1, 2), legal: x and z in metres and heading in degrees", env.reset, options={"start": (1, 2)})
for number in (None, "left", [0], 0.5, numpy.array([0])):
    refused(ValueError, "action is %r, legal: a whole number from 0 to 0" % (number,), env.step, number)
assert env.step(numpy.int64(0))[4] == env.step(numpy.array(0))[4] == {}
refused(ValueError, "actions is an empty dictionary, legal: a range for one or more controls", SearEnv, OFFICE, actions={})
refused(ValueError, "actions has 'speed': (1, 0), legal: the name of a control, and its lowest and highest value", SearEnv, OFFICE,
        actions={"speed": (1, 0)})
refused(ValueError, "action 1 is {'speed': 1}, legal: a number for each of left, right", SearEnv, OFFICE,
        actions=[{"left": 0, "right": 0}, {"speed": 1}])
refused(ValueError, "robot office Roomba has no motor or servo \"arm\" for actions, legal: left and right, speed, steering", SearEnv, OFFICE,
        actions={"arm": (0, 1)})
refused(ValueError, "robot office Roomba: actions set left, legal: left and right, or speed alone", SearEnv, OFFICE, actions={"left": (0, 1)})
refused(ValueError, "robot office Roomba: speed is 11, legal: -10 to 10", SearEnv, OFFICE, actions={"speed": (0, 11)})
refused(ValueError, "robot office Roomba has no steered wheels: wheel.setSteering(30) makes one", SearEnv, OFFICE, actions=[{"steering": 1}])
for answer in (None, float("nan"), "much"):
    odd = SearEnv(OFFICE, reward=lambda robot: answer, steps_per_action=numpy.int64(1))
    odd.reset(seed=1)
    refused(ValueError, "the reward function returned %r, legal: a number" % (answer,), odd.step, (0, 0))
free = SearEnv(OFFICE, actions=0.5, render_mode="rgb_array")
free.reset(seed=1)
refused(ValueError, "action is [0.6 0. ], legal: two speeds from -0.5 to 0.5 m/s", free.step, numpy.array([0.6, 0]))
for pair in (None, 0.1, [0.1], [0.1, 0.1, 0.1], "ab", [float("nan"), 0]):
    refused(ValueError, "action is %s, legal: two speeds from -0.5 to 0.5 m/s" % (pair,), free.step, pair)
refused(RuntimeError, "SEAR has already been started or connected with other options: restart the program or the notebook's kernel",
        sear.connect)
quick = SearEnv(OFFICE, actions={"speed": (0, 0.3)})
quick.reset(seed=1)
refused(ValueError, "action is [0.4], legal: speed from 0 to 0.3", quick.step, [0.4])
assert quick.step(quick.action_space.high)[1] > 0, "0.3 as a float32 is more than 0.3"
free.close()
refused(RuntimeError, "call reset() before step()", free.step, numpy.array([0.1, 0]))
refused(RuntimeError, "the environment is closed: make another one", free.reset)
refused(RuntimeError, "the environment is closed: make another one", free.render)
free.close()
assert gymnasium.make("SEAR/Maze-v0", max_seconds=1).reset(seed=1)
print("all refused")
