# Solution: drive a square.
sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.startSimulation()

for side in range(4):
    sear.driveStraight(0.2)
    sear.simSleep(5)
    sear.driveStraight(0)
    sear.simSleep(0.5)
    sear.spin(45)
    sear.simSleep(2)
    sear.spin(0)
    sear.simSleep(0.5)
print("Once round.")
