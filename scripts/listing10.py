# Listing 10 of the dissertation: the controller's side of a custom controller. The listing itself is the template controller.py in SEAR's jar; this
# script runs it on the robot that listing09.py made, sends it one request by hand, and shows the bytes of the answer.
# Changed in the template: publishRX with the byte as argument (publishByte is gone from MyRobotLab); a request is two bytes, and a byte that follows
# no 0x8E is none (the listing never forgot the first 0x8E); the arithmetic has the signs, limits and rounding of the data sheets; sensor numbers
# stand in a table.
import os

sear = Runtime.start("SEAR", "SEAR")
sear.startSimulation()
sear.simSleep(1)
if not os.path.exists("SEARproject/controller.py"):
    sear.copyTemplate("controller.py", "SEARproject")
python.execFile("SEARproject/controller.py")

def onAnswerByte(data):
    print "byte " + hex(data)

byHand = Runtime.start("byHand", "Serial")
byHand.connect("/dev/user_CONTROLLER_01", 9600, 8, 1, 0)
byHand.addListener("publishRX", python.getName(), "onAnswerByte")
print "requesting sensor 43, sonar 1"
byHand.write(0x8E)
byHand.write(0x2B)
sear.simSleep(1)
print "SEAR itself says " + str(sear.getDistanceResult("testPing1")) + " m"
sear.stopSimulation()
