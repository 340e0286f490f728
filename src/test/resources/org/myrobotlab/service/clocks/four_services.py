# Two robots and six services whose callbacks log what they hear and drive: in lock-step it ends with the same log and the same poses each time.
from org.SEAR.POJOs import Arduino, Box, Distance, Floor, GPS as Receiver, LIDAR as Scanner, Robots

SECONDS = 4

sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.newProject()
sear.setLockStep(True)

Floor("floor", 40, 40, False)
for number, (x, z) in enumerate(((-2, 3), (2.5, 4), (0, -3), (4, 0))):
    wall = Box("wall%d" % number, 3, 0.2, 1, 0)
    wall.move(x, 0.5, z)

def lidar(name, robot, port):
    scanner = Scanner(name)
    scanner.setModel("LMS200")
    scanner.setPorts("/dev/my_" + name, port)
    scanner.setBaud(38400)
    scanner.move(0, 0.2, 0)
    robot.addComponent(scanner)

first = Robots.create2("first", "/dev/my_first", "/dev/SEAR_first")
lidar("firstScanner", first, "/dev/SEAR_firstScanner")
receiver = Receiver("receiver", 33.61, 182.5, -80.865)
receiver.setPorts("/dev/my_receiver", "/dev/SEAR_receiver")
first.addComponent(receiver)

second = Robots.create2("second", "/dev/my_second", "/dev/SEAR_second")
second.move(1.5, 0, 0)
eye = Distance("eye", "GP2Y0A21", 0, 0.1, 0.2, 0, 0, 0)
second.addComponent(eye)
uno = Arduino("uno", "uno")
uno.setFirmware("StandardFirmata")
uno.setPorts("/dev/my_uno", "/dev/SEAR_uno")
uno.wire("A0", eye)
second.addComponent(uno)
lidar("secondScanner", second, "/dev/SEAR_secondScanner")
sear.startSimulation()

seen = []
turn = [0]

def firstScan(data):
    seen.append("scan of first %d %d" % (sum(data), turn[0]))
    speed = 100 + 10 * turn[0] % 70
    wheels["first"].write(137)
    for value in (0, speed, 0x80, 0):
        wheels["first"].write(value)

def secondScan(data):
    turn[0] += 1
    seen.append("scan of second %d" % sum(data))
    sear.driveStraight("second", 0.05 + turn[0] % 5 * 0.03)

def fix(tokens):
    turn[0] += 3
    seen.append("fix " + " ".join(tokens))
    sear.spin("first", 5 * (turn[0] % 9) - 20)

def pin(data):
    seen.append("uno %d" % data)
    if data & 1:
        turn[0] += 1
    sear.spin("second", turn[0] % 11 - 5)

def reading(reading):
    turn[0] += 1
    seen.append("%s %d" % (reading, turn[0]))

wheels = {}
for name in ("first", "second"):
    wheels[name] = Runtime.start(name + "Wheels", "Serial")
    wheels[name].connect("/dev/SEAR_" + name, 115200, 8, 1, 0)
    for value in (128, 131):
        wheels[name].write(value)
board = Runtime.start("board", "Serial")
board.connect("/dev/SEAR_uno", 57600, 8, 1, 0)
board.addListener("publishRX", python.getName(), "pin")
services = []
for name, callback in (("secondScanner", "secondScan"), ("firstScanner", "firstScan")):
    service = Runtime.start(name, "LIDAR")
    service.addListener("publishLidarData", python.getName(), callback)
    service.connect("/dev/SEAR_" + name, 38400)
    service.startStreaming()
    services.append(service)
gps = Runtime.start("receiver", "GPS")
gps.addListener("publishGGAData", python.getName(), "fix")
gps.connect("/dev/SEAR_receiver")
sear.addListener("publishReading", python.getName(), "reading")
sear.startPublishing("eye", 10)
sear.simSleep(4)                                    # the board starts, and blinks
gps.setRate(5)
for value in (0xF0, 0x7A, 50, 0, 0xF7, 0xC0, 1):    # the eye at pin A0, each 50 ms
    board.write(value)
for tenth in range(10 * SECONDS):
    sear.simSleep(0.1)
    seen.append("script %d %s" % (turn[0], list(sear.getPose("first"))))
result = "\n".join(seen) + "\n%s %s" % (list(sear.getPose("first")), list(sear.getPose("second")))
for service in services + [gps, board] + list(wheels.values()):
    service.disconnect()
sear.stopPublishing("eye")
sear.stopSimulation()
