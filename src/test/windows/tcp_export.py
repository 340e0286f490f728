# -*- coding: utf-8 -*-
# Exports the robot and the LIDAR as TCP ports and ends after an external program has driven the robot.
import sys
sear = Runtime.start("sear", "SEAR")
sear.loadProject("Büro zwei.sear")
sear.startSimulation()
sear.simSleep(3)
print "ports", sear.exportTcp("/dev/SEAR_Robot_01", 0), sear.exportTcp("/dev/SEAR_LIDAR_01", 0)
sys.stdout.flush()
while abs(sear.getOdomResult()) < 0.05:
    sear.simSleep(0.1)
print "driven from outside"
sear.stopSimulation()
