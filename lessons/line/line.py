# Lesson: follow a line. Three sensors look down: 0 on black tape, 100 on white floor, between at the edge.
sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.startSimulation()

while sear.getTime() < 20:
    left = sear.getReading("leftLine")
    middle = sear.getReading("middleLine")
    right = sear.getReading("rightLine")
    sear.setWheelSpeeds(0.1, 0.1)      # m/s, left and right: straight on
    sear.simSleep(0.03)
sear.setWheelSpeeds(0, 0)
