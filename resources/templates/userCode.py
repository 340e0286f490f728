# userCode.py: drives a simulated robot and reads its microcontroller's simple sensors (controller.py) over a serial
# port, as with real hardware. Adapt names, ports and the folder of controller.py.

controllerFile = "SEARproject/controller.py"
robotPort = "/dev/SEAR_Robot_01"
controllerPort = "/dev/user_CONTROLLER_01"

SONAR_1 = 0x2B
SONAR_2 = 0x2C
ACCELEROMETER = 0x2D
GYROSCOPE = 0x2E
COMPASS = 0x2F

sear = Runtime.start("SEAR", "SEAR")
if not sear.isSimulating():
    sear.startSimulation()
sear.simSleep(1)                        # lets objects come to rest
python.execFile(controllerFile)         # the microcontroller

def connectRoomba(roomba, port):
    """MyRobotLab's Roomba service closes its port immediately and talks through the service named "serial": this
    connects that service."""
    roomba.connect(port)
    line = Runtime.getService("serial")
    if line is not None and not line.isConnected():
        line.connect(port, 57600, 8, 1, 0)

roomba = Runtime.start("robot_Dynamics1", "Roomba")
connectRoomba(roomba, robotPort)
roomba.startup()
roomba.control()

# ---- the conversation with the controller --------------------------------------------------------------------------------------------------

msgBuffer = []

def onControllerReply(data):
    """Called with each byte that arrives, 0 to 255."""
    msgBuffer.append(data)

userSerial = Runtime.start("userSerial", "Serial")
userSerial.disconnect()
userSerial.connect(controllerPort, 9600, 8, 1, 0)
userSerial.addListener("publishRX", python.getName(), "onControllerReply")

def ask(sensorNumber, count):
    """Requests a sensor, waits for its 16-bit numbers (high byte first), and returns them."""
    del msgBuffer[:]
    userSerial.write(0x8E)
    userSerial.write(sensorNumber)
    deadline = sear.getTime() + 5
    while len(msgBuffer) < 2 * count and sear.getTime() < deadline:
        sear.simSleep(0.02)
    if len(msgBuffer) < 2 * count:
        raise RuntimeError("sensor " + str(sensorNumber) + " sent " + str(len(msgBuffer)) + " of " + str(2 * count) + " bytes")
    return [msgBuffer[2 * i] * 256 + msgBuffer[2 * i + 1] for i in range(count)]

ADC_STEPS_PER_VOLT = 1024 / 3.3
AT_REST_ADXL330 = int(1.5 * ADC_STEPS_PER_VOLT)     # readings at rest
AT_REST_IDG500 = int(1.35 * ADC_STEPS_PER_VOLT)

def metresPerSecondSquared(counts):
    return (counts - AT_REST_ADXL330) / ADC_STEPS_PER_VOLT / 0.3 * 9.80665

def degreesPerSecond(counts):
    return (counts - AT_REST_IDG500) / ADC_STEPS_PER_VOLT / 0.002

print "Sonar 1: " + str(ask(SONAR_1, 1)[0]) + " cm"
print "Sonar 2: " + str(ask(SONAR_2, 1)[0]) + " cm"
print "Acceleration x, y, z: " + ", ".join(["%.1f" % metresPerSecondSquared(value) for value in ask(ACCELEROMETER, 3)]) + " m/s^2"
print "Rotation x, y, z: " + ", ".join(["%.0f" % degreesPerSecond(value) for value in ask(GYROSCOPE, 3)]) + " degrees/s"
print "Heading: " + str(ask(COMPASS, 1)[0] / 10.0) + " degrees"
