# Solution: your own PID controller: the error, its sum over time, and its change.
sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.startSimulation()

WANTED = 0.5
STEP = 0.05
KP, KI, KD = 2.0, 1.5, 1.0

total = 0.0
before = sear.getDistanceResult("eye") - WANTED
while sear.getTime() < 20:
    error = sear.getDistanceResult("eye") - WANTED
    if abs(error) < 0.3:                                # far away the sum would only wind up
        total += error * STEP
    power = KP * error + KI * total + KD * (error - before) / STEP
    before = error
    power = max(-1.0, min(1.0, power))
    sear.setMotorPower("leftMotor", power)
    sear.setMotorPower("rightMotor", power)
    sear.simSleep(STEP)
