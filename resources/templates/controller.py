# controller.py: the microcontroller of a simulated robot. It waits on its serial port for the byte 0x8E (Roomba:
# "sensor request") and a sensor number from 43 to 255. It then reads that sensor in the simulator and sends the reading
# as 16-bit numbers, high byte first. userCode.py runs this file. Adapt the ports, sensor names and numbers to your
# robot.
from org.myrobotlab.serial import SerialDeviceFactory
from org.myrobotlab.serial import VirtualSerialPort
import math

UARTport = "/dev/my_Controller01"
userPort = "/dev/user_CONTROLLER_01"

SENSOR_REQUEST = 0x8E
ADC_STEPS_PER_VOLT = 1024 / 3.3     # 10 bits, reference 3.3 V, as in an Arduino
GRAVITY = 9.80665                   # m/s^2

sear = Runtime.start("SEAR", "SEAR")

# ---- conversion of SEAR's readings to the devices' numbers ------------------------------------------------------------------------------

def centimetres(metres):
    """PING))): whole centimetres."""
    return int(round(metres * 100))

def adc(volts):
    """Returns the reading of a 10-bit analogue-to-digital converter."""
    return max(0, min(1023, int(volts * ADC_STEPS_PER_VOLT)))

def adxl330(metresPerSecondSquared):
    """ADXL330 at 3 V: 1.5 V at 0 g, 300 mV/g, at most 3.6 g."""
    g = max(-3.6, min(3.6, metresPerSecondSquared / GRAVITY))
    return adc(1.5 + 0.3 * g)

def idg500(radiansPerSecond):
    """IDG-500: 1.35 V at rest, 2 mV per degree/s, at most 500 degrees/s."""
    degrees = max(-500.0, min(500.0, math.degrees(radiansPerSecond)))
    return adc(1.35 + 0.002 * degrees)

def hmc6352(degrees):
    """HMC6352: heading in tenths of a degree, 0 to 3599. SEAR returns -180 to 180."""
    return int(round(degrees * 10)) % 3600

def axes(text):
    """Returns the three numbers of a text "x,y,z"."""
    return [float(token) for token in text.split(",")]

# ---- sensor numbers and their functions: each returns a list of 16-bit numbers ----------------------------------------------------------

def sonar1():
    return [centimetres(sear.getDistanceResult("testPing1"))]

def sonar2():
    return [centimetres(sear.getDistanceResult("MyNewestSONAR"))]

def accelerometer():
    return [adxl330(value) for value in axes(sear.getAccelResult("accel"))]

def gyroscope():
    return [idg500(value) for value in axes(sear.getGyroResult("gyro1"))]

def compass():
    return [hmc6352(sear.getCompassResult("comp1"))]

sensorCommands = {0x2B: sonar1, 0x2C: sonar2, 0x2D: accelerometer, 0x2E: gyroscope, 0x2F: compass}    # 43 to 47; up to 255 are free

# ---- the serial connection -----------------------------------------------------------------------------------------------------------------

def sendInt(number):
    controllerSerial.write((number >> 8) & 0xFF)
    controllerSerial.write(number & 0xFF)

expectSensorNumber = False

def controllerInput(data):
    """Called with each byte that arrives, 0 to 255."""
    global expectSensorNumber
    if not expectSensorNumber:
        expectSensorNumber = data == SENSOR_REQUEST
        return
    expectSensorNumber = False
    if data in sensorCommands:
        for number in sensorCommands[data]():
            sendInt(number)
    else:
        print "controller.py: there is no sensor number " + str(data) + "; there are " + str(sorted(sensorCommands.keys()))

# two virtual ports and a null-modem cable between them
vp0 = VirtualSerialPort(UARTport)
vp1 = VirtualSerialPort(userPort)
VirtualSerialPort.makeNullModem(vp0, vp1)
SerialDeviceFactory.add(vp0)
SerialDeviceFactory.add(vp1)

controllerSerial = Runtime.start("controllerSerial", "Serial")
controllerSerial.disconnect()
controllerSerial.connect(UARTport, 9600, 8, 1, 0)
controllerSerial.addListener("publishRX", python.getName(), "controllerInput")
print "controller.py: the user should connect to port " + userPort
