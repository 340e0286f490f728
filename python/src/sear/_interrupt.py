"""Interrupts from a terminal or notebook while the main thread waits in Java, where Python's own interrupt has no
effect."""
import contextlib
import signal
import socket
import sys
import threading


class _Watch:
    """Calls a function immediately on an interrupt, on its own thread, from creation until close(). Main thread."""

    def __init__(self, interrupt):
        self._interrupt = interrupt
        self._lock = threading.Lock()
        self._over = False
        self.fired = False
        self._read, self._write = socket.socketpair()
        self._write.setblocking(False)
        self._file = signal.set_wakeup_fd(self._write.fileno(), warn_on_full_buffer=False)
        # Python's own handler would raise inside JPype's code, which JPype does not tolerate
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
        """Restores the previous state."""
        with self._lock:
            self._over = True
        signal.set_wakeup_fd(self._file)
        signal.signal(signal.SIGINT, self.handler)
        self._write.close()


@contextlib.contextmanager
def interruptible(interrupt, clear):
    """Lets an interrupt end the block; the interrupt's usual handler runs afterwards. Main thread.

    interrupt: ends the wait in Java; called on another thread.
    clear: clears the interrupt if Java is not waiting.
    """
    if not callable(signal.getsignal(signal.SIGINT)):    # interrupts are disabled
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
