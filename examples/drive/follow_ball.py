# Follows a kicked red ball: the camera gives its direction and size, the rover turns to it and keeps its distance.
from math import pi, radians, tan

DISTANCE = 0.7                                  # distance that the rover keeps, metres
BALL = 0.24                                     # diameter, metres
FOCAL = 160 / tan(radians(30))                  # pixels: half the picture is 30 degrees wide
KICKS = ((2, 0.5, 0.4), (6, -0.8, 0.5), (10, -0.2, -0.9), (14, 0.9, 0.1))     # time, and speed north and east

sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.loadProject("examples/ball.sear")    # backs up the present project
sear.startSimulation()
sear.simSleep(1)

kicks = list(KICKS)
seen = 0
looks = 0
speed = 0
turn = 0
while sear.getTime() < 25:
    if kicks and sear.getTime() >= kicks[0][0]:
        after, north, east = kicks.pop(0)
        sear.setVelocity("ball", north, 0, east)
    looks += 1
    blobs = sear.getBlobs("eye", "red")
    if blobs:
        seen += 1
        x, y, width, height, area = blobs[0]
        far = BALL * FOCAL / max(width, height)
        speed = max(-0.4, min(0.8, 1.2 * (far - DISTANCE)))
        turn = 1.6 * (159.5 - x) / FOCAL        # radians per second, to the left
    else:
        speed = 0                               # out of sight: keep turning to the side where it was last
        turn = 1 if turn > 0 else -1
    sear.setWheelSpeeds(speed - 0.15 * turn, speed + 0.15 * turn)
    sear.simSleep(0.1)
sear.driveStraight(0)
sear.simSleep(1)
blob = sear.getBlobs("eye", "red")[0]
sear.saveImage("eye", "ball.png")
print("In sight %d of %d times; at the end %.2f m ahead, %.0f degrees to the left." % (seen, looks, BALL * FOCAL / max(blob[2], blob[3]),
    (159.5 - blob[0]) / FOCAL * 180 / pi))
