# Check: compares the pose that the script prints with the robot's.
import re
from math import hypot

SECONDS = 60
METRES, DEGREES, WAY = 0.1, 5, 5

def check(run):
    robot = run.robot
    run.need(robot.length >= 1, "Your robot drove %.2f m; marks begin at 1 m." % robot.length)
    run.ask("getPose" not in run.script, "Your script asks sear.getPose where it is; here it is to say so from its encoders alone.")
    run.ask(robot.length >= WAY, "Your robot drove %.1f m; drive all of WAY, more than %d m." % (robot.length, WAY))
    number = r"(-?[0-9]+(?:\.[0-9]+)?)"
    said = re.findall("I am at x %s, z %s, heading %s" % (number, number, number), run.printed)
    if not run.ask(len(said) > 0, 'Your script does not say where it is; print "I am at x 1.234, z 5.678, heading 90.0" as its last line.'):
        return
    x, z, heading = [float(one) for one in said[-1]]
    away = hypot(x - robot.x[-1], z - robot.z[-1])
    turned = abs((heading - robot.headings[-1] + 180) % 360 - 180)
    run.ask(away <= METRES, "You say x %.2f, z %.2f; the robot is %.2f m away from there, at x %.2f, z %.2f. %.1f m is allowed."
            % (x, z, away, robot.x[-1], robot.z[-1], METRES))
    run.ask(turned <= DEGREES, "You say heading %.0f; it is %.0f. %d degrees are allowed." % (heading, robot.headings[-1], DEGREES))
    run.measure("metres wrong", away)
    run.measure("degrees wrong", turned)
