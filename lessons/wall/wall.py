# Lesson: follow a wall. It is on the right; one eye looks there, one ahead.
sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.startSimulation()

WANTED = 0.3                # metres from the right eye to the wall
SPEED = 0.2                 # metres a second
HALF_TRACK = 0.129          # metres from the robot's middle to a wheel

def steer(speed, turn):
    """Metres a second, and radians a second to the left."""
    sear.setWheelSpeeds(speed - turn * HALF_TRACK, speed + turn * HALF_TRACK)

while sear.getTime() < 20:
    right = sear.getDistanceResult("rightEye")
    steer(SPEED, 0.5 * (WANTED - right))    # to the left, if the wall is too near
    sear.simSleep(0.05)
steer(0, 0)
