# Solution: follow a line. Its position under the sensors sets the wheel speeds.
sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.startSimulation()

SENSORS = (("leftLine", 0.015), ("middleLine", 0), ("rightLine", -0.015))     # metres to the left
off = 0.0                   # offset of the line to the left, metres
while sear.getTime() < 40:
    dark = [(100 - sear.getReading(name), x) for name, x in SENSORS]
    light = sum(value for value, x in dark)
    if light > 40:
        off = sum(value * x for value, x in dark) / light
    sear.setWheelSpeeds(0.15 - 7 * off, 0.15 + 7 * off)
    sear.simSleep(0.03)
sear.setWheelSpeeds(0, 0)
sear.simSleep(0.5)
