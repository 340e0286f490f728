"""The same seed gives the same episode to the bit, in this process and in others; another seed gives other noise."""
import hashlib
import sys

import gymnasium
import numpy
import sear
import sear.gym

sear.start(headless=True)
from sear import LIDAR, Floor, Box, Noise, Robots, Runtime    # noqa: E402


def project():
    """Builds a room, and a robot whose LIDAR has noise."""
    service = Runtime.start("sear", "SEAR")
    service.newProject()
    Floor("floor", 20, 20)
    Box("wall", 6, 0.2, 1, 0).move(0, 0.5, 2)
    Box("crate", 0.3, 0.3, 0.3, 1).move(0, 0.15, 0.7)
    robot = Robots.create("robot")
    lidar = LIDAR("lidar", 8, 180, 1, 0, 0.2, 0)
    lidar.setNoise(Noise().setWhite(0.02).setDrift(0.01))
    robot.addComponent(lidar)


def episode(env, seed=None):
    """Returns a digest of everything that an episode returns."""
    told = hashlib.sha256()
    observation, _ = env.reset(seed=seed)
    for number in range(60):
        told.update(observation.tobytes())
        observation, reward, ended, late, _ = env.step(numpy.array([0.3, 0.3 - 0.002 * number], numpy.float32))
        told.update(repr((reward, ended, late)).encode())
    return told.hexdigest()


project()
make = lambda **given: sear.gym.SearEnv("SEARproject", done=lambda robot: False, **given)    # noqa: E731
env = make()
first = episode(env, 5)
second = episode(env)
assert first != second, "each episode has errors of its own"
assert episode(env, 6) not in (first, second), "another seed"
assert [episode(env, 5), episode(env)] == [first, second], "the same seed again"
other = make(seed=5)
assert [episode(other), episode(other)] == [first, second], "a seed that is given to the environment"

still = make(actions=[(0, 0)])
noises = [still.reset(seed=seed, options={"noise": noise})[0] for seed, noise in ((1, 3), (2, 3), (1, 4))]
assert numpy.array_equal(noises[0], noises[1]) and not numpy.array_equal(noises[0], noises[2]), "the noise by its own seed"
assert abs(float(numpy.std(noises[0][60:120] - noises[2][60:120])) - 0.02 * 2 ** 0.5) < 0.01, "two errors of 2 cm"

starts = gymnasium.make("SEAR/LineFollow-v0")
places = []
for seed in (1, 2, 1):
    starts.reset(seed=seed)
    places.append(starts.unwrapped.robot.heading)
assert places[0] == places[2] != places[1], places
print("episode", first)
sys.exit(0)
