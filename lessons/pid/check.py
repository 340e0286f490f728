# Check: the robot's true distance from the wall: at the end, settling time, and overshoot.
from math import cos, radians

SECONDS = 20
EYE = 0.07                  # from the robot's origin to its eye, metres
WALL = 3.15                 # from the foot of the ramp to the wall along the slope of 12 degrees, metres
WANTED, END, SOON, NEAREST = 0.5, 0.01, 8, 0.4

def check(run):
    robot = run.robot
    slope = radians(12)
    along = [z * cos(slope) + y * (1 - cos(slope) ** 2) ** 0.5 for y, z in zip(robot.y, robot.z)]
    distances = [WALL - EYE - one for one in along]
    times = list(robot.times)
    nearer = distances[0] - min(distances)
    run.need(nearer >= 0.1, "Your robot drove %.2f m up to the wall; marks begin at 0.1 m." % nearer)
    run.ask(run.seconds > 19, "Your robot was controlled for %.0f s; 20 s are asked." % run.seconds)
    last = [one for time, one in zip(times, distances) if time > times[-1] - 3]
    mean = sum(last) / len(last)
    run.ask(abs(mean - WANTED) <= END, "In the last 3 s it was %.3f m from the wall; %.2f m is asked, give or take %.2f m." % (mean, WANTED, END))
    swing = max(last) - min(last)
    run.ask(swing <= 2 * END, "In the last 3 s it still moved to and fro by %.3f m; %.2f m is allowed." % (swing, 2 * END))
    late = [0] + [time for time, one in zip(times, distances) if abs(one - WANTED) > 0.05]
    run.ask(late[-1] <= SOON, "Only after %.1f s it stayed within 0.05 m; %d s are allowed." % (late[-1], SOON))
    run.ask(min(distances) >= NEAREST, "It came as near as %.2f m to the wall; %.1f m is allowed." % (min(distances), NEAREST))
    run.ask(not robot.bumps, "You bumped into something, %d times; the first time after %.1f s." % (len(robot.bumps), (list(robot.bumps) + [0])[0]))
    run.measure("metres at the end", mean)
    run.measure("seconds until it stays", late[-1])
