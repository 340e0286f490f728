"""Type hints of the package for editors and type checkers. WRITTEN"""
from typing import Any, Dict, List, Literal, Optional, Sequence, overload

import numpy as np

# Everything that `from sear import *` imports; the objects follow at the end.
__all__ = ["Runtime", "python", "start", "connect", "close", "sweep", "IllegalArgumentException", "IllegalStateException", "IOException",
           "JavaError", "NullPointerException", "UnsupportedOperationException", "JavaObject", "Record"]


class JavaError(Exception): ...
class IllegalArgumentException(JavaError, ValueError): ...
class IllegalStateException(JavaError, RuntimeError): ...
class IOException(JavaError, OSError): ...
class UnsupportedOperationException(JavaError, NotImplementedError): ...
class NullPointerException(JavaError, TypeError): ...


def start(*options: str, headless: Optional[bool] = ..., speed: Any = ..., seed: Optional[int] = ..., threads: Optional[int] = ...,
          project: Optional[str] = ...) -> None:
    """Starts Java in this process."""


def connect(port: int = ..., token: Optional[str] = ...) -> None:
    """Connects to the SEAR of a running MyRobotLab on this machine, after its startPython3()."""


def sweep(function: Any, grid: Any = ..., seeds: Any = ..., **options: Any) -> List[Dict[str, Any]]:
    """Calls a function once for each seed and each combination of values, on many processes or computers."""


def close() -> None:
    """Stops what this program has started."""


class JavaObject:
    def __getattr__(self, name: str) -> Any: ...


class Record:
    """A record of a run: record.names, record["rover.x"] as an array over record.times, and plots."""
    path: str
    names: List[str]
    times: np.ndarray
    def __init__(self, path: Any) -> None: ...
    def __getitem__(self, name: str) -> np.ndarray: ...
    def plot(self, *names: str) -> Any:
        """Returns a plot of these values over time, with one box per unit. Default: a speed and a sensor."""
    def save(self, picture: Any, *names: str) -> str:
        """Saves the plot as a file, whose name ends in .png or .svg."""


class _Python:
    failed: bool
    def getName(self) -> str: ...
    def __getattr__(self, name: str) -> Any: ...


python: _Python


class Runtime:
    @overload
    @staticmethod
    def start(name: str, type: Literal["SEAR"]) -> "_SEAR": ...
    @overload
    @staticmethod
    def start(name: str, type: Literal["LIDAR"]) -> "_LIDAR": ...
    @overload
    @staticmethod
    def start(name: str, type: Literal["GPS"]) -> "_GPS": ...
    @overload
    @staticmethod
    def start(name: str, type: str) -> Any: ...
    @staticmethod
    def getService(name: str) -> Any: ...
    @staticmethod
    def release(name: str) -> Any: ...
