# SPDX-License-Identifier: Apache-2.0
"""Java's packages as Python modules, for scripts of MyRobotLab with imports like `from org.SEAR.POJOs import Box`."""
import importlib.machinery
import sys
import types

from . import _errors
from ._names import OBJECTS
from ._objects import java_class

ROOTS = ("org", "java", "javax")
POJOS = "org.SEAR.POJOs"


class _Package(types.ModuleType):
    """A Java package, which looks up its classes on first use."""

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        if self.__name__ == "java.lang" and isinstance(getattr(_errors, name, None), type):
            return getattr(_errors, name)
        if self.__name__ == POJOS and name not in OBJECTS:
            raise AttributeError(name)
        if not name[:1].isupper():
            raise AttributeError("Java has no package %s.%s here" % (self.__name__, name))
        found = java_class(self.__name__ + "." + name)
        setattr(self, name, found)
        return found


class _Finder:
    """Creates the modules."""

    @staticmethod
    def find_spec(name, path=None, target=None):
        """Returns the spec of a Java package; None for anything else, including classes."""
        parts = name.split(".")
        if POJOS.lower().startswith(name.lower()) and not POJOS.startswith(name):
            return None    # in other letters
        if parts[0] not in ROOTS or (parts[-1][:1].isupper() and parts[-1] not in ("SEAR", "POJOs")):
            return None
        return importlib.machinery.ModuleSpec(name, _Finder, is_package=True)

    @staticmethod
    def create_module(spec):
        """Creates the module of one package."""
        module = _Package(spec.name)
        if spec.name == POJOS:
            module.__all__ = list(OBJECTS)
        return module

    @staticmethod
    def exec_module(module):
        """Does nothing: classes are looked up on first use."""


def install():
    """Makes Java's packages importable. Python's own packages of the same name take precedence."""
    if _Finder not in sys.meta_path:
        sys.meta_path.append(_Finder)
