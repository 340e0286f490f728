"""Java's packages as modules, so that a script of MyRobotLab finds what it imports: `from org.SEAR.POJOs import Box`."""
import importlib.machinery
import sys
import types

from . import _errors
from ._names import OBJECTS
from ._objects import java_class

ROOTS = ("org", "java", "javax")
POJOS = "org.SEAR.POJOs"


class _Package(types.ModuleType):
    """A package of Java; its classes are looked up when they are asked for."""

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        if self.__name__ == "java.lang" and isinstance(getattr(_errors, name, None), type):
            return getattr(_errors, name)
        if not name[:1].isupper():
            raise AttributeError("Java has no package %s.%s here" % (self.__name__, name))
        found = java_class(self.__name__ + "." + name)
        setattr(self, name, found)
        return found


class _Finder:
    """Makes the modules."""

    @staticmethod
    def find_spec(name, path=None, target=None):
        """Of a package of Java; None of all else, and of what is a class."""
        parts = name.split(".")
        if parts[0] not in ROOTS or (parts[-1][:1].isupper() and parts[-1] not in ("SEAR", "POJOs")):
            return None
        return importlib.machinery.ModuleSpec(name, _Finder, is_package=True)

    @staticmethod
    def create_module(spec):
        """One package."""
        module = _Package(spec.name)
        if spec.name == POJOS:
            module.__all__ = list(OBJECTS)
        return module

    @staticmethod
    def exec_module(module):
        """There is nothing to do: classes come when they are asked for."""


def install():
    """From now on Java's packages can be imported; packages of that name that Python finds come first."""
    if _Finder not in sys.meta_path:
        sys.meta_path.append(_Finder)
