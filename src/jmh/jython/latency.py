# SPDX-License-Identifier: Apache-2.0
# Measures a script's view in the embedded MyRobotLab, in real time: start, scan by method call, scan through the LIDAR
# service, memory. scripts/benchmark runs it with "sear" in a folder with a SEARproject that has a LIDAR. An environment
# variable names the output file for the JSON.
import json
import os
import random
import threading
from java.lang import System
from java.lang.management import ManagementFactory
from javax.management import ObjectName

out = {"scriptBegins": ManagementFactory.getRuntimeMXBean().getUptime() / 1e3}
SCANS = int(os.environ["SEAR_BENCHMARK_SCANS"])
random.seed(2026)

def nanos():
    return System.nanoTime()

def cpu():
    """Returns the CPU seconds of the whole JVM."""
    return ManagementFactory.getPlatformMBeanServer().getAttribute(ObjectName("java.lang:type=OperatingSystem"), "ProcessCpuTime") / 1e9

def summary(seconds):
    seconds = sorted(seconds)
    return {"median": seconds[len(seconds) // 2], "max": seconds[-1], "count": len(seconds)}

sear = Runtime.start("sear", "SEAR")
begin = nanos()
cpuBegin = cpu()
sear.startSimulation()
beams = sear.getLidarResult("lidar0")
out["toReading"] = (nanos() - begin) / 1e9
out["toReadingCpu"] = cpu() - cpuBegin
out["readingAt"] = System.currentTimeMillis() / 1e3
out["beams"] = len(beams)

calls = []
for i in range(SCANS):
    sear.simSleep(random.uniform(0, 0.05))
    begin = nanos()
    sear.getLidarResult("lidar0")
    calls.append((nanos() - begin) / 1e9)
out["call"] = summary(calls)

came = threading.Event()
cameAt = [0]

def onScan(data):
    cameAt[0] = nanos()
    came.set()

lidar = Runtime.start("lidar", "LIDAR")
lidar.connect("lidarUser")
lidar.addListener("publishLidarData", python.getName(), "onScan")

def waitFor(condition, what):
    until = nanos() + 60e9
    while not condition():
        if nanos() > until:
            raise Exception(what + " did not happen within 60 s")
        sear.simSleep(0.02)

for baud in (38400, 500000):
    lidar.setBaud(baud)
    waitFor(lambda: lidar.getConfig().baud == baud, "the change to %d baud" % baud)
    scans = []
    for i in range(SCANS):
        sear.simSleep(random.uniform(0, 0.05))
        came.clear()
        begin = nanos()
        lidar.singleScan()
        if not came.wait(60):
            raise Exception("no scan within 60 s")
        scans.append((cameAt[0] - begin) / 1e9)
    out["scan%d" % baud] = summary(scans)
out["values"] = len(lidar.getLastScan().raw)
lidar.disconnect()
sear.stopSimulation()

for line in open("/proc/self/status"):
    if line.startswith("VmHWM:"):
        out["peakResident"] = int(line.split()[1]) * 1024
target = open(os.environ["SEAR_BENCHMARK_OUT"], "w")
json.dump(out, target)
target.close()
