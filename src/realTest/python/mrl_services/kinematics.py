# InverseKinematics3D: the joint angles found for a hand position move a servo.
from org.myrobotlab.kinematics import DHLink, DHRobotArm
arduino = board()
neck = Runtime.start("neckServo", "Servo")
neck.setPin(3)
neck.attach(arduino)
angles = []
def onArmAngles(values):
    angles.append(values["shoulder"])
    neck.moveTo(90 + values["shoulder"])
kinematics = Runtime.start("kinematics", "InverseKinematics3D")
arm = DHRobotArm()
arm.addLink(DHLink("shoulder", 0, 200, 0, 0))
arm.addLink(DHLink("elbow", 0, 100, 0, 0))
kinematics.setCurrentArm("arm", arm)
kinematics.addListener("publishJointAngles", "python", "onArmAngles")
kinematics.moveTo("arm", 150, 150, 0)
until("joint angles", lambda: angles)
until("the servo has the shoulder's angle", lambda: abs(sear.getServo("neck") - angles[-1]) < 1.5)
