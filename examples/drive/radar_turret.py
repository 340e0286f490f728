# Sweeps a PING))) on a servo from left to right and draws a radar picture: # an echo, . circles at one, two and three metres.
from math import cos, floor, radians, sin

STEP = 3            # degrees
RANGE = 3.0         # metres; reading of the PING))) without an echo
ARM = 0.03          # metres from the turret's axis to the sensor
ACROSS, ALONG = 0.1, 0.2    # metres per character, which is twice as high as wide
COLUMNS, ROWS = 61, 16

sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.loadProject("examples/turret.sear")    # backs up the present project
sear.startSimulation()
sear.simSleep(1)

picture = [[" "] * COLUMNS for row in range(ROWS)]

def draw(letter, angle, distance):
    """@param angle degrees, + to the left"""
    column = int(floor(COLUMNS // 2 - distance * sin(radians(angle)) / ACROSS + 0.5))
    row = int(floor(ROWS - 1 - distance * cos(radians(angle)) / ALONG + 0.5))
    if 0 <= row < ROWS and 0 <= column < COLUMNS:
        picture[row][column] = letter

for circle in (1, 2, 3):
    for angle in range(-90, 91, 2):
        draw(".", angle, circle)
echoes = []
for angle in range(90, -91, -STEP):
    sear.setServo("turret", angle)
    while abs(sear.getServo("turret") - angle) > 0.1:
        sear.simSleep(0.02)
    sear.simSleep(0.05)
    distance = sear.getDistanceResult("ping")
    if distance < RANGE:
        echoes.append((distance + ARM, angle))
        draw("#", angle, distance + ARM)
draw("^", 0, 0)
sear.setServo("turret", 0)
for line in picture:
    print("".join(line))

# A wide beam detects an object before and after it points at it: the object is in the middle of the directions with the shortest range.
nearest = min(echoes)[0]
seen = [angle for distance, angle in echoes if distance < nearest + 0.02]
print("%d echoes. Nearest: %.2f m from the turret, %.0f degrees to the left." % (len(echoes), nearest, (max(seen) + min(seen)) / 2.0))
