# Solution: avoid walls. Turn away from near obstacles, and keep the direction of a started turn.
sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.startSimulation()

turn = 0
while sear.getTime() < 60:
    ahead = sear.getDistanceResult("frontEye")
    left = sear.getDistanceResult("leftEye")
    right = sear.getDistanceResult("rightEye")
    if min(ahead, left, right) < 0.3:
        if turn == 0:
            turn = 60 if left > right else -60
        sear.spin(turn)
    else:
        turn = 0
        sear.driveStraight(0.2)
    sear.simSleep(0.1)
sear.driveStraight(0)
