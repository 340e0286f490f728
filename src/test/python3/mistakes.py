# SPDX-License-Identifier: Apache-2.0
"""Runs script.py of each folder in a folder as `python3 -m sear` does, one after the other in one process.

Writes the user's view to output.txt and the exit status to status.txt. A script is interrupted when the text of its
folder's message.txt appears, or after a limit.
"""
import _thread
import os
import sys
import threading
import time

import sear
from sear.__main__ import main

# Seconds
LIMIT = float(os.environ.get("LIMIT", 60))


def text(folder):
    """Returns what a script has printed, without the path of its folder."""
    with open(os.path.join(folder, "output.txt"), encoding="utf-8", errors="replace") as file:
        return file.read().replace(folder + "/", "")


def interrupt(folder, ended):
    """Interrupts the script once it has printed its message, or after the limit."""
    path = os.path.join(folder, "message.txt")
    message = None
    if os.path.exists(path):
        with open(path, encoding="utf-8") as file:
            message = file.read()
    limit = time.monotonic() + LIMIT
    while not (message and message in text(folder)) and time.monotonic() < limit and not ended.is_set():
        ended.wait(0.05)
    while not ended.is_set():
        _thread.interrupt_main()
        ended.wait(0.5)


def run(folder):
    """Runs one script."""
    sear.java_class("java.lang.System").setProperty("sear.project", os.path.join(folder, "SEARproject"))
    os.chdir(folder)
    output = os.open("output.txt", os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
    console = os.dup(1), os.dup(2)
    os.dup2(output, 1)
    os.dup2(output, 2)
    ended = threading.Event()
    threading.Thread(target=interrupt, args=(folder, ended)).start()
    try:
        status = main([os.path.join(folder, "script.py")])
    except SystemExit as error:
        status = error.code
    except KeyboardInterrupt:
        status = 130
    finally:
        ended.set()
        sear.Runtime.releaseAll()
        sear.python.failed = False
        sys.stdout.flush()
        sys.stderr.flush()
        for kept, number in zip(console, (1, 2)):
            os.dup2(kept, number)
        os.close(output)
    seen = text(folder)
    with open("output.txt", "w", encoding="utf-8") as file:
        file.write(seen)
    with open("status.txt", "w", encoding="utf-8") as file:
        file.write(str(status))


sear.start(headless=True, speed="max")
root = os.path.abspath(sys.argv[1])
for name in sorted(os.listdir(root)):
    run(os.path.join(root, name))
