# Lesson: drive a square. The robot looks east; the first corner is 1 m ahead of it.
sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.startSimulation()

sear.driveStraight(0.2)     # metres a second
sear.simSleep(5)            # seconds
sear.driveStraight(0)
sear.simSleep(0.5)          # it takes a moment to stop
print("At the first corner.")

# And now? sear.spin(degrees a second) turns to the left.
