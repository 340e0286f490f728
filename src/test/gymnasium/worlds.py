"""Several worlds in this process, and in other processes."""
import multiprocessing
import sys

import gymnasium
import numpy
import sear.gym


def drive(worlds):
    """Returns the observations of all worlds."""
    seen = [worlds.reset(seed=3)[0]]
    for action in (0, 0, 1, 3, 0, 2):
        observations, rewards, ended, late, _ = worlds.step(numpy.full(worlds.num_envs, action))
        assert rewards.shape == ended.shape == late.shape == (worlds.num_envs,)
        seen.append(observations.copy())
    worlds.close()
    return numpy.stack(seen)


def main():
    here = gymnasium.make_vec("SEAR/WallFollow-v0", num_envs=4)
    seen = drive(here)
    assert seen.shape == (7, 4, 181)
    assert not all(numpy.array_equal(seen[:, 0], seen[:, number]) for number in (1, 2, 3)), "worlds with other seeds start elsewhere"
    alone = gymnasium.make("SEAR/WallFollow-v0")
    assert numpy.array_equal(seen[0, 2], alone.reset(seed=5)[0]), "the third has the third seed"
    elsewhere = gymnasium.make_vec("SEAR/WallFollow-v0", num_envs=2, vectorization_mode="async", vector_kwargs={"context": "spawn"})
    assert numpy.array_equal(drive(elsewhere), seen[:, :2]), "in processes of their own they see the same"
    print("four worlds here, two elsewhere")
    if "fork" in multiprocessing.get_all_start_methods():
        try:
            gymnasium.make_vec("SEAR/WallFollow-v0", num_envs=2, vectorization_mode="async", vector_kwargs={"context": "fork"}).reset()
        except (ConnectionError, EOFError):
            print("forked ones end")    # and report why, see the test


if __name__ == "__main__":
    main()
    sys.stdout.flush()
