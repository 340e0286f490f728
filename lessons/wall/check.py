# Check: once round the room, never too near to the wall or too far from it.
SECONDS = 150
ROUND = ((-1.5, 2), (0, 2), (0, 0.5), (1.5, 0.5), (1.5, -2), (-1.5, -2), (-1.5, -1))
NAMES = ("the south-east corner", "the cupboard's corner in the east", "the cupboard's edge", "the cupboard's corner in the north",
         "the north-west corner", "the south-west corner", "the start")
WALL = ((-2, -2.5), (-2, 2.5), (0.5, 2.5), (0.5, 1), (2, 1), (2, -2.5), (-2, -2.5))
REACHED = 0.6
NEAR, FAR, MEAN = 0.2, 0.8, 0.1     # metres from the robot's middle; its radius is 0.17
WANTED = 0.46

def check(run):
    robot = run.robot
    run.need(robot.length >= 1, "Your robot drove %.2f m; marks begin at 1 m." % robot.length)
    count = robot.reached(ROUND, REACHED)
    if run.ask(count == len(ROUND), "You came as far as %s; once round is asked." % ("the first wall" if count == 0 else NAMES[count - 1])):
        run.measure("seconds for a round", robot.when(ROUND, REACHED))
    distances = list(robot.distancesFrom(WALL))
    run.ask(min(distances) >= NEAR, "Your robot's middle came as near as %.2f m to a wall; %.1f m is asked." % (min(distances), NEAR))
    run.ask(max(distances) <= FAR, "Your robot's middle was up to %.2f m from the walls; %.1f m is allowed." % (max(distances), FAR))
    mean = sum(abs(one - WANTED) for one in distances) / len(distances)
    run.ask(mean <= MEAN, "On average you were %.2f m off the distance that is asked; %.1f m is allowed." % (mean, MEAN))
    run.ask(not robot.bumps, "You bumped into something, %d times; the first time after %.1f s." % (len(robot.bumps), (list(robot.bumps) + [0])[0]))
    run.measure("metres off on average", mean)
