"""A face by its state."""

from __future__ import annotations

import copy
import json
import os
from typing import Any, Iterable, Mapping, Sequence

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from . import MienAnimation, MienSurface
from .errors import Error, update, watch
from .surface import Surface, surface_of
from .tables import Table, table_of

__all__ = ["Face"]


class Face:
    """A face, described by a FaceState: never changed, every method gives a new one or numbers.

    Lengths in mm, FAPs in FAP units, intensities 0 .. 1. What cannot be shown raises Error with one sentence: which file
    or value, and what is allowed.
    """

    def __init__(self, curves: str | os.PathLike[str] | None = None, *, state: str | Mapping[str, Any] | None = None,
                 **surface: Any) -> None:
        """The generic face, or the face of boundary curves (.vtp or .mienz), or a state as JSON or a dictionary.

        Further keywords are those of `replace`.
        """
        self._source = MienAnimation.vtkFaceStateSource()
        with watch(self._source):
            if state is not None:
                self._source.SetState(state if isinstance(state, str) else _text(state, self._source))
        self._state: dict[str, Any] = json.loads(self._source.GetState())
        if curves is not None:
            surface["curves"] = os.fspath(curves)
        if surface:
            self._set(_replaced(self._state, surface))

    @classmethod
    def load(cls, file: str | os.PathLike[str]) -> "Face":
        """The face of a file with a FaceState (.json)."""
        with open(file, encoding="utf-8") as text:
            try:
                return cls(state=text.read())
            except Error as fault:
                raise Error(f"{os.fspath(file)}: {fault}") from None

    def _set(self, state: dict[str, Any]) -> None:
        with watch(self._source):
            self._source.SetState(json.dumps(state))
        self._state = json.loads(self._source.GetState())

    def _with(self, state: dict[str, Any]) -> "Face":
        return Face(state=state)

    @property
    def state(self) -> dict[str, Any]:
        """The FaceState, a copy: what `Face(state=..)` and `mien .. --state` take."""
        return copy.deepcopy(self._state)

    @property
    def source(self) -> Any:
        """The vtkFaceStateSource, for a pipeline of one's own: grid, surface and curves at ports 0, 1 and 2."""
        return self._source

    def replace(self, **properties: Any) -> "Face":
        """The face with other properties: curves, scheme, a (one or nine), harmonics (N), remainder,
        derivative_strength, resolution (rows, columns), uniform_rows, precision ("single", "double")."""
        return self._with(_replaced(self._state, properties))

    def animate(self, *expressions: str, faps: Mapping[int, float] | None = None, fap: str | None = None,
                frame: float | None = None, index: int | None = None, time: float | None = None,
                interpolate: bool = False, **intensities: float) -> "Face":
        """The face moved: animate("joy"), animate(joy=0.6, surprise=0.4), animate(faps={53: 200, 54: 200}),
        animate(fap="talk.fap", frame=12). A file's frame is chosen by its number, its index from 0, or its time (s)."""
        state = self.state
        _merge(state, "expressions", {**dict.fromkeys(expressions, 1.0), **intensities})
        _merge(state, "fap_values", {str(number): value for number, value in (faps or {}).items()})
        if fap is not None:
            chosen = {"frame": frame, "index": index, "time": time}
            given = {name: value for name, value in chosen.items() if value is not None}
            if len(given) > 1:
                raise Error(f"a frame is chosen by one of {', '.join(chosen)}, not by {' and '.join(given)}")
            state["animation"] = {"file": os.fspath(fap), "interpolate": interpolate, **(given or {"index": 0})}
        elif (frame, index, time) != (None, None, None):
            raise Error("a frame, index or time needs a file; give it as fap")
        return self._with(state)

    def deform(self, table: str | os.PathLike[str], strength: float = 1.0, *, smooth: bool = True) -> "Face":
        """The face bent by a facial deformation table: the name of one compiled in, or a .csv or .fdt file."""
        state = self.state
        state["deformation"] = {"table": os.fspath(table), "strength": strength, "smooth": smooth}
        return self._with(state)

    def neutral(self) -> "Face":
        """The same face at rest."""
        moving = ("animation", "fap_values", "expressions", "visemes", "deformation")
        return self._with({name: value for name, value in self._state.items() if name not in moving})

    @property
    def times(self) -> np.ndarray:
        """The times (s) of the frames of the animation file; empty without one."""
        from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as pipeline

        with watch(self._source):
            self._source.UpdateInformation()
        return np.array(self._source.GetOutputInformation(0).Get(pipeline.TIME_STEPS()) or ())

    def frames(self) -> Iterable["Face"]:
        """The face at every frame of its animation file."""
        state = self.state
        for i in range(len(self.times)):
            state["animation"] = {"file": state["animation"]["file"], "index": i}
            yield self._with(state)

    def surface(self) -> Surface:
        """The surface: points, polygons, normals and the other arrays."""
        return surface_of(update(self._source).GetSurface())

    def grid(self) -> Any:
        """The vtkStructuredGrid of the surface, rows x (columns + 1) points, the mouth's slit blanked."""
        return update(self._source).GetOutput()

    def curves(self) -> dict[str, np.ndarray]:
        """The 29 boundary curves by name (C1 .. C28, C22'), each (K, 3)."""
        data = update(self._source).GetCurves()
        points = vtk_to_numpy(data.GetPoints().GetData())
        names = data.GetCellData().GetAbstractArray("CurveName")
        count = names.GetNumberOfValues()
        return {names.GetValue(i): part for i, part in enumerate(np.split(points, count))}

    def motion(self, origin: "Face | None" = None, *, remove_head_motion: bool = False) -> Surface:
        """How the surface moves from `origin`, by default the same face at rest: a Surface of origin's points with
        "MotionVector" (n, 3) and "Magnitude" (n) among its point data, mm."""
        vectors = MienAnimation.vtkMotionVectorFilter()
        vectors.SetInputData(self.grid())
        rest = origin or self.neutral()
        vectors.SetNeutralData(rest.grid())
        vectors.SetRemoveRigidMotion(remove_head_motion)
        return surface_of(update(vectors).GetOutput())

    def _measure(self, measure: Any) -> Any:
        """Gives a measuring filter the animated curves and the parameters of this face."""
        curves = update(self._source).GetCurves()
        measure.SetInputData(curves)
        surface = self._state["surface"]
        measure.SetScheme(surface["scheme"])
        for patch, a in enumerate(surface["a"]):
            measure.SetSmoothing(patch, a)
        measure.SetNumberOfModes(surface["harmonics"])
        measure.SetRemainder(surface["remainder"])
        measure.SetDerivativeStrength(surface["derivative_strength"])
        return measure

    def spectrum(self) -> Table:
        """What each Fourier mode adds, one row each: mode, rms_mm, max_mm, energy_share, cumulative_rms_error_mm."""
        measure = self._measure(MienSurface.vtkPDEModeFilter())
        grid = self._state["grid"]
        measure.SetResolution(grid["rows"], grid["columns"])
        measure.SetUniformRows(grid["uniform_rows"])
        return table_of(update(measure).GetSpectrum())

    def continuity(self, samples: int = 400) -> Table:
        """How the patches meet, one row for each seam: G0, G1, C1, G2, C2 as means and largest values."""
        measure = self._measure(MienSurface.vtkPatchContinuityFilter())
        measure.SetNumberOfSamples(samples)
        return table_of(update(measure).GetSummary())

    def sweep(self, a: str | Sequence[float] = "0.1:10:21log", schemes: Sequence[str] = ()) -> Table:
        """Measures of the surface over the smoothing parameter, one row for each scheme and a; schemes: ("all",)
        takes all, none this face's own."""
        measure = self._measure(MienSurface.vtkPDEParameterSweep())
        with watch(measure):
            if isinstance(a, str):
                measure.SetSmoothingRange(a)
            else:
                measure.SetSmoothingValues([float(value) for value in a])
            for scheme in schemes:
                measure.AddAllSchemes() if scheme == "all" else measure.AddScheme(scheme)
        return table_of(update(measure).GetOutput())

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Face) and self._state == other._state

    def __hash__(self) -> int:
        return hash(json.dumps(self._state, sort_keys=True))

    def __repr__(self) -> str:
        surface = self._state["surface"]
        name = self._state.get("curves", "generic")
        return f"<mien.Face {name}, scheme {surface['scheme']}, N = {surface['harmonics']}>"


