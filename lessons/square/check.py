# Check: three corners and back in order, along the sides.
SECONDS = 60
SQUARE = ((0, 0), (0, 1), (1, 1), (1, 0), (0, 0))    # x north, z east
NEAR = 0.1                                           # metres

def check(run):
    robot = run.robot
    run.need(robot.length >= 0.5, "Your robot drove %.2f m: sear.driveStraight(0.2) says how fast, and sear.simSleep(5) lets it drive for so many seconds. Marks begin at 0.5 m." % robot.length)
    corners = robot.inOrder(SQUARE[1:], NEAR)
    for name, metres in zip(("first corner", "second corner", "third corner", "start again"), corners):
        run.ask(metres <= NEAR, "You came within %.2f m of the %s; %.1f m is asked." % (metres, name, NEAR))
    beside = max(robot.distancesFrom(SQUARE))
    run.ask(beside <= NEAR, "You were up to %.2f m beside the sides of the square; %.1f m is allowed." % (beside, NEAR))
    run.ask(not robot.bumps, "You bumped into something, %d times; the first time after %.1f s." % (len(robot.bumps), (list(robot.bumps) + [0])[0]))
    run.ask(robot.isStanding(), "At the end your robot was still moving; stop it, and let it stand for 0.5 s: sear.simSleep(1).")
    run.measure("metres beside", beside)
    run.measure("seconds", run.seconds)
