"""What the tests compare with: the command line, and files read by VTK alone."""

import json
import os
import subprocess
import tempfile

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLStructuredGridReader

DATA = os.environ["MIEN_DATA"]


def mien(*arguments):
    """What a command of mien prints as JSON."""
    run = subprocess.run([os.environ["MIEN"], *arguments, "--json"], capture_output=True, text=True, check=True)
    return json.loads(run.stdout)


def written(command, ending, *arguments):
    """The data set that a command writes."""
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "out" + ending)
        subprocess.run([os.environ["MIEN"], command, *arguments, "-o", file], capture_output=True, check=True)
        reader = vtkXMLStructuredGridReader() if ending == ".vts" else vtkXMLPolyDataReader()
        reader.SetFileName(file)
        reader.Update()
        return reader.GetOutput()


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def array_of(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name))
