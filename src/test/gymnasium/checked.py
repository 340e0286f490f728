"""Gymnasium's own check of each registered environment and its observations."""
import warnings

import gymnasium
import numpy
import sear.gym
from gymnasium.utils.env_checker import check_env

# Poses of objects have no bounds
warnings.filterwarnings("error")
warnings.filterwarnings("ignore", message=".*A Box observation space m[a-z]+ value is (-)?infinity.*")

SIZES = {"Maze": 7, "WallFollow": 181, "LineFollow": 3, "Docking": 4}
for name, size in SIZES.items():
    env = gymnasium.make("SEAR/%s-v0" % name, render_mode="rgb_array")
    check_env(env.unwrapped)
    assert env.observation_space.shape == (size,), name
    observation, info = env.reset(seed=1)
    assert observation.dtype == numpy.float32 and info == {}
    kept = observation.copy()
    env.step(env.action_space.sample())
    assert numpy.array_equal(kept, observation), "an observation is not changed by the next step"
    picture = env.render()
    assert picture.shape == (360, 480, 3) and picture.dtype == numpy.uint8 and len(numpy.unique(picture)) > 3
    env.close()
    print(name, "checked")
