"""Surfaces as numpy arrays."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

__all__ = ["Surface", "surface_of", "arrays_of"]


@dataclass(repr=False)
class Surface:
    """A surface of polygons. The arrays are views of VTK's own memory wherever that is possible."""

    points: np.ndarray  #: (n, 3), mm
    polygons: list[np.ndarray]  #: point numbers of each polygon, wound outwards
    point_data: dict[str, np.ndarray] = field(default_factory=dict)  #: "Normals" (n, 3), "TextureCoordinates" (n, 2) ..
    cell_data: dict[str, np.ndarray] = field(default_factory=dict)  #: "PatchId" ..
    data: Any = None  #: the vtkPolyData itself

    def __repr__(self) -> str:
        arrays = ", ".join([*self.point_data, *self.cell_data]) or "no arrays"
        return "<Surface: %d points, %d polygons; %s>" % (len(self.points), len(self.polygons), arrays)

    @property
    def normals(self) -> np.ndarray:
        """(n, 3), outwards."""
        return self.point_data["Normals"]

    @property
    def quads(self) -> np.ndarray:
        """The polygons as one array (m, 4); an error where they are of several kinds."""
        return np.array(self.polygons)


def arrays_of(attributes: Any) -> dict[str, np.ndarray]:
    """The arrays of point, cell or field data that have a name and hold numbers."""
    arrays = {}
    for i in range(attributes.GetNumberOfArrays()):
        array = attributes.GetArray(i)
        if array is not None and array.GetName():
            arrays[array.GetName()] = vtk_to_numpy(array)
    return arrays


def surface_of(data: Any) -> Surface:
    """A vtkPolyData as a Surface."""
    polygons = data.GetPolys()
    ids = vtk_to_numpy(polygons.GetConnectivityArray())
    offsets = vtk_to_numpy(polygons.GetOffsetsArray())
    return Surface(
        points=vtk_to_numpy(data.GetPoints().GetData()),
        polygons=np.split(ids, offsets[1:-1]) if len(offsets) > 1 else [],
        point_data=arrays_of(data.GetPointData()),
        cell_data=arrays_of(data.GetCellData()),
        data=data,
    )
