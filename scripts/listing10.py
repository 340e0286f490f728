# Listing 10 of the dissertation: the controller's side of a custom controller, controller.py. Listing 9 runs it and reads
# its sensors. For your own robots use the templates userCode.py and controller.py of SEAR's jar (sear.copyTemplate), which
# work with today's API. Lines are as printed; each deviation has a comment "# SEAR:". The indentation is corrected, too.
from org.myrobotlab.serial import SerialDeviceFactory;
from org.myrobotlab.serial import VirtualSerialPort;
from org.myrobotlab.service import Serial;
import java.lang.String;    # SEAR: printed "Java"; the package is java
import struct
import math

previousCodeValue=0


# this function sends int data back to the userCode over the serial connection.
def sendInt(message):
    lowByte =(message & 0x0000ff)
    highByte = ((message& 0x00ff00) >>8)
    print "Sending HighByte:" + hex(highByte)#highByte, highByte.encode('hex')
    #http://stackoverflow.com/questions/12214801/python-print-a-string-as-hex-bytes
    SEAR_CONTROLLER_Serial.write(highByte)
    print "Sending LowByte: " + hex(lowByte) #lowByte, lowByte.encode('hex')
    SEAR_CONTROLLER_Serial.write(lowByte)


def onControllerByte(data):    # SEAR: printed "input()"; the value is the argument, and a callback's name belongs to its first publisher
    global previousCodeValue
    currentCodeValue = ord(struct.pack('B', data)) #pack into an unsigned byte    # SEAR: printed "msg_serialController_publishByte.data[0]"
    if currentCodeValue == 0x8E and previousCodeValue != 0x8E : #142 in decimal is the Roomba opcode for "get sensor value"
        #It should be followed by a single byte stating which sensor to get the value of
        #since Roomba reserves 0-42, our first sensor will start at 43 decimal and move up from there.
        #this gives us a possibility of 255-42 = 213 possible different commands (sensors)
        #The user must know how many bytes to expect back (how big the result of the sensor will be)
        previousCodeValue = 0x8E

    if currentCodeValue == 0x2B and previousCodeValue == 0x8E: # 0x2B = 43 decimal which is our first sensor number.
        #In here, you could request any sensor data from the SEAR simulator (specifically from
        #sensors that don't have their own serial ports. For now let's try to get the PING sensor value.
        #The PING sensor will return a Java float
        #The name of this sensor on the robot is in quotes to identify it from other sonar sensors that the robot might have.
        distance1 = sear.getDistanceResult("testPing1")
        # convert the distance to cm and send as an int back over serial:
        numCentimeters =int(distance1*100)
        sendInt(int(distance1*100))

    if currentCodeValue == 0x2C and previousCodeValue == 0x8E:# 0x2C = 44 decimal which is our second sensor number.
        #The name of this sensor on the robot is in quotes to identify it from other sonar sensors that the robot might have.
        distance2 = sear.getDistanceResult("MyNewestSONAR")
        # convert the distance to cm and send as an int back over serial.
        numCentimeters =int(distance2*100)
        sendInt(int(distance2*100))


    if currentCodeValue == 0x2D and previousCodeValue == 0x8E: # 0x2D = 45 decimal which is our third sensor number.
        #This results in a comma separated String containing X, Y and z respectively. We can simply parse the string to send the results.
        accelerations = sear.getAccelResult("accel")

        # convert each accel axis reading to a single int and send over serial.
        # SEAR's accelerometers output floats in meters/second^2. In the ADXL330 for instance, each axis responds based on a measurements of
        # "g-forces". We can assume that on the actual hardware, the microcontroller would handle converting the analog input from the
        # accelerometers to meters/second^2 before it sends the values back as 3 ints: x, y, then z.
        #In the ADXL330 though, 0Gs is at the midpoint of the analog output (if Vcc=3v, midpoint = 1.5volts) This will correspond to 10-bit
        # resolution (in an Arduino for example) of about 512. So when an axis = 0G, the numeric value expected should be in the center of that
        # range.
        # the ADXL330 also has a 300mV/G resolution, so all of this information should be taken into account when formatting the data
        tokens = accelerations.split(',') # Split my CSV string into individual number-strings
        #from meters/sec^2 to #Gs
        #number of Gs to mV/G, Make sure not to go higher than the range of the ADXL330 +-3.6Gs
        #from Gs to volts (range must be shifted so 1.5volts = 0Gs)
        #from volts (what the ADXL330 outputs) to ADC steps
        #(an arduino with 3.3v AREF using 10-bit ADC) = 310.30303 ADC steps/volt
        #send this ADC value back to MRL (userCode), so it can handle converting it to useful values for a robot or filter it, etc.

        integerAccelX = int((float(tokens[0]) /-9.8 * 0.3 + 1.5)* 310.30303)
        if integerAccelX >1023:
            integerAccelX = 1023
        #integerAccelX = int(float(tokens[0]))

        integerAccelY = int((float(tokens[1]) /-9.8 * 0.3 + 1.5)* 310.30303)


        if integerAccelY >1023:
            integerAccelY= 1023
        integerAccelZ = int((float(tokens[2]) /-9.8 * 0.3 + 1.5)* 310.30303)
        if integerAccelZ >1023:
            integerAccelZ = 1023
        print "accel ints = "+ str(integerAccelX)+", "+ str(integerAccelY)+", "+ str(integerAccelZ)
        print "hex accel ints = "+ hex(integerAccelX)+", "+ hex(integerAccelY)+", "+ hex(integerAccelZ)
        sendInt(integerAccelX)  # Sending X acceleration value
        sendInt(integerAccelY)  # Sending Y acceleration value
        sendInt(integerAccelZ)  # Sending Z acceleration value


    if currentCodeValue == 0x2E and previousCodeValue == 0x8E: # 0x2E = 46 decimal which is our fourth sensor number.
        #SEAR's Gyro returns a CSV string of angular velocities (in radians) Let's convert these into the nearest integer value of rad/sec
        gyroReadings = sear.getGyroResult("gyro1")
        tokens = gyroReadings.split(',')  # Split the CSV string into individual number-strings


        # SEAR's Gyroscope returns values in radians / second.
        # In this example, we will mimic the IDG500 (which normally has 2 axis, but we will scale all 3 the same.
        #the IDG500 returns values on an analog output. Its datasheet values are for a VCC of 3.0 volts (not 3.3)
        # The value is scaled 2mv / (degree/second) and the output at 0 = 1.35v. There are 57.2957795 degrees per radian
        # If we are using an arduino with a AREF of 3.3v, that = 310.30303 ADC steps / volt

        integerGyroX = int(((float(tokens[0])*57.2957795 * 0.002)+ 1.35)*310.30303)    # SEAR: the print lacks a parenthesis
        integerGyroY = int(((float(tokens[1])*57.2957795 * 0.002)+ 1.35)*310.30303)    # SEAR: the print lacks a parenthesis
        integerGyroZ = int(((float(tokens[2])*57.2957795 * 0.002)+ 1.35)*310.30303)    # SEAR: the print lacks a parenthesis
        sendInt(integerGyroX)  # Sending X Gyro value
        sendInt(integerGyroY)  # Sending Y Gyro value
        sendInt(integerGyroZ)  # Sending Z Gyro value


    if currentCodeValue == 0x2F and previousCodeValue == 0x8E: # 0x2F = 47 decimal which is our fifth sensor number.
        #The name of this sensor on the robot is in quotes to identify it from other sonar sensors that the robot might have.
        rawHeading = sear.getCompassResult("comp1")
        #Note that SEAR returns +-180 degrees, so we must make this 0-360:
        if rawHeading < 0:
            rawHeading = rawHeading + 360


        # The compass sensor modeled here is the simple HMC6352 in "heading" mode which will return a single value from 0-360.0 degrees in tenths
        # of a degree (in steps of 0.5 degrees). The simulated SEARcompass returns a float from 0-360.
        #We must convert the SERAcompass value to mimic the output of the HMC6352. So we will first round to the nearest 0.5 degrees. :
        #rounds to the nearest 0.5 http://stackoverflow.com/questions/9758513/how-can-i- round-up-numbers-to-the-next-half-integer
        heading = 0.5 * math.ceil(2.0 * rawHeading)
        #Now we must multiply by 10 because the HMC6352 outputs are from 0-3599 [https://www.sparkfun.com/datasheets/Components/HMC6352.pdf ]
        intHeading = int(heading*10) # convert this to an integer after it is multiplied, giving us a range of 0-3599
        sendInt(intHeading) # Now send it back to the userCode on the virtual serial port


# main function code goes below here.
UARTport = "/dev/my_Controller01"
userPort = "/dev/user_CONTROLLER_01"


#Create two virtual ports for UART and user and null them together:
# create 2 virtual ports
vp0 = VirtualSerialPort(UARTport);
vp1 = VirtualSerialPort(userPort);

# make null modem cable ;)
VirtualSerialPort.makeNullModem(vp0, vp1);

# add virtual ports to the serial device factory
SerialDeviceFactory.add(vp0);
SerialDeviceFactory.add(vp1);

# create the UART serial service
SEAR_CONTROLLER_Serial = Runtime.createAndStart("serialController", "Serial")
SEAR_CONTROLLER_Serial.disconnect()    # SEAR: added, for a second run in one session
SEAR_CONTROLLER_Serial.connect(UARTport);

#have controller listening to userCode
SEAR_CONTROLLER_Serial.addListener("publishRX", python.name, "onControllerByte")    # SEAR: printed "publishByte" and "input", see above
print "user should connect to port named: "+userPort
