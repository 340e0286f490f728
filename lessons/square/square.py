# Lesson: drive a square. The robot looks east; the first corner is 1 m ahead.
sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.startSimulation()

sear.driveStraight(0.2)     # m/s
sear.simSleep(5)            # seconds
sear.driveStraight(0)
sear.simSleep(0.5)          # stopping takes a moment
print("At the first corner.")

# And now? sear.spin(degrees per second) turns left.
