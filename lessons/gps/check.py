# Check: three waypoints in order, and a stop at the last one.
SECONDS = 120
PLACES = ((2, 3), (-3, 3), (-3, -2))     # metres north and east of 52.0, 13.0
NEAR = 0.4

def check(run):
    robot = run.robot
    run.need(robot.length >= 1, "Your robot drove %.2f m; marks begin at 1 m." % robot.length)
    for name, metres in zip(("first", "second", "third"), robot.inOrder(PLACES, NEAR)):
        run.ask(metres <= NEAR, "You came within %.2f m of the %s waypoint; %.1f m is asked." % (metres, name, NEAR))
    end = robot.endsFrom(*PLACES[-1])
    run.ask(robot.isStanding() and end <= NEAR, "At the end your robot %s, %.2f m from the third waypoint; stand there for 0.5 s, %.1f m is asked."
            % ("stood" if robot.isStanding() else "was still moving", end, NEAR))
    run.ask(not robot.bumps, "You bumped into something, %d times; the first time after %.1f s." % (len(robot.bumps), (list(robot.bumps) + [0])[0]))
    run.measure("seconds", run.seconds)
    run.measure("metres", robot.length)
