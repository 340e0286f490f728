# Motor: two of them drive the rover, forward, backward, and in place.
arduino = board()
motors = {}
for side, pwm, direction in (("left", 9, 4), ("right", 10, 5)):
    motors[side] = Runtime.start(side + "Motor", "Motor")
    motors[side].setPwrDirPins(pwm, direction)
    motors[side].attach(arduino)

def drive(left, right):
    motors["left"].move(left)
    motors["right"].move(right)

def pose():
    return sear.getPose("rover")

start = pose()[2]
drive(0.5, 0.5)
until("it drives forward", lambda: pose()[2] > start + 0.2)
drive(-0.5, -0.5)
until("it drives backward", lambda: pose()[2] < start - 0.2)
drive(0, 0)
heading = pose()[4]
drive(-0.3, 0.3)
until("it turns to the left", lambda: 20 < (pose()[4] - heading) % 360 < 180)
for motor in motors.values(): motor.stop()
until("it stands", lambda: max(abs(sear.getMotorSpeed(side + "Engine")) for side in motors) < 0.01)
