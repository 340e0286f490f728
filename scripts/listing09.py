# Listing 9 of the dissertation: the user's side of a custom controller, userCode.py; it runs Listing 10, the controller's.
# For your own robots use the templates userCode.py and controller.py of SEAR's jar (sear.copyTemplate), which work with
# today's API. Lines are as printed; each deviation has a comment "# SEAR:". The indentation is corrected, too, and the
# environment of Listing 1, which the print has in the middle of a function, is behind that function.
from time import sleep
import sys
import os    # SEAR: added, to find Listing 10
folder = os.path.dirname(globals().get("__file__", ""))    # SEAR: added; this script's folder, else MyRobotLab's folder as in the print

print "\n \n executing serial send"
python.execFile(os.path.join(folder, "listing10.py"))    # SEAR: printed "controllerTest.py" #execute the simulated controller's code
sleep(2)

currentLength = 0
messageLength = 2
msgBuffer = list()
msgResults = list()


def sendControllerData(message):
    #write a series of bytes to the serial port
    serial.write(0x8E) #0x8E = 142 decimal which is the "Sensor request" roomba opcode
    serial.write(message)
from org.SEAR.POJOs import Cylinder
from org.SEAR.POJOs import Box
from org.SEAR.POJOs import Cone
from org.SEAR.POJOs import Model    # SEAR: printed "model"; the class is Model
from org.SEAR.POJOs import Floor    # SEAR: added; missing in the print

floor = Floor("floor", 50, 50)    #create floor
floor.setVisibleToSensors(False)    # SEAR: added; the PING))) sensors would detect only the floor

#create some obstacles
box = Box("Box1_name", 0.25, 0.25, 0.25, 0)
box.move(-1.5, 1.25, 0)
box.rotate(45, 0, 0)

cyl = Cylinder("trash Can", 0.25, 0.75, 10)
cyl.move(-3, 0, -3.5)
cyl.rotate(0, 30, 30)

coneA = Cone("Traffic Cone", 0.25, 2, 10)
coneA.move(-2, 0, 0)
coneA.rotate(0, 0, 45)

tree = Model("Tree1_name", "models/Tree/Tree.mesh.xml")
tree.move(0, 0, -3)

print "Done creating Environment"

from org.SEAR.POJOs import Accelerometer, Compass, Distance, Gyroscope    # SEAR: added; the sensors that Listing 10 reads
python.execFile(os.path.join(folder, "listing02.py"))    # SEAR: added; the robot for them
for (name, x) in (("testPing1", 0.05), ("MyNewestSONAR", -0.05)):    # SEAR: added, see above
    ping = Distance(name, "PING)))")    # SEAR: added, see above
    ping.move(x, 0.1, 0.15)    # SEAR: added, see above
    robot.addComponent(ping)    # SEAR: added, see above
for sensor in (Accelerometer("accel"), Gyroscope("gyro1"), Compass("comp1")):    # SEAR: added, see above
    robot.addComponent(sensor)    # SEAR: added, see above

def receiveMessage(data):    # SEAR: printed "receiveMessage()"; MyRobotLab passes the value as argument

    global msgBuffer
    global messageLength    # SEAR: printed with an editor's note behind it
    global currentLength
    global msgResults

    data = data & 0xff    # SEAR: printed "msg_serial_publishByte.data[0] & 0xff", a variable that MyRobotLab does not set
    if (currentLength < messageLength): # if not the full message, then store this in our buffer
        msgBuffer.insert(currentLength, data) # fill the message buffer full of bytes.
        currentLength +=1 #increment index value

    if (currentLength == messageLength): #otherwise, we are at the last byte in the message, clear everything and parse into short ints 10
        for i in range (0, messageLength, 2): # for i in range(start, finish, step)

            if msgBuffer[i] >0 :
                msgResults.insert(i/2, (msgBuffer [i]<<8) + msgBuffer[i+1])
            elif msgBuffer[i] <0 :
                msgResults.insert(i/2, 256+ (msgBuffer [i]<<8) + msgBuffer[i+1])

            else:
                msgResults.insert(i/2, 0x00ff & msgBuffer[i+1])


        messageLength = 0 # reset this value to 0 so the user knows when to check msgResults for values
        currentLength = 0


def waitForReply(): #this just constantly checks messageLength to see if it is 0, indicating the data has been received completely.
    global messageLength
    while(messageLength != 0):
        sleep(0.02)    # SEAR: printed "pass", which keeps the computer too busy to answer


def clear():
    global currentLength
    global msgBuffer
    global msgResults
    msgBuffer = [0,0,0,0,0,0,0,0]
    msgResults = [0,0,0,0,0,0,0,0]
    currentLength = 0


#The below is the main function and actually calls the functions above:
sear = Runtime.createAndStart("SEAR","SEAR")

sear.startSimulation(); #start SEAR simulation
sleep(1)
roomba = Runtime.createAndStart("robot_Dynamics1","Roomba")
roomba.connect( "/dev/SEAR_Robot_01" )
roomba.startup()
roomba.control()
sleep(1)

#create a Serial service named serial
serial = Runtime.createAndStart("serial","Serial")
#connect to a serial port COM4 57600 bitrate 8 data bits 1 stop bit 0 parity
serial.disconnect()    # SEAR: added; MyRobotLab Nixie's Roomba may have left a port open there
serial.connect("/dev/user_CONTROLLER_01", 9600, 8, 1, 0)

serial.addListener("publishRX", python.name, "receiveMessage")    # SEAR: printed "publishByte", which MyRobotLab does not have
print "listening to: "+serial.name



sleep(1)
print "Main: Requesting Sonar 1"
messageLength = 2 # set the number of bytes I expect the controller to return (1 16-bit U-ints)
sendControllerData(0x2B) # get SONAR 1 reading
waitForReply()
print "\nBack in Main, Sonar 1 value received = " + str(msgResults[0])


print "Main: Requesting Sonar 2"
clear()
messageLength = 2          # set the number of bytes I expect the controller to return (1 16-bit U-ints)
sendControllerData(0x2C) # get SONAR 1 reading
waitForReply()
print "\nBack in Main, Sonar 2 value received = " + str(msgResults[0])


print "Main Requesting Accel"
clear()
messageLength = 6          # set the number of bytes I expect the controller to return (3 16-bit U-ints)
sendControllerData(0x2D) # get Accel readings (x, y, z)
waitForReply()
print "Back in Main, AccelX = " + str(msgResults[0]) +" AccelY = " + str(msgResults[1]) +" AccelZ = " + str(msgResults[2])


print "Main Requesting Gyro"
clear()
messageLength = 6          # set the number of bytes I expect the controller to return (3 16-bit U-ints)
sendControllerData(0x2E) # get Accel readings (x, y, z)
waitForReply()
print "Back in Main, GyroX = " + str(msgResults[0]) +" GyroY = " + str(msgResults[1]) +" GyroZ = " + str(msgResults[2])


print "Main Requesting Compass"
messageLength = 2          # set the number of bytes I expect the controller to return (3 16-bit U-ints)
sendControllerData(0x2F) # get Compass reading
waitForReply()
# The compass sensor modeled here is the simple HMC6352 in "heading" mode which will return a single value from 0-360.0 degrees in tenths of a
# degree (in steps of 0.5 degrees).
#Now we must divide by 10 because the HMC6352 outputs are from 0- 3599 [https://www.sparkfun.com/datasheets/Components/HMC6352.pdf ]
print "Back in Main, Compass heading (out of 360 degrees) = " + str(float(msgResults[0])/10)
sear.stopSimulation()    # SEAR: added; the next script starts its own simulation
