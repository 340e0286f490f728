# SPDX-License-Identifier: Apache-2.0
"""Callbacks: a Python thread polls the service Python3 for calls from MyRobotLab and runs them one by one."""
import sys
import threading
import types

from . import _errors
from ._objects import java_class

RUNTIME = "org.myrobotlab.service.Runtime"
TYPE = "Python3"
PATIENCE = 500  # ms that one poll waits in Java
# Functions that Serial.addByteListener names: by which publisher, and other functions of which a script needs one
BYTES = "onByte", "onBytes"
UNNEEDED = {"onByte": (".publishRX", BYTES), "onBytes": (".publishBytes", BYTES), "onConnect": (".publishConnect", BYTES),
            "onDisconnect": (".publishDisconnect", BYTES)}


class PythonService:
    """The service of this program, started when first used.

    addListener takes `python.getName()`. Callbacks are functions of the script, found by name.
    """

    def __init__(self):
        self._service = None
        self._thread = None
        self._lock = threading.Lock()
        self._ended = False
        self.failed = False

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        return getattr(self._started(), name)

    def _started(self):
        with self._lock:
            if self._service is None:
                runtime = java_class(RUNTIME)
                name = "python"
                number = 2
                while runtime.getService(name) is not None:
                    name = "python3" if number == 2 else "python3_%d" % (number - 1)
                    number += 1
                self._service = runtime.start(name, TYPE)
                self._ended = False
                self._thread = threading.Thread(target=self._serve, name="sear callbacks", daemon=True)
                self._thread.start()
            return self._service

    def _serve(self):
        while not self._ended:
            try:
                call = self._service.take(PATIENCE)
            except Exception:    # Java has ended
                return
            if call is not None:
                self._carry_out(*call)

    def _carry_out(self, publisher, name, arguments):
        main = sys.modules["__main__"]
        function = getattr(main, name, None)
        if function is None:
            if name in UNNEEDED and publisher.endswith(UNNEEDED[name][0]) and any(hasattr(main, one) for one in UNNEEDED[name][1]):
                return
            from ._hints.names import nearest
            meant = nearest(name, [one for one, value in vars(main).items() if isinstance(value, types.FunctionType)])
            self._tell("%s calls back %s, but the script has no function of that name%s" % (publisher, name, meant and "; " + meant))
            return
        try:
            function(*arguments)
        except Exception as error:
            self._tell("%s called back %s, which failed:\n%s" % (publisher, name, _errors.told(error, function)))

    def _tell(self, text):
        self.failed = True
        print("[ERROR] " + text.rstrip(), file=sys.stderr)

    def end(self):
        """Accepts no more calls; a running one completes."""
        self._ended = True
        service, self._service = self._service, None
        if service is not None:
            service.wakeUp()
            if self._thread is not threading.current_thread():
                self._thread.join(10)
            java_class(RUNTIME).release(service.getName())
