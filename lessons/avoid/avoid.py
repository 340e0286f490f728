# Lesson: avoid walls. Three eyes look ahead, and 40 degrees to the left and to the right; they see up to 0.8 m.
sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.startSimulation()

while sear.getTime() < 60:
    ahead = sear.getDistanceResult("frontEye")      # metres
    left = sear.getDistanceResult("leftEye")
    right = sear.getDistanceResult("rightEye")
    sear.driveStraight(0.2)     # whatever is there
    sear.simSleep(0.1)
sear.driveStraight(0)
