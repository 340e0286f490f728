# SPDX-License-Identifier: Apache-2.0
"""Signals that end a program: Java in the process must not change what they do."""
import ctypes
import os
import signal
import socket
import sys
import threading
import time

# Signals whose handlers Java replaces at its start, by which it would end below the running Python
ENDING = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name))
_get = ctypes.pythonapi.PyOS_getsig
_get.restype = ctypes.c_void_p
_get.argtypes = (ctypes.c_int,)
_set = ctypes.pythonapi.PyOS_setsig
_set.restype = ctypes.c_void_p
_set.argtypes = (ctypes.c_int, ctypes.c_void_p)
_DEFAULT = None    # address of SIG_DFL
_ident = threading.get_ident
_now = time.monotonic


class Handlers:
    """The system's handlers of these signals. Create it before Java starts. Any thread."""

    def __init__(self):
        self._before = {number: _get(number) for number in ENDING} if os.name == "posix" else {}

    def restore(self):
        """Undoes what Java has changed."""
        for number, handler in self._before.items():
            _set(number, handler)


class Interrupter:
    """Makes calls of Java so that Ctrl+C ends them, by an interrupt of Java's thread: Python's own handler runs only
    after a call of the main thread. If the program has set another handler, calls go on until their end."""

    # A call that began later may be the program's reaction to the signal
    _BEGUN_SECONDS = 0.1
    # Code that has caught an interrupt may wait again
    _AGAIN_SECONDS = 0.05
    wakeup = -1    # Python writes the numbers of signals to this file descriptor when they arrive

    def __init__(self, threads):
        """threads: java.lang.Thread. Calls of other threads than this one are not interrupted."""
        self._threads = threads
        self._ident = None
        self._begun = 0.0       # when the innermost call has begun; 0 outside of calls
        self._late = False      # whether Java's thread may have an interrupt that came too late
        self._lock = threading.Lock()
        self._is_shared = "IPython" in sys.modules    # it takes the descriptor away at each prompt
        if threading.current_thread() is threading.main_thread():
            self._java = threads.currentThread()
            self._reader, self._writer = socket.socketpair()
            self._writer.setblocking(False)
            self._ident = threading.get_ident()
            self._listen()
            threading.Thread(target=self._watch, name="sear interrupts", daemon=True).start()

    def _listen(self):
        """Asks for the numbers of signals, unless another module has done so."""
        before = signal.set_wakeup_fd(self._writer.fileno(), warn_on_full_buffer=False)
        if before in (-1, self._writer.fileno()):
            Interrupter.wakeup = self._writer.fileno()
        else:
            signal.set_wakeup_fd(before)

    def call(self, method, arguments):
        """Returns the method's result. Any thread."""
        if _ident() != self._ident:
            return method(*arguments)
        if self._late or self._is_shared:
            self._settle()
            self._listen()
        before = self._begun
        self._begun = _now()
        try:
            return method(*arguments)
        finally:
            self._begun = before
            if self._late:
                self._settle()

    def _settle(self):
        with self._lock:
            self._threads.interrupted()
            self._late = False

    def _watch(self):
        while True:
            numbers = self._reader.recv(64)
            begun = self._begun
            if signal.SIGINT in numbers and signal.getsignal(signal.SIGINT) is signal.default_int_handler \
                    and _now() - begun > self._BEGUN_SECONDS:
                while self._interrupted(begun):
                    time.sleep(self._AGAIN_SECONDS)

    def _interrupted(self, begun):
        """Interrupts a call; returns False if it has ended."""
        with self._lock:
            self._late = True
            if self._begun == 0 or self._begun != begun:
                return False
            self._java.interrupt()
            return True


_forking = threading.local()    # mask: the thread's blocked signals before its fork


def _hold():
    """Blocks the signals until the forked process has its handlers."""
    _forking.mask = signal.pthread_sigmask(signal.SIG_BLOCK, ENDING)


def _release():
    signal.pthread_sigmask(signal.SIG_SETMASK, _forking.mask)


def _forget_java():
    """Restores the default action in a forked process. SEAR's exports may have set a handler of Java, which doesn't run
    there."""
    for number in ENDING:
        if signal.getsignal(number) == signal.SIG_DFL and _get(number) != _DEFAULT:
            _set(number, _DEFAULT)
    if Interrupter.wakeup >= 0:
        signal.set_wakeup_fd(-1)    # its other end belongs to the parent
    _release()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(before=_hold, after_in_parent=_release, after_in_child=_forget_java)
