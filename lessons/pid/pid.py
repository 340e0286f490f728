# Lesson: a controller of your own. Hold the robot on a slope, 0.5 m before the wall, by motor power alone.
sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.startSimulation()

WANTED = 0.5                # metres
STEP = 0.05                 # seconds
KP = 0.3                    # power per metre of error

while sear.getTime() < 20:
    error = sear.getDistanceResult("eye") - WANTED      # + too far away
    power = KP * error
    power = max(-1.0, min(1.0, power))
    sear.setMotorPower("leftMotor", power)
    sear.setMotorPower("rightMotor", power)
    sear.simSleep(STEP)
