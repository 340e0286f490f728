# A track of black tape on a white floor, and a small robot with three line sensors and a camera.
from org.SEAR.POJOs import Box, Camera, Dynamics, Floor, LineSensor, Motor, SEARrobot, Wheel

sear = Runtime.start("sear", "SEAR")
sear.newProject()    # backs up the present project, if there is one

Floor("track", 2, 2, "textures/line-track.png")    # its tape is 20 mm wide, 0.7 + 0.15 cos 3a metres from the middle

robot = SEARrobot("follower")
robot.addComponent(Dynamics("drive", 0.6, 400, 0.5, 0.5, 1000, 0.02, 0.85, 0.04, 0, 0, 0, 0))    # 0.6 kg, on the tape, looking along it
body = Box("chassis", 0.1, 0.14, 0.03, 0.6)
body.setColor("blue")
body.move(0, 0.025, 0)
robot.addComponent(body)
for name, x in (("left", 0.06), ("right", -0.06)):
    wheel = Wheel(name + " wheel", 0.025, 0.015, 1, x, 0, 0)
    robot.addWheel(wheel)
    robot.addComponent(Motor(name + "Motor", wheel, 0.08, 20))
for name, z in (("front ball", 0.05), ("rear ball", -0.05)):
    robot.addWheel(Wheel(name, 0.01, 0.01, 0, 0, -0.015, z))
for name, x in (("leftLine", 0.015), ("middleLine", 0), ("rightLine", -0.015)):
    robot.addComponent(LineSensor(name, x, -0.01, 0.06))
robot.addComponent(Camera("eye", 0, 0.06, 0.04, 40, 0, 0))    # 85 mm above the floor, 40 mm ahead of the axle; pitched 40 degrees down
