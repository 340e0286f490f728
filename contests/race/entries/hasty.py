# Drives fast; backs up and turns when something is right ahead.
sear = Runtime.start("sear", "SEAR")
sear.startSimulation()

while True:
    off = sear.getCompassResult("compass") - 90     # heading error, degrees, + to the right
    turn = max(-0.1, min(0.1, 0.005 * off))
    sear.setWheelSpeeds(0.4 - turn, 0.4 + turn)
    if sear.getReading("frontEye") < 0.2:
        sear.driveStraight(-0.3)
        sear.simSleep(1)
        sear.spin(60)
        sear.simSleep(1)
        sear.driveStraight(0.4)
        sear.simSleep(1.5)
    sear.simSleep(0.1)
