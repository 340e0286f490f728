"""Handwritten policies solve the tasks, and much better than random actions."""
from math import atan2, cos, hypot

import gymnasium
import numpy
import sear.gym

EPISODES = 4


def wall(beams):
    """Keeps half a metre from the nearest object on the right, and that object straight to the right."""
    straight, left, right, turn = 0, 1, 2, 3
    nearest = beams[:70].min()
    at = int(beams[:70].argmin())    # degrees from the right
    if beams[68:113].min() < 0.55 or nearest < 0.3:
        return turn
    if nearest > 0.75:    # the wall has ended, unless it continues behind a door
        return straight if at > 30 and nearest < 1.4 else right
    error = 2 * (nearest - 0.5) - 0.8 * numpy.radians(at)
    return right if error > 0.08 else left if error < -0.08 else straight


def line(light, seen=[3]):
    """Steers towards the tape, or to where it was last seen."""
    dark = 100 - light
    if dark.sum() < 40:
        return seen[0]
    off = float(dark[0] - dark[2]) / float(dark.sum())
    if abs(off) < 0.15:
        return 0
    seen[0] = 3 if off > 0 else 4
    return seen[0] if abs(off) > 0.6 else 1 if off > 0 else 2


def dock(seen):
    """Drives to a point ahead of the docking place; the point approaches that place with the robot."""
    ahead, left, cosine, sine = (float(one) for one in seen)
    ahead, left = ahead - 0.21 * cosine, left - 0.21 * sine
    far = hypot(ahead, left)
    angle = atan2(left - 0.5 * far * sine, ahead - 0.5 * far * cosine) if far > 0.06 else atan2(sine, cosine)
    speed = min(0.25, max(far, 0.04)) * max(0, cos(angle))
    turn = 0.118 * max(-1, min(1, 2 * angle))
    return numpy.clip([speed - turn, speed + turn], -0.3, 0.3)


def returns(name, choose):
    """Returns the returns of some episodes; None: random actions."""
    env = gymnasium.make("SEAR/%s-v0" % name)
    env.action_space.seed(1)
    got = []
    for seed in range(EPISODES):
        observation, _ = env.reset(seed=seed)
        got.append(0)
        ended = late = False
        while not (ended or late):
            observation, gain, ended, late, _ = env.step(choose(observation) if choose else env.action_space.sample())
            got[-1] += gain
    return got


for name, choose, least, chance in (("WallFollow", wall, 6, 0), ("LineFollow", line, 9, 1), ("Docking", dock, 6, 2)):
    good = returns(name, choose)
    bad = returns(name, None)
    assert min(good) > least, (name, good)
    assert max(bad) < chance, (name, bad)
    print(name, "by hand %.2f, by chance %.2f" % (sum(good) / EPISODES, sum(bad) / EPISODES))
