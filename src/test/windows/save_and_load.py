# -*- coding: utf-8 -*-
# Loads an included project, saves and loads it under another name, drives, and prints results with all digits.
sear = Runtime.start("sear", "SEAR")
sear.loadProject("../sear/examples/office.sear")
sear.saveProject("Büro zwei.sear")
sear.newProject()
sear.loadProject("Büro zwei.sear")
sear.startSimulation()
sear.simSleep(0.5)
sear.drive(0.2, 1)
sear.simSleep(2)
print "pose", [repr(value) for value in sear.getPose("office Roomba")]
print "driven", repr(sear.getOdomResult())
print "to the left and right", repr(sear.getDistanceResult("leftFrontPing")), repr(sear.getDistanceResult("rightFrontPing"))
sear.stopSimulation()
