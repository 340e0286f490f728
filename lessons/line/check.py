# Check: one round on the tape.
from math import atan2, cos, hypot, pi, sin

SECONDS = 60
OFF = 0.05                  # maximum distance of the middle between the wheels from the tape, metres

def radius(angle):
    return 0.7 + 0.15 * cos(3 * angle)

ROUND = [(radius(i * pi / 6) * cos(i * pi / 6), radius(i * pi / 6) * sin(i * pi / 6)) for i in range(1, 13)]
REACHED = 0.15

def check(run):
    robot = run.robot
    run.need(robot.length >= 0.5, "Your robot drove %.2f m; marks begin at 0.5 m." % robot.length)
    count = robot.reached(ROUND, REACHED)
    if run.ask(count == len(ROUND), "You came %d of 12 parts of the way round; all 12 are asked." % count):
        run.measure("seconds for a round", robot.when(ROUND, REACHED))
    off = [abs(hypot(x, z) - radius(atan2(z, x))) for x, z in zip(robot.x, robot.z)]
    lost = [time for time, metres in zip(robot.times, off) if metres > OFF]
    run.ask(not lost, "You were up to %.2f m off the line, the first time after %.1f s; %.2f m is allowed." % (max(off), (lost + [0])[0], OFF))
    run.measure("metres off", max(off))
