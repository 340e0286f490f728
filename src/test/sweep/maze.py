"""A run of the maze with random actions, which takes a few milliseconds, for measurements and kill tests."""


def chance(seed, seconds):
    """Returns the return of a number of simulated seconds."""
    import gymnasium
    import sear.gym

    env = gymnasium.make("SEAR/Maze-v0", max_seconds=seconds)
    env.action_space.seed(seed)
    env.reset(seed=seed)
    total = 0
    ended = late = False
    while not (ended or late):
        seen, reward, ended, late, info = env.step(env.action_space.sample())
        total += reward
    robot = env.unwrapped.robot
    env.close()
    return {"total": total, "x": robot.x, "z": robot.z}
