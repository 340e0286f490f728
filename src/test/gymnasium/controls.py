"""Steering, speed, servos and motors as actions."""
import math

import numpy
import sear
from gymnasium import spaces
from gymnasium.utils.env_checker import check_env
from sear.gym import SearEnv

CAR = "examples/car.sear"
TURRET = "examples/turret.sear"


def never(robot):
    return False


car = SearEnv(CAR, actions={"speed": (0, 0.5), "steering": (-20.1, 20.1)}, done=never)
assert car.action_space == spaces.Box(numpy.array([0, -20.1], numpy.float32), numpy.array([0.5, 20.1], numpy.float32))
check_env(car)


def turned(env, action, steps=10):
    env.reset(seed=1)
    for step in range(steps):
        env.step(action)
    return env.robot.turned


left = turned(car, [0.4, 20])
assert left > 20 and turned(car, [0.4, -20]) < -20 and abs(turned(car, [0.4, 0])) < 2
listed = SearEnv(CAR, actions=[{"steering": 20, "speed": 0.4}, {"speed": 0.4, "steering": -20}], done=never)
assert turned(listed, 0) == left and turned(listed, 1) < -20

wheels = SearEnv(CAR, actions=[(0.3, 0.4)], done=never)
wheels.reset(seed=1)
try:
    wheels.step(0)
    raise AssertionError("a servo steers")
except ValueError as error:
    assert str(error) == "robot car can't turn by wheel speeds 0.3 and 0.4 m/s: its servo steering steers it. Turn that servo instead", error

sear.start(headless=True)
runtime = sear.Runtime.start("sear", "SEAR")
runtime.newProject()
sear.Floor("floor", 20, 20)
sear.Robots.car("car").addComponent(sear.Compass("compass"))
wheels = SearEnv("SEARproject", actions=[(0.3, 0.4), (0.4, 0.3)], done=never)
assert turned(wheels, 0) > 10 and turned(wheels, 1) < -10, "different wheel speeds steer"
runtime.newProject()
sear.Floor("floor", 20, 20)
sear.Box("wall", 20, 0.2, 2, 0, 0, 1, 3)
rover = sear.Robots.rover("rover")
neck = sear.Servo("neck")
neck.setRange(-45, 45)
eye = sear.Distance("eye", "laser", 0, 0.3, 0.1, 0, 0, 0)
for part in (neck, eye):
    rover.addComponent(part)
neck.mount(eye)
turret = SearEnv("SEARproject", actions={"neck": (-45, 45), "left": (-0.2, 0.2), "right": (-0.2, 0.2)}, sensors=["eye"], done=never)
turret.reset(seed=1)
for step in range(10):
    far = turret.step([45, 0, 0])[0][0]
for step in range(10):
    near = turret.step([0, 0, 0])[0][0]
assert near < 4 and far > near * math.sqrt(2) - 0.3, (near, far)
turret.step([0, 0.2, 0.2])
assert turret.robot.moved > 0
try:
    SearEnv("SEARproject", actions={"neck": (-46, 45)})
    raise AssertionError("46 degrees are too many")
except ValueError as error:
    assert str(error) == "robot rover: neck is -46, legal: -45 to 45", error
print("controls")
