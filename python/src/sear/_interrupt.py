"""The interrupt of a terminal or a notebook while the main thread waits in Java, where Python's own does not come through."""
import contextlib
import signal
import socket
import sys
import threading


class _Watch:
    """From when it is made until it is closed, an interrupt calls a function at once, on a thread of its own, and nothing else. Main thread."""

    def __init__(self, interrupt):
        self._interrupt = interrupt
        self._lock = threading.Lock()
        self._over = False
        self.fired = False
        self._read, self._write = socket.socketpair()
        self._write.setblocking(False)
        self._file = signal.set_wakeup_fd(self._write.fileno(), warn_on_full_buffer=False)
        # Python's own handler would raise in the midst of JPype's work, which JPype does not survive
        self.handler = signal.signal(signal.SIGINT, self._note)
        threading.Thread(target=self._watch, name="sear interrupt", daemon=True).start()

    def _note(self, number, frame):
        self.fired = True

    def _watch(self):
        while True:
            numbers = self._read.recv(64)
            with self._lock:
                if self._over or not numbers:
                    self._read.close()
                    return
                if signal.SIGINT in numbers:
                    self.fired = True
                    self._interrupt()

    def close(self):
        """Everything is as it was."""
        with self._lock:
            self._over = True
        signal.set_wakeup_fd(self._file)
        signal.signal(signal.SIGINT, self.handler)
        self._write.close()


@contextlib.contextmanager
def interruptible(interrupt, clear):
    """What is done meanwhile is ended by an interrupt, which then does what it does otherwise. Main thread.

    interrupt: ends what Java waits for; called on another thread.
    clear: forgets it, if Java waits no more.
    """
    if not callable(signal.getsignal(signal.SIGINT)):    # nobody wants to be interrupted
        yield
        return
    watch = _Watch(interrupt)
    try:
        yield
    finally:
        watch.close()
        if watch.fired:
            clear()
    if watch.fired:
        watch.handler(signal.SIGINT, sys._getframe())
