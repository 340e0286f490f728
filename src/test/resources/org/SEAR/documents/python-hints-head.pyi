"""What editors and type checkers know of the package. WRITTEN"""
from typing import Any, Dict, List, Literal, Optional, Sequence, overload

import numpy as np

__all__: List[str]


class JavaError(Exception): ...
class IllegalArgumentException(JavaError, ValueError): ...
class IllegalStateException(JavaError, RuntimeError): ...
class IOException(JavaError, OSError): ...
class UnsupportedOperationException(JavaError, NotImplementedError): ...
class NullPointerException(JavaError, TypeError): ...


def start(*options: str, headless: Optional[bool] = ..., speed: Any = ..., seed: Optional[int] = ..., threads: Optional[int] = ...) -> None:
    """Starts Java in this process."""


def connect(port: int = ..., token: Optional[str] = ...) -> None:
    """Uses the SEAR of a running MyRobotLab of this machine that was asked to startPython3()."""


def sweep(function: Any, grid: Any = ..., seeds: Any = ..., **options: Any) -> List[Dict[str, Any]]:
    """Calls a function once for each seed and each combination of values, on many processes or computers."""


def close() -> None:
    """Stops what this program has started."""


class JavaObject:
    def __getattr__(self, name: str) -> Any: ...


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
