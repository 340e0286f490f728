# A yard with a truck and its trailer: the hitch is a ball joint. Reversing folds the trailer up.
from org.SEAR.POJOs import BallJoint, Box, Cone, Dynamics, Floor, Robots, SEARrobot, Wheel

sear = Runtime.start("sear", "SEAR")
sear.newProject()    # backs up the present project, if there is one

Floor("yard", 20, 20)
for number, (x, z) in enumerate(((3, 2), (3, -2), (-3, 2), (-3, -2), (0, 4), (0, -4))):
    Cone("cone %d" % (number + 1), 0.1, 0.3, 0.5).move(x, 0.15, z)

AXLE, LENGTH = -0.15, 0.4    # the truck's rear axle, and from there to the trailer's axle, metres
truck = Robots.car("truck")
trailer = SEARrobot("trailer")
trailer.addComponent(Dynamics("load", 2, 400, 0.5, 0.5, 1000, 0.02, 0, 0.05, AXLE - LENGTH, 0, 0, 0))    # on stiff springs
bed = Box("bed", 0.18, 0.4, 0.06, 2, 0, 0.05, 0.05)
bed.setColor("green")
trailer.addComponent(bed)
for name, x in (("left trailer wheel", 0.12), ("right trailer wheel", -0.12)):
    trailer.addWheel(Wheel(name, 0.05, 0.03, 2, x, 0, 0))
BallJoint("hitch", truck, trailer, 0, 0.06, AXLE)
