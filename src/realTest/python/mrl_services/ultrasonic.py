# UltrasonicSensor: whole centimetres to the wall, reported on change.
arduino = board()
ranges = []
def onRoverRange(centimetres):
    ranges.append(centimetres)
ultrasonic = Runtime.start("ultrasonic", "UltrasonicSensor")
ultrasonic.addListener("publishRange", "python", "onRoverRange")
arduino.attach(ultrasonic, 7, 8)
ultrasonic.startRanging()
until("a range", lambda: ranges)
check("range in cm", ranges[-1], sear.getDistanceResult("sonar") * 100, 4)
ultrasonic.stopRanging()
