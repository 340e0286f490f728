# Check: a minute through the whole room without a bump.
SECONDS = 60
METRES = 6
QUARTERS = 3

def check(run):
    robot = run.robot
    run.need(robot.length >= 1, "Your robot drove %.2f m; marks begin at 1 m." % robot.length)
    run.ask(run.seconds > 59, "Your robot was on its way for %.0f s; it is to drive for 60 s." % run.seconds)
    run.ask(not robot.bumps, "You bumped into something, %d times; the first time after %.1f s." % (len(robot.bumps), (list(robot.bumps) + [0])[0]))
    run.ask(robot.length >= METRES, "You drove %.1f m; %d m are asked." % (robot.length, METRES))
    seen = set((x > 0, z > 0) for x, z in zip(robot.x, robot.z) if abs(x) > 0.3 and abs(z) > 0.3)
    run.ask(len(seen) >= QUARTERS, "You were in %d of the room's 4 quarters; %d are asked." % (len(seen), QUARTERS))
    run.measure("metres", robot.length)
    run.measure("bumps", len(robot.bumps))
