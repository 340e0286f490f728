"""At which distance from the wall on its right does a robot best find its way through the maze? Tries each distance with
many seeds, on all processors. Needs SEAR's Python 3 package with Gymnasium, Dask Distributed and pyarrow:

    pip install "./python[gym,sweep]"
    python3 examples/python3/maze_sweep.py --seeds 100 --out maze-sweep
"""
import argparse

import numpy
import sear

STRAIGHT, WIDE_LEFT, WIDE_RIGHT, LEFT, RIGHT = range(5)    # the actions of SEAR/Maze-v0
MISTAKES = 0.05     # fraction of random actions, so that each seed gives another path


def drive(seed, gap):
    """Performs one run. Returns whether the cone was found within five minutes, the seconds, and the number of
    bumps."""
    import gymnasium
    import sear.gym    # imported here, because other processes and computers call the function

    random = numpy.random.default_rng(seed)
    env = gymnasium.make("SEAR/Maze-v0", max_seconds=300)
    seen, info = env.reset(seed=seed)
    robot = env.unwrapped.robot
    bumps = 0
    ended = late = False
    while not (ended or late):
        front, left, right = seen[:3]
        if random.random() < MISTAKES:
            action = int(random.integers(5))
        elif robot.bumped:
            action = LEFT if robot.bumped_right else RIGHT
        elif front < 0.25:
            action = LEFT
        elif right > gap + 0.04:
            action = WIDE_RIGHT
        else:
            action = WIDE_LEFT if right < gap - 0.02 else STRAIGHT
        seen, reward, ended, late, info = env.step(action)
        bumps += int(robot.bumped)
    env.close()
    return {"found": ended, "seconds": round(robot.time, 3), "bumps": bumps}


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, default=20, help="number of seeds, default 20")
    parser.add_argument("--workers", type=int, help="number of processes, default: number of processors")
    parser.add_argument("--scheduler", help="address of a running Dask scheduler")
    parser.add_argument("--out", help="a folder for rows.csv and rows.parquet")
    given = parser.parse_args()
    rows = sear.sweep(drive, {"gap": [0.15, 0.2, 0.25, 0.3]}, seeds=given.seeds, workers=given.workers, scheduler=given.scheduler, out=given.out)
    for gap in sorted({row["gap"] for row in rows}):
        found = [row["seconds"] for row in rows if row["gap"] == gap and row["status"] == "ok" and row["found"]]
        print("gap %.2f m: the cone was found in %d of %d runs%s" % (gap, len(found), sum(row["gap"] == gap for row in rows),
                                                                     ", after %.0f s on average" % (sum(found) / len(found)) if found else ""))
