# -*- coding: utf-8 -*-
# Loads a shipped project, saves it under another name, loads that, drives and prints every digit of what comes out.
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
