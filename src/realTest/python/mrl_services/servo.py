# Servo: moves to an angle at full speed and slowly, and reports its arrival.
arduino = board()
neck = Runtime.start("neckServo", "Servo")
neck.setPin(3)
neck.attach(arduino)
for angle in (120, 60, 90):
    neck.moveTo(angle)
    until("the servo is at %d degrees" % angle, lambda: abs(sear.getServo("neck") - (angle - 90)) < 1.5)
neck.setSpeed(60.0)
start = sear.getTime()
neck.moveTo(150)
until("the servo is at 150 degrees", lambda: abs(sear.getServo("neck") - 60) < 1.5)
check("seconds for 60 degrees", sear.getTime() - start, 1, 0.4)
