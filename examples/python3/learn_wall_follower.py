"""A Roomba learns wall following with PPO, on the CPU. Needs SEAR's Python 3 package with Gymnasium, Stable-Baselines3 and
matplotlib:

    pip install ./python[gym] stable-baselines3 matplotlib
    python3 examples/python3/learn_wall_follower.py --seeds 1 2 3 --curve curve.svg
"""
import argparse
import csv
import os
import sys
import time

try:
    import gymnasium
    import matplotlib
    import numpy
    import torch
    from stable_baselines3 import PPO
    from stable_baselines3.common.callbacks import BaseCallback
    from stable_baselines3.common.monitor import Monitor
    from stable_baselines3.common.vec_env import DummyVecEnv, VecNormalize
    import sear.gym
except ImportError as error:
    sys.exit("%s is missing. Install the requirements: pip install ./python[gym] stable-baselines3 matplotlib" % (error.name or "Gymnasium"))

ENVIRONMENT = "SEAR/WallFollow-v0"
WORLDS = 4            # in parallel in this process: the network evaluates four observations at a time
NEAR = numpy.float32(2)
EVERY = 10_000        # steps between two evaluations
EPISODES = 10         # per evaluation; their seeds are 1000, 1001 ...
FIRST_SEED = 1000


def make():
    """Returns the environment with observations limited to 2 m and scaled to -1 to 1, the range that suits networks."""
    env = gymnasium.make(ENVIRONMENT)
    space = gymnasium.spaces.Box(-1, 1, env.observation_space.shape)
    return Monitor(gymnasium.wrappers.TransformObservation(env, lambda beams: numpy.minimum(beams, NEAR) - 1, space))


def drive(choose, env):
    """Returns the mean return of some episodes with fixed seeds, and the number of crashes."""
    returns = []
    crashes = 0
    for number in range(EPISODES):
        observation, _ = env.reset(seed=FIRST_SEED + number)
        total = 0
        ended = late = False
        while not (ended or late):
            observation, reward, ended, late, _ = env.step(choose(observation))
            total += reward
        returns.append(total)
        crashes += ended
    return sum(returns) / EPISODES, crashes


class Looks(BaseCallback):
    """Evaluates the policy regularly, outside the measured learning time."""

    def __init__(self, seed, rows):
        super().__init__()
        self.seed = seed
        self.rows = rows
        self.env = make()
        self.spent = 0
        self.next = 0
        self.begun = time.perf_counter()

    def _on_step(self):
        if self.num_timesteps >= self.next:
            self.next += EVERY
            self.look()
        return True

    def look(self):
        """Performs one evaluation."""
        begun = time.perf_counter()
        mean, crashes = drive(lambda observation: int(self.model.predict(observation, deterministic=True)[0]), self.env)
        seconds = begun - self.begun - self.spent
        self.spent += time.perf_counter() - begun
        self.rows.append((self.seed, self.num_timesteps, round(seconds, 1), round(mean, 3), crashes))
        print("seed %d, %d steps, %.0f s: return %.2f, %d of %d episodes crashed" % (self.rows[-1] + (EPISODES,)), flush=True)


def learn(seed, steps, rows):
    """Runs PPO with the defaults of Stable-Baselines3, except for the values given here."""
    worlds = VecNormalize(DummyVecEnv([make] * WORLDS), norm_obs=False)    # scales rewards to size 1
    model = PPO("MlpPolicy", worlds, n_steps=512, batch_size=256, ent_coef=0.005, learning_rate=lambda left: 5e-4 * left, gamma=0.98, seed=seed,
                device="cpu")
    looks = Looks(seed, rows)
    model.learn(steps, callback=looks)
    looks.look()
    worlds.close()
    return model


def draw(rows, chance, file):
    """Draws the return over steps, with a line for each seed."""
    matplotlib.use("Agg")
    matplotlib.rcParams["svg.hashsalt"] = "sear"    # the same numbers give the same file
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(figsize=(7, 4))
    for seed in sorted({row[0] for row in rows}):
        mine = [row for row in rows if row[0] == seed]
        axes.plot([row[1] / 1000 for row in mine], [row[3] for row in mine], label="seed %d: %.0f s" % (seed, mine[-1][2]))
    axes.axhline(chance, color="grey", linestyle=":", label="by chance")
    axes.set_xlabel("thousand steps of the environment, 0.1 s each")
    axes.set_ylabel("return: metres at the wall, -3 for a crash")
    axes.legend()
    axes.grid(alpha=0.3)
    figure.tight_layout()
    figure.savefig(file, metadata={"Date": None} if file.endswith(".svg") else None)


def main():
    """Learns once per seed."""
    options = argparse.ArgumentParser(description="A Roomba learns wall following with PPO.")
    options.add_argument("--seeds", type=int, nargs="+", default=[1])
    options.add_argument("--steps", type=int, default=200_000, help="of the environment, per seed")
    options.add_argument("--curve", help="a .svg or .png file for the curve")
    options.add_argument("--table", help="a .csv file for its numbers")
    options.add_argument("--save", help="a .zip file for the final policy")
    given = options.parse_args()
    torch.set_num_threads(1)
    env = make()
    env.action_space.seed(1)
    chance, crashes = drive(lambda observation: env.action_space.sample(), env)
    print("by chance: return %.2f, %d of %d episodes crashed" % (chance, crashes, EPISODES), flush=True)
    rows = []
    for seed in given.seeds:
        model = learn(seed, given.steps, rows)
    if given.table:
        with open(given.table, "w", newline="") as file:
            csv.writer(file).writerows([("seed", "steps", "seconds", "return", "crashes")] + rows)
    if given.curve:
        draw(rows, chance, given.curve)
        print("Drawn: %s" % os.path.abspath(given.curve))
    if given.save:
        model.save(given.save)


if __name__ == "__main__":
    main()
