"""An interrupt of the kernel ends a long wait, in real time and in lock-step. The kernel continues, also after a restart.
SIGTERM ends the kernel."""
import signal
import time

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
%s
"""


def run(client, code, told=None):
    """Returns the reply to a cell; calls told when the cell prints "waits"."""
    number = client.execute(code, stop_on_error=False)    # otherwise the kernel aborts cells that follow an interrupt at once
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
    for speed, waits in (("'max'", ("robots.simSleep(1000000)", "robots.step(10000000)")),
                         ("5", ("robots.simSleep(1000000)", "time.sleep(1000000)"))):
        ok(client, BUILD % speed)
        for wait in waits:
            reply = run(client, WAIT % wait, manager.interrupt_kernel)
            assert reply["status"] == "error" and reply["ename"] == "KeyboardInterrupt", reply
            ok(client, "teller.join()\nrobots.resume()\nbefore = robots.getTime()\nrobots.simSleep(2)\n"
                       "passed = robots.getTime() - before\nassert 1.999 < passed < 900000, passed")
            print("%s at speed %s was interrupted" % (wait.replace("robots.", ""), speed.strip("'")))
        ok(client, "robots.stopSimulation()\nrobots.startSimulation()\nrobots.simSleep(0.5)\nrobots.stopSimulation()")
        manager.restart_kernel()
        client.wait_for_ready(timeout=SECONDS)
    ok(client, BUILD % "1")
    client.execute("robots.simSleep(1000000)")
    manager.signal_kernel(signal.SIGTERM)
    end = time.monotonic() + SECONDS
    while manager.is_alive():
        assert time.monotonic() < end, "SIGTERM has not ended the kernel"
        time.sleep(0.05)
    print("SIGTERM has ended the kernel")
finally:
    client.stop_channels()
    manager.shutdown_kernel(now=True)
