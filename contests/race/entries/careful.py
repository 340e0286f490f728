# Near an obstacle turns to the freer side and drives on a little, otherwise goes east by the compass.
sear = Runtime.start("sear", "SEAR")
sear.startSimulation()

while True:
    ahead = sear.getDistanceResult("frontEye")      # metres
    left = sear.getDistanceResult("leftEye")
    right = sear.getDistanceResult("rightEye")
    if min(ahead, left, right) < 0.3:
        sear.spin(60 if left > right else -60)
        while min(sear.getReading("frontEye"), sear.getReading("leftEye"), sear.getReading("rightEye")) < 0.35:
            sear.simSleep(0.1)
        sear.driveStraight(0.25)
        sear.simSleep(1)
    else:
        off = sear.getCompassResult("compass") - 90     # heading error, degrees, + to the right
        turn = max(-0.1, min(0.1, 0.005 * off))
        sear.setWheelSpeeds(0.25 - turn, 0.25 + turn)
    sear.simSleep(0.1)
