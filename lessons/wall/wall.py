# Lesson: follow a wall on the right. One eye looks right, one ahead.
sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.startSimulation()

WANTED = 0.3                # metres from the right eye to the wall
SPEED = 0.2                 # m/s
HALF_TRACK = 0.129          # metres from the robot's middle to a wheel

def steer(speed, turn):
    """Drives at a speed, m/s, and turns left at a rate, rad/s."""
    sear.setWheelSpeeds(speed - turn * HALF_TRACK, speed + turn * HALF_TRACK)

while sear.getTime() < 20:
    right = sear.getDistanceResult("rightEye")
    steer(SPEED, 0.5 * (WANTED - right))    # left if the wall is too near
    sear.simSleep(0.05)
steer(0, 0)
