"""VTK's errors as exceptions."""

from __future__ import annotations

import re
from typing import Any

from vtkmodules.vtkCommonCore import VTK_STRING, vtkObject

__all__ = ["Error", "update", "watch"]

_SOURCE = re.compile(r"^(?:ERROR|Warning): In .*?, line \d+\n\w+ \(0x[0-9a-f]+\): ", re.DOTALL)


class Error(RuntimeError):
    """What a file or a value is at fault for, in one sentence."""


class watch:
    """Hears the errors of VTK objects instead of letting them go to the console.

    with watch(reader, filter) as errors:
        filter.Update()
    # raises the first error, if there was one
    """

    def __init__(self, *objects: vtkObject) -> None:
        self._objects = [o for one in objects for o in (one, _executive(one)) if o is not None]
        self._tags: list[tuple[vtkObject, int]] = []
        self.messages: list[str] = []

    def __enter__(self) -> "watch":
        def hear(_object: vtkObject, _event: str, message: str) -> None:
            self.messages.append(_SOURCE.sub("", message).strip())

        hear.CallDataType = VTK_STRING  # type: ignore[attr-defined]
        self._tags = [(o, o.AddObserver("ErrorEvent", hear)) for o in self._objects]
        return self

    def __exit__(self, kind: Any, _value: Any, _trace: Any) -> None:
        for watched, tag in self._tags:
            watched.RemoveObserver(tag)
        if kind is None and self.messages:
            raise Error(self.messages[0])


def _executive(one: vtkObject) -> vtkObject | None:
    return one.GetExecutive() if hasattr(one, "GetExecutive") else None


def upstream(algorithm: Any) -> list[Any]:
    """The algorithm and all that it takes its data from, the first of a pipeline first."""
    found: list[Any] = []

    def visit(one: Any) -> None:
        for port in range(one.GetNumberOfInputPorts()):
            for i in range(one.GetNumberOfInputConnections(port)):
                producer = one.GetInputConnection(port, i).GetProducer()
                if producer not in found:
                    visit(producer)
        found.append(one)

    visit(algorithm)
    return found


def update(algorithm: Any, time: float | None = None) -> Any:
    """Brings a filter and its pipeline up to date, at a time (s) if one is given.

    Returns the filter. Raises Error with the first message of the pipeline.
    """
    with watch(*upstream(algorithm)):
        if time is None:
            algorithm.Update()
        else:
            algorithm.UpdateTimeStep(time)
    return algorithm
