"""Faces made of PDE surface patches, their animation and deformation, for Python.

    import mien
    joy = mien.Face().animate("joy")
    points = joy.surface().points          # numpy, (n, 3), mm

`Face` is what most scripts need. Every VTK class of Mien is here too, under its own name (mien.vtkPDEFaceFilter ..),
for pipelines of one's own; `mien.update(filter)` brings one up to date and raises an Error with its message.
"""

from .MienSurface import *
from .MienDeformation import *
from .MienAnimation import *
from .MienTexture import *
from .MienAcquisition import *
from .errors import Error, update
from .face import Face
from .surface import Surface, surface_of
from .tables import Table, compare, fit_table, table_of

__version__ = "@PROJECT_VERSION@"
