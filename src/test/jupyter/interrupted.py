"""An interrupt of the kernel ends a long wait, in real time and in lock-step. The kernel continues, also after a restart."""
from jupyter_client.manager import start_new_kernel

SECONDS = 600
BUILD = """
import threading, time
import sear
sear.start(headless=True, speed=%s)
from sear import *
robots = Runtime.start("robots", "SEAR")
robots.newProject()
Floor("ground", 4, 4)
Robots.rover("rover")
robots.startSimulation()
def tell(until):
    while robots.getTime() < until:
        time.sleep(0.01)
    print("waits", flush=True)
"""
WAIT = """
before = robots.getTime()
teller = threading.Thread(target=tell, args=(before + 1,))
teller.start()
robots.%s
"""


def run(client, code, told=None):
    """Returns the reply to a cell; calls told when the cell prints "waits"."""
    number = client.execute(code)
    while told:
        message = client.get_iopub_msg(timeout=SECONDS)
        if message["parent_header"].get("msg_id") == number and message["msg_type"] == "stream" and "waits" in message["content"]["text"]:
            told()
            told = None
    while True:
        reply = client.get_shell_msg(timeout=SECONDS)
        if reply["parent_header"].get("msg_id") == number:
            return reply["content"]


def ok(client, code):
    """Runs a cell that must not fail."""
    reply = run(client, code)
    assert reply["status"] == "ok", reply


manager, client = start_new_kernel(kernel_name="python3", startup_timeout=SECONDS)
try:
    for speed, waits in (("'max'", ("simSleep(1000000)", "step(10000000)")), ("5", ("simSleep(1000000)",))):
        ok(client, BUILD % speed)
        for wait in waits:
            reply = run(client, WAIT % wait, manager.interrupt_kernel)
            assert reply["status"] == "error" and reply["ename"] == "KeyboardInterrupt", reply
            ok(client, "teller.join()\nrobots.resume()\nbefore = robots.getTime()\nrobots.simSleep(2)\n"
                       "passed = robots.getTime() - before\nassert 1.999 < passed < 900000, passed")
            print("%s at speed %s was interrupted" % (wait, speed.strip("'")))
        ok(client, "robots.stopSimulation()\nrobots.startSimulation()\nrobots.simSleep(0.5)\nrobots.stopSimulation()")
        manager.restart_kernel()
        client.wait_for_ready(timeout=SECONDS)
finally:
    client.stop_channels()
    manager.shutdown_kernel(now=True)
