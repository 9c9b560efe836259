#pragma once

#include <string>
#include <vector>

#include "TriangleMesh.h"
#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkInformation;
class vtkInformationVector;
class vtkPolyData;

namespace mien {

/// Asks an input for all of its data, whatever part of an output is wanted; an input that is not there is none.
void requestWhole(vtkInformation* input);

/// The output that is asked for: VTK takes all outputs of an update as the piece that this one wants.
vtkInformation* askedOutput(vtkInformation* request, vtkInformationVector* outputs);

/// Whether another piece than the first is asked for, of data that are all in the first.
bool isLaterPiece(vtkInformation* request, vtkInformationVector* outputs);

/// Announces a structured grid of rows x columns, the closing column added, of which any part can be asked for.
void offerGrid(vtkInformation* output, int rows, int columns);

/// The visible cells of a structured grid, or a polydata as it is; nothing from anything else.
vtkSmartPointer<vtkPolyData> visibleSurface(vtkDataObject* data);

/// The part of a surface with the most cells among those that share no point; all points stay.
vtkSmartPointer<vtkPolyData> largestComponent(vtkPolyData* surface);

/// Polygons and strips as triangles over the same points, wound like the point normals where the surface has them.
vtkSmartPointer<vtkPolyData> trianglesOf(vtkPolyData* surface);

/// One sentence that says which cell uses a point that is not there or which array does not fit, or nothing. VTK's own
/// filters take a mesh's word for it, so this is asked before anything else walks a mesh from a file.
std::string describeMeshFault(vtkPolyData* mesh, const std::string& name);

/// A surface as it is shown and the triangles that measure it.
struct SurfaceMesh {
  vtkSmartPointer<vtkPolyData> surface, triangles;
};

/// Checks a mesh and takes it apart; nothing, or one sentence that says why `data` are no surface.
/// @param largestOnly  of a mesh in parts only the largest
std::string readSurface(vtkDataObject* data, const std::string& name, bool largestOnly, SurfaceMesh& mesh);

/// One sentence that says why triangles can be no surface (none, points that are not finite, no area), or nothing.
std::string describeFault(vtkPolyData* triangles, const std::string& name);

/// Points and triangles as they are (trianglesOf()).
TriangleMesh meshOf(vtkPolyData* triangles);

/// Area that belongs to each point: a third of every triangle around it (mm2).
std::vector<double> pointAreas(vtkPolyData* triangles);

}  // namespace mien
