# Lesson: avoid walls. Three eyes look ahead and 40 degrees to both sides, up to 0.8 m.
sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.startSimulation()

while sear.getTime() < 60:
    ahead = sear.getDistanceResult("frontEye")      # metres
    left = sear.getDistanceResult("leftEye")
    right = sear.getDistanceResult("rightEye")
    sear.driveStraight(0.2)     # even into a wall
    sear.simSleep(0.1)
sear.driveStraight(0)
