"""killed.py ROWS [SECONDS]: sweeps twice on two Dask workers, and kills one of the first two with SIGKILL at half the rows."""
import os
import signal
import sys
import threading

import psutil
import sear
from maze import chance

ROWS = int(sys.argv[1])
SIMULATED = int(sys.argv[2]) if len(sys.argv) > 2 else 10
killed = []


def kill():
    """Kills the worker of one of the child processes."""
    while True:
        try:
            with open("first/journal.jsonl", "rb") as journal:
                if sum(1 for line in journal) >= ROWS // 2:
                    break
        except FileNotFoundError:
            pass
        ended.wait(0.05)
    for process in psutil.Process().children(recursive=True):
        if "sear.sweeps._child" in process.cmdline():
            killed.append(process.parent().pid)
            os.kill(process.parent().pid, signal.SIGKILL)
            return


ended = threading.Event()
thread = threading.Thread(target=kill)
thread.start()
first = sear.sweep(chance, {"seconds": [SIMULATED]}, seeds=ROWS, workers=2, out="first")
thread.join()
second = sear.sweep(chance, {"seconds": [SIMULATED]}, seeds=ROWS, workers=2, out="second")
for name in ("rows.csv", "rows.parquet"):
    with open("first/" + name, "rb") as one, open("second/" + name, "rb") as other:
        assert one.read() == other.read(), name
assert first == second and len(killed) == 1
print("%d rows, %d ok, one worker killed, the same to the byte" % (len(first), sum(row["status"] == "ok" for row in first)))
