"""A run of the maze by chance, which is a handful of milliseconds of work, for what measures and kills."""


def chance(seed, seconds):
    """The return of so many simulated seconds."""
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
