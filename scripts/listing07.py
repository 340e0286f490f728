# Listing 7 of the dissertation: a GPS sensor. The listing is a snippet that "should be added to Code Listing 2", which comes
# first, with the LIDAR of Listing 4.
# Lines are as printed; each deviation has a comment "# SEAR:".
from org.SEAR.POJOs import Cylinder
from org.SEAR.POJOs import Box
from org.SEAR.POJOs import Cone
from org.SEAR.POJOs import Wheel
from org.SEAR.POJOs import SEARrobot
from org.SEAR.POJOs import Gyroscope
from org.SEAR.POJOs import Accelerometer
from org.SEAR.POJOs import GPS
from org.SEAR.POJOs import Compass
from org.SEAR.POJOs import Odometer
from org.SEAR.POJOs import Distance
from org.SEAR.POJOs import LIDAR
from org.SEAR.POJOs import Dynamics

robot = SEARrobot("myRoomba");#create a "robotObject" entity

#setup suspension and communications ports
dyna = Dynamics("robotDynamics1", 400, 60, 0.3, 0.4, 10000, 0.1,
0, 0.1, 0, 0, 0, 180)
dyna.setPorts("/dev/my_Robot01", "/dev/SEAR_Robot_01")
robot.addComponent(dyna)

#create a cylinder for the body of the Roomba and apply a custom image to it

body = Cylinder("Roomba Body", 0.1666875, 0.0762, 400,
"./textures/roomba.jpg")
robot.addComponent(body)

#create and add the wheels to the robot object
cyl1 = Wheel("frontWheel", 0.0381, 0.03, 0)
cyl1.move(0, 0, 0.16)
robot.addWheel(cyl1);

#adding wheels saves wheel specs in the robot XML
cyl2 = Wheel("rightWheel", 0.0381, 0.03, 1)
cyl2.move(-0.16, 0, 0)
robot.addWheel(cyl2)

cyl3 = Wheel("leftWheel", 0.0381, 0.03, 1)
cyl3.move(0.16, 0, 0)
robot.addWheel(cyl3)

cyl4 = Wheel("backWheel", 0.0381, 0.03, 0)
cyl4.move(0, 0, -0.16)
robot.addWheel(cyl4);

from org.SEAR.POJOs import LIDAR

lidar1 = LIDAR ("myLidar") #creates LIDAR object named "myLidar"
lidar1.setRange(8.191)
lidar1.setSpread(180)
lidar1.setResolution(1.0)

#sets UART port, then the port the user will communicate with
lidar1.setPorts("/dev/my_Lidar01", "/dev/SEAR_LIDAR_01")
lidar1.setBaud(9600)
lidar1.move(0,0.15,0.2) #move the physical location of this sensor on the robot's body
lidar1.LMS(1)
robot.addComponent(lidar1) #add as a component of the robot

from org.SEAR.POJOs import GPS
# create a new GPS object (myGPS) with the name "gpsUnit1"
myGPS = GPS("gpsUnit1", 33.61, 182.5, -80.865)
myGPS.setPorts("/dev/my_GPS_01", "/dev/SEAR_GPS_01")
robot.addComponent(myGPS)
