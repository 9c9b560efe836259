"""Tables, and the measures that give them."""

from __future__ import annotations

from typing import Any, Iterator

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from . import MienDeformation, MienSurface
from .errors import update

__all__ = ["Table", "table_of", "compare", "fit_table"]


class Table(dict[str, np.ndarray]):
    """Columns by name, all of one length."""

    @property
    def row_count(self) -> int:
        return len(next(iter(self.values()), ()))

    def __repr__(self) -> str:
        return "<Table: %d rows; %s>" % (self.row_count, ", ".join(self))

    def rows(self) -> Iterator[dict[str, Any]]:
        """Row by row, as dictionaries."""
        for values in zip(*self.values()):
            yield dict(zip(self.keys(), values))


def _column(array: Any) -> np.ndarray:
    if array.IsNumeric():
        return vtk_to_numpy(array)
    return np.array([array.GetValue(i) for i in range(array.GetNumberOfValues())])


def table_of(data: Any) -> Table:
    """A vtkTable as a Table."""
    columns = (data.GetColumn(i) for i in range(data.GetNumberOfColumns()))
    return Table((column.GetName(), _column(column)) for column in columns)


def _data(surface: Any) -> Any:
    return getattr(surface, "data", surface)


def compare(surface: Any, reference: Any, *, frontal: bool = False) -> Table:
    """How far two surfaces lie apart, mm, one row each way: rms_mm, mean_mm, median_mm, p95_mm, max_mm ..

    Surfaces are those of `Face.surface()` or VTK's. `frontal`: points at z > 50 mm only.
    """
    measure = MienSurface.vtkSurfaceDistanceFilter()
    measure.SetInputData(_data(surface))
    measure.SetReferenceData(_data(reference))
    measure.SetFrontalOnly(frontal)
    return table_of(update(measure).GetOutputDataObject(2))


def fit_table(neutral: Any, expression: Any, *, pupils: Any = None) -> Table:
    """The facial deformation table of 16 rows that takes one surface to the other, which has as many points.

    `pupils`: left and right, (2, 3), mm, of both; without it they are looked for in the surfaces.
    """
    fit = MienDeformation.vtkFDTFitFilter()
    fit.SetInputData(_data(neutral))
    fit.SetExpressionData(_data(expression))
    if pupils is not None:
        left, right = np.asarray(pupils, float)
        for set_left, set_right in ((fit.SetLeftPupil, fit.SetRightPupil),
                                    (fit.SetOtherLeftPupil, fit.SetOtherRightPupil)):
            set_left(*left)
            set_right(*right)
    return table_of(update(fit).GetOutput())