_SURFACE = ("scheme", "a", "harmonics", "remainder", "derivative_strength")
_GRID = ("uniform_rows", "precision")


def _text(state: Mapping[str, Any], source: Any) -> str:
    """As JSON; a dictionary made by hand need not tell the version."""
    version = json.loads(source.GetState())["mien_face_state"]
    return json.dumps({"mien_face_state": version, **state})


def _replaced(state: Mapping[str, Any], properties: Mapping[str, Any]) -> dict[str, Any]:
    changed: dict[str, Any] = copy.deepcopy(dict(state))
    for name, value in properties.items():
        if name == "curves":
            changed["curves"] = os.fspath(value)
        elif name == "a":
            changed["surface"]["a"] = [float(value)] * 9 if np.isscalar(value) else [float(a) for a in value]
        elif name in _SURFACE:
            changed["surface"][name] = value
        elif name == "resolution":
            changed["grid"]["rows"], changed["grid"]["columns"] = (int(count) for count in value)
        elif name in _GRID:
            changed["grid"][name] = value
        else:
            known = ("curves", *_SURFACE, "resolution", *_GRID)
            raise Error(f"a face has no property '{name}'; it has {', '.join(known)}")
    return changed


def _merge(state: dict[str, Any], member: str, values: Mapping[str, Any]) -> None:
    if values:
        state[member] = {**state.get(member, {}), **values}
