"""Measures every kind of pipeline of the plugin in parallel and writes what was found, for compare_runs.py.

usage: mpirun -np N pvbatch --sym measure_faces.py PLUGIN.so ANIMATION.fap RESULT.json
"""
import json
import math
import sys

import numpy
from paraview import simple
from paraview.vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkStructuredGrid, vtkTable
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

controller = vtkMultiProcessController.GetGlobalController()
rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()


def gathered(numbers):
    """The numbers of every rank, one row each."""
    mine, all_of_them = vtkDoubleArray(), vtkDoubleArray()
    for number in numbers:
        mine.InsertNextValue(number)
    if ranks == 1:
        return numpy.array([numbers])
    controller.AllGather(mine, all_of_them)
    return vtk_to_numpy(all_of_them).reshape(ranks, len(numbers)).copy()


def part_of(proxy, port, time):
    """What this rank has of an output."""
    proxy.UpdatePipeline(time) if time is not None else proxy.UpdatePipeline()
    return proxy.GetClientSideObject().GetOutputDataObject(port)


def grid_numbers(grid):
    """Cells, area (mm^2), sums of the cells' corners and of their normals."""
    size = [0, 0, 0]
    grid.GetDimensions(size)
    points = vtk_to_numpy(grid.GetPoints().GetData()).reshape(size[1], size[0], 3)
    normals = vtk_to_numpy(grid.GetPointData().GetNormals()).reshape(size[1], size[0], 3)
    corners = [points[:-1, :-1], points[:-1, 1:], points[1:, 1:], points[1:, :-1]]
    diagonals = numpy.cross(corners[2] - corners[0], corners[3] - corners[1])
    visible = numpy.ones(grid.GetNumberOfCells())
    if grid.GetCellGhostArray():
        visible = vtk_to_numpy(grid.GetCellGhostArray()) == 0
    area = 0.5 * numpy.linalg.norm(diagonals, axis=2).ravel() @ visible
    middles = sum(corners).reshape(-1, 3).sum(axis=0)
    directions = normals[:-1, :-1].reshape(-1, 3).sum(axis=0)
    return [grid.GetNumberOfCells(), visible.sum(), area, *middles, *directions]


def array_sums(attributes, ids=slice(None)):
    sums = []
    for index in range(attributes.GetNumberOfArrays()):
        array = attributes.GetArray(index)
        if array:
            sums.append(float(numpy.nansum(vtk_to_numpy(array).astype(float)[ids])))
    return sums


def numbers_of(data):
    if isinstance(data, vtkStructuredGrid):
        return grid_numbers(data) if data.GetNumberOfCells() else [0.0] * 9
    if isinstance(data, vtkTable):
        return [data.GetNumberOfRows()] + array_sums(data.GetRowData())
    if data.GetNumberOfPoints() == 0:
        return [0.0]
    ids = slice(None)
    if data.GetNumberOfVerts():  # points that parts share have one vertex
        ids = vtk_to_numpy(data.GetVerts().GetConnectivityArray())
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)[ids].sum(axis=0)
    return [data.GetNumberOfCells(), *points] + array_sums(data.GetPointData(), ids)


def extent_of(data):
    return list(data.GetExtent()) if isinstance(data, vtkStructuredGrid) else []


class Results:
    """Totals over the ranks and the cells of each, output by output."""

    def __init__(self):
        self.outputs = {}

    def measure(self, name, proxy, port=0, time=None):
        data = part_of(proxy, port, time)
        numbers = numbers_of(data)
        longest = int(gathered([len(numbers)]).max())
        rows = gathered(numbers + [0.0] * (longest - len(numbers)))
        extents = gathered([float(x) for x in extent_of(data) or [0] * 6])
        self.outputs[name] = {
            "totals": [math.fsum(column) for column in rows.T],
            "parts": [row[0] for row in rows.tolist()],
            "extents": extents.tolist() if extent_of(data) else [],
        }


def surface(curves, **properties):
    return simple.MienPDEFace(Input=curves, OutputPointsPrecision="Double", **properties)


def measure_surfaces(results, curves):
    for scheme in ["spline", "four-curve", "derivative", "sixth-order", "tangent", "curvature"]:
        results.measure("face " + scheme, surface(curves, Scheme=scheme))
    fine = surface(curves, Resolution=[700, 500], Smoothing=2.0, GenerateCurvatures=1)
    results.measure("fine face", fine)
    modes = simple.MienPDEModes(Input=curves, Mode=2, OutputPointsPrecision="Double")
    results.measure("mode 2", modes)
    results.measure("spectrum", modes, 1)
    influence = simple.MienPDEInfluence(Input=curves, Curve="C22'", OutputPointsPrecision="Double")
    results.measure("influence", influence)
    results.measure("influence profile", influence, 1)
    seams = simple.MienPatchContinuity(Input=curves)
    results.measure("seams", seams)
    results.measure("seam summary", seams, 1)
    sweep = simple.MienPDEParameterSweep(Input=curves, Schemes=["spline", "four-curve"], SmoothingRange="0.5,1,2")
    results.measure("sweep", sweep)


def measure_motion(results, curves, animation):
    frames = simple.MienFAPReader(FileName=animation)
    animated = simple.MienFAPAnimation(Input=curves, FAPs=frames)
    face = surface(animated)
    face.UpdatePipelineInformation()
    times = list(frames.TimestepValues)
    results.outputs["times"] = {"totals": [len(times), times[0], times[-1]], "parts": [], "extents": []}
    results.measure("animated curves", animated, time=times[60])
    for index in (0, 60, 150):
        results.measure("frame %d" % index, face, time=times[index])
    joy = surface(simple.MienFAPAnimation(Input=curves, Joy=1.0, FAPValues=["3", "200"]))
    neutral = surface(curves)
    results.measure("joy", joy)
    results.measure("vectors", simple.MienMotionVectors(Input=joy, Neutral=neutral))
    distance = simple.MienSurfaceDistance(Input=joy, Reference=neutral)
    for port, name in enumerate(["distance", "distance back", "distance summary"]):
        results.measure(name, distance, port)
    return joy, neutral


def measure_tables(results, curves, joy, neutral):
    smile = simple.MienFacialDeformationTable(Table="smile")
    results.measure("deformed face", simple.MienFDTDeformation(Input=neutral, Table=smile))
    results.measure("deformed curves", simple.MienFDTCurves(Input=curves, Table=smile))
    results.measure("regions", simple.MienFacialRegions(Input=neutral))
    fit = simple.MienFDTFit(Input=neutral, Expression=joy, AllowEmptyRegions=1)
    results.measure("fitted table", fit)
    edited = simple.MienCurveEdit(Input=curves, Edits=["C10", "3.0", "0", "0", "1", "30", "2", "0"])
    results.measure("edited face", surface(edited))
    mean = simple.MienBoundaryCurveMean(Input=[curves, edited])
    results.measure("mean curves", mean)


def main(plugin, animation, result):
    simple.LoadPlugin(plugin, remote=False, ns=simple.__dict__)
    curves = simple.MienGenericFace()
    results = Results()
    results.measure("curves", curves)
    measure_surfaces(results, curves)
    measure_tables(results, curves, *measure_motion(results, curves, animation))
    if rank == 0:
        with open(result, "w", encoding="utf-8") as file:
            json.dump(results.outputs, file, indent=1)


main(*sys.argv[1:])
