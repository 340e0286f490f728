# SPDX-License-Identifier: Apache-2.0
"""Long calls of Java that signals interrupt, as they interrupt Python's own waits."""
import os
import queue
import threading

# Windows runs handlers of signals only between waits of the main thread
_LOOK_SECONDS = 0.1 if os.name == "nt" else None


class _Call:
    """A call that the waiter makes."""

    def __init__(self, call):
        self._call = call
        self._lock = threading.Lock()
        self._interrupt = None
        self._begun = threading.Event()
        self._done = threading.Event()
        self._error = None

    def make(self, threads):
        """Makes the call. threads: java.lang.Thread."""
        try:
            self._interrupt = threads.currentThread().interrupt
            self._begun.set()
            self._call()
        except BaseException as error:
            self._error = error
        with self._lock:
            self._interrupt = None
        try:
            threads.interrupted()    # an interrupt that came too late
        except Exception:    # Java has ended
            pass
        self._begun.set()
        self._done.set()

    def interrupt(self):
        """Ends the call."""
        self._begun.wait()
        with self._lock:
            if self._interrupt is not None:
                self._interrupt()

    def wait(self):
        """Waits for the end of the call. Runs handlers of signals meanwhile. Returns the call's error, or None."""
        while not self._done.wait(_LOOK_SECONDS):
            pass
        return self._error


class Waiter:
    """A thread that makes calls for the main thread, which in Java could not run handlers of signals."""

    def __init__(self, threads):
        """threads: java.lang.Thread, by which an exception of a handler, such as KeyboardInterrupt, ends the call."""
        self._threads = threads
        self._calls = queue.SimpleQueue()
        threading.Thread(target=self._serve, name="sear waiter", daemon=True).start()

    def _serve(self):
        while True:
            self._calls.get().make(self._threads)

    def run(self, call):
        """Makes a call. Main thread."""
        made = _Call(call)
        self._calls.put(made)
        try:
            error = made.wait()
        except BaseException:
            made.interrupt()
            made.wait()
            raise
        if error is not None:
            raise error
