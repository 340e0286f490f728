# Solution: follow a wall. Distance and its change steer. At a corner ahead turn away, at the end of the wall turn
# around it.
sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.startSimulation()

WANTED = 0.3
SPEED = 0.2
HALF_TRACK = 0.129

def steer(speed, turn):
    """Drives: metres per second, and radians per second to the left."""
    sear.setWheelSpeeds(speed - turn * HALF_TRACK, speed + turn * HALF_TRACK)

before = sear.getDistanceResult("rightEye")
while sear.getTime() < 100:
    right = sear.getDistanceResult("rightEye")
    if sear.getDistanceResult("frontEye") < 0.35:
        steer(0, 0.8)
    elif right > 0.75:
        steer(SPEED, -SPEED / 0.45)
    else:
        turn = 6 * (WANTED - right) - 9 * (right - before) / 0.05
        steer(SPEED, max(-0.8, min(0.8, turn)))
    before = right
    sear.simSleep(0.05)
steer(0, 0)
