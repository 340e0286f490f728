# Listing 9 of the dissertation: the user's side of a custom controller. The listing itself is the template userCode.py in SEAR's jar; this script
# makes the robot it needs, copies it to SEARproject and runs it.
# Changed in the template: publishRX with the byte as argument (publishByte is gone from MyRobotLab); the environment of Listing 1, printed into it
# by mistake, is left out; one function asks and waits with a time limit instead of a loop that spins; the controller's numbers are turned back into
# units; connectRoomba() makes up for MyRobotLab's Roomba service.
import os
from org.SEAR.POJOs import Accelerometer, Box, Compass, Cylinder, Distance, Dynamics, Floor, Gyroscope, SEARrobot, Wheel

sear = Runtime.start("SEAR", "SEAR")
sear.newProject()

Floor("floor", 50, 50, False)
wall = Box("wall", 4, 0.1, 1, 0)    # a wall in front of the robot
wall.move(0, 0.5, 1.5)

robot = SEARrobot("myRoomba")
dyna = Dynamics("robotDynamics1", 4, 60, 0.3, 0.4, 10000, 0.1, 0, 0.1, 0, 0, 0, 0)
dyna.setPorts("/dev/my_Robot01", "/dev/SEAR_Robot_01")
robot.addComponent(dyna)
robot.addComponent(Cylinder("Roomba Body", 0.1666875, 0.0762, 4))
for (name, x, z, driven) in (("frontWheel", 0, 0.16, 0), ("rightWheel", -0.16, 0, 1), ("leftWheel", 0.16, 0, 1), ("backWheel", 0, -0.16, 0)):
    wheel = Wheel(name, 0.0381, 0.03, driven)
    wheel.move(x, 0, z)
    robot.addWheel(wheel)
for (name, x) in (("testPing1", 0.05), ("MyNewestSONAR", -0.05)):
    ping = Distance(name, "PING)))")
    ping.move(x, 0.1, 0.15)
    robot.addComponent(ping)
robot.addComponent(Accelerometer("accel"))
robot.addComponent(Gyroscope("gyro1"))
robot.addComponent(Compass("comp1"))

for template in ("controller.py", "userCode.py"):
    if not os.path.exists("SEARproject/" + template):
        sear.copyTemplate(template, "SEARproject")
python.execFile("SEARproject/userCode.py")    # runs controller.py, too
sear.stopSimulation()
