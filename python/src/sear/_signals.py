# SPDX-License-Identifier: Apache-2.0
"""Signals that end a program: Java in the process must not change what they do."""
import ctypes
import os
import signal
import threading

# Signals whose handlers Java replaces at its start, by which it would end below the running Python
ENDING = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name))
_get = ctypes.pythonapi.PyOS_getsig
_get.restype = ctypes.c_void_p
_get.argtypes = (ctypes.c_int,)
_set = ctypes.pythonapi.PyOS_setsig
_set.restype = ctypes.c_void_p
_set.argtypes = (ctypes.c_int, ctypes.c_void_p)
_DEFAULT = None    # address of SIG_DFL


class Handlers:
    """The system's handlers of these signals. Create it before Java starts. Any thread."""

    def __init__(self):
        self._before = {number: _get(number) for number in ENDING} if os.name == "posix" else {}

    def restore(self):
        """Undoes what Java has changed."""
        for number, handler in self._before.items():
            _set(number, handler)


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
    _release()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(before=_hold, after_in_parent=_release, after_in_child=_forget_java)
