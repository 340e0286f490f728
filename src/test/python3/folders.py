# Relative paths follow os.chdir, and calls that write return absolute paths. Run by Python3PackageTest, both ways.
import os
import pathlib
import re
import sear as package
from sear import _objects
from sear._objects import java_class

sear = Runtime.start("sear", "SEAR")
sear.loadProject("examples/ball.sear")
first = os.getcwd()
os.mkdir("sub")
os.chdir("sub")
here = os.getcwd()
sear.startSimulation()
record = sear.recordRun("run")
sear.simSleep(0.1)
sear.endRecord()
names = sear.getRecordNames("run")[:1]
written = [record, sear.saveImage("eye", "eye.png"), sear.savePlan("plan.svg"), sear.saveRecordPlot("run", names, "run.png"),
           sear.saveRecordCsv("run.searlog", names, pathlib.Path("run.csv")), sear.savePlot("plot.png", "a (s)", [0, 1], "b (m)", [0, 1]),
           package.Record("run").save("again.svg"), sear.getPlan().save("text.svg"), sear.getImage("eye").save("bytes.png")]
assert sear.getRecords() == ["run.searlog"], sear.getRecords()
kept = package.Record("run")
sear.stopSimulation()
written += [sear.saveProject("one"), sear.saveProject("two.sear", True), sear.copyTemplate("controller.py", "made")]
for path in written:
    assert os.path.isabs(path) and os.path.dirname(path) in (here, os.path.join(here, "made")) and os.path.isfile(path), path
sear.loadProject("one.sear")
sear.loadProject("two")
sear.loadProject("examples/office.sear")
sear.importEnvironment("one.sear")
try:
    sear.loadProject("none.sear")
except RuntimeError as error:
    assert os.path.join(here, "none.sear") in str(error), error
os.chdir("..")
assert os.getcwd() == first and len(kept.times) > 0
assert {name for name in os.listdir(".") if "SEARproject" not in name} == {"sub", "examples"}, os.listdir(".")
stubs = pathlib.Path(os.environ["SEAR_HOME"], "python", "sear", "__init__.pyi").read_text()
stubs = stubs[:stubs.index("def exportTcp(")]    # objects with paths of their own follow
filed = set(re.findall(r"def (\w+)\(.*\b(?:path|picture|csv|link|folder): ", stubs)) - {"__init__", "save"}
assert len(filed) > 12 and filed <= {name for _, name in _objects._FILED}, filed
for call in Runtime.start, Runtime.create, Runtime.createAndStart, Runtime.loadAndStart:
    try:
        call("arm", "Srevo")
    except ValueError as error:
        assert "did you mean Servo?" in str(error), error
    else:
        raise AssertionError(call)
try:
    Runtime.start("Clock")
except ValueError as error:
    assert 'Runtime.start("name", "Clock")' in str(error), error
wire = Runtime.start("wire", "Serial")
end = java_class("org.myrobotlab.service.Serial").connectVirtualUart("/dev/wire")
heard = []


def onByte(value):
    heard.append(value)


wire.addByteListener(python.getName())
wire.connect("/dev/wire")
end.write("ab")
while len(heard) < 2:
    sleep(0.01)
wire.disconnect()
assert heard == [97, 98] and not python.failed
print("folders follow")
