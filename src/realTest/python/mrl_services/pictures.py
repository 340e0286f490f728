# Plots: a PNG and an SVG of lists and of a record, drawn by MyRobotLab's Java. Warnings contain the script's line
# there, too.
import os
sear.recordRun("pictures.searlog")
times, metres = [], []
sear.setWheelSpeeds("rover", 0.1, 0.1)
while len(times) < 5:
    sear.simSleep(0.1)
    times.append(sear.getTime())
    metres.append(sear.getDistanceResult("sonar"))
sear.setWheelSpeeds("rover", 0, 0)
sear.endRecord()
sear.savePlot("pictures.png", "time (s)", times, "distance (m)", metres)
sear.savePlot("pictures.svg", "time (s)", times, {"distance (m)": metres, "driven (m)": [metres[0] - one for one in metres]})
sear.saveRecordPlot("pictures.searlog", ["rover.speed", "sonar"], "record.png")
if open("pictures.png", "rb").read(4) != "\x89PNG" or open("record.png", "rb").read(4) != "\x89PNG":
    raise AssertionError("no PNG")
if ">distance</text>" not in open("pictures.svg").read():
    raise AssertionError(open("pictures.svg").read())

warned = []
def onWarned(status):
    warned.append(status.detail)
sear.addListener("publishStatus", "python", "onWarned")
Box("late", 1, 1, 1).move(0, 0.5, 8)
until("a warning with its line", lambda: [one for one in warned if "was made while a simulation runs" in one])
line = [one for one in warned if "was made while a simulation runs" in one][0]
if not " (line " in line:
    raise AssertionError(line)
spare = Arduino("spare")
spare.wire(9, "leftEngine", "pwm")    # a part by its name
if [wire.getPart() for wire in spare.getWires()] != ["leftEngine"]:
    raise AssertionError(spare.getWires())
for file in ("pictures.searlog", "pictures.png", "pictures.svg", "record.png"): os.remove(file)
