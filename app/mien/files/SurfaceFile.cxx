#include "SurfaceFile.h"

#include "Failure.h"
#include "NumberText.h"
#include "OutputFile.h"
#include "PipelineErrors.h"
#include "WholeFile.h"
#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkOBJWriter.h"
#include "vtkOrderedGeometryFilter.h"
#include "vtkPLYWriter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkSTLWriter.h"
#include "vtkStructuredGrid.h"
#include "vtkTriangleFilter.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtkXMLStructuredGridWriter.h"

namespace mien {

vtkSmartPointer<vtkPolyData> outwardPolygons(vtkStructuredGrid* grid, bool triangles) {
  vtkNew<vtkOrderedGeometryFilter> polygons;
  polygons->SetInputData(grid);
  vtkNew<vtkReverseSense> outwards;  // the normals point outwards already
  outwards->SetInputConnection(polygons->GetOutputPort());
  vtkNew<vtkTriangleFilter> halves;
  halves->SetInputConnection(outwards->GetOutputPort());
  vtkAlgorithm* last = triangles ? static_cast<vtkAlgorithm*>(halves) : outwards;
  last->Update();
  return vtkPolyData::SafeDownCast(last->GetOutputDataObject(0));
}

namespace {

template <class Writer>
void write(Writer* writer, vtkDataObject* data, const std::string& name) {
  OutputFile file(name);
  PipelineErrors errors;
  errors.observe(writer);
  writer->SetFileName(file.temporaryName().c_str());
  writer->SetInputDataObject(data);
  if (!writer->Write() || !errors.first().empty()) throw FileFailure(name + ": " + WholeFile::unwritable);
  file.commit();
}

/// Raw LZ4 is several times quicker to write than the default and hardly larger.
template <class Writer>
void writeXML(vtkDataObject* data, const std::string& name) {
  vtkNew<Writer> writer;
  writer->SetCompressorTypeToLZ4();
  writer->EncodeAppendedDataOff();
  write(writer.Get(), data, name);
}

void writePLY(vtkPolyData* polygons, const std::string& name) {
  vtkNew<vtkPLYWriter> writer;
  writer->SetFileTypeToBinary();
  for (const char* colours : {"RGBA", "RGB"})
    if (polygons->GetPointData()->HasArray(colours)) {
      writer->SetArrayName(colours);
      writer->SetEnableAlpha(std::string(colours) == "RGBA");
    }
  write(writer.Get(), polygons, name);
}

void writeOBJ(vtkPolyData* polygons, const std::string& name) {
  vtkNew<vtkOBJWriter> writer;
  write(writer.Get(), polygons, name);
}

void writeSTL(vtkPolyData* triangles, const std::string& name) {
  vtkNew<vtkSTLWriter> writer;
  writer->SetFileTypeToBinary();
  write(writer.Get(), triangles, name);
}

vtkSmartPointer<vtkPolyData> trianglesOf(vtkPolyData* polygons) {
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(polygons);
  triangles->Update();
  return triangles->GetOutput();
}

/// Points, then the corners of each polygon.
void writeOFF(vtkPolyData* polygons, const std::string& name) {
  vtkCellArray* cells = polygons->GetPolys();
  std::string text = "OFF\n" + std::to_string(polygons->GetNumberOfPoints()) + " " +
                     std::to_string(cells->GetNumberOfCells()) + " 0\n";
  for (vtkIdType i = 0; i < polygons->GetNumberOfPoints(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      appendNumber(text, polygons->GetPoint(i)[axis]);
      text += axis < 2 ? ' ' : '\n';
    }
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell) {
    cells->GetCellAtId(cell, corners);
    text += std::to_string(corners->GetNumberOfIds());
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k) text += " " + std::to_string(corners->GetId(k));
    text += "\n";
  }
  OutputFile::write(name, text);
}

void writePolygons(vtkPolyData* polygons, const std::string& ending, const std::string& name) {
  if (ending == "vtp") writeXML<vtkXMLPolyDataWriter>(polygons, name);
  if (ending == "ply") writePLY(polygons, name);
  if (ending == "obj") writeOBJ(polygons, name);
  if (ending == "off") writeOFF(polygons, name);
  if (ending == "stl") writeSTL(trianglesOf(polygons), name);
}

}  // namespace

const std::vector<std::string>& surfaceEndings() {
  static const std::vector<std::string> endings = {"vts", "vtp", "ply", "obj", "stl", "off"};
  return endings;
}

void writeSurface(vtkStructuredGrid* grid, const std::string& name) {
  requireEnding(name, surfaceEndings());
  const std::string ending = fileEnding(name);
  if (ending == "vts")
    writeXML<vtkXMLStructuredGridWriter>(grid, name);
  else
    writePolygons(outwardPolygons(grid, ending == "stl"), ending, name);
}

std::string gridBytes(vtkStructuredGrid* grid) {
  vtkNew<vtkXMLStructuredGridWriter> writer;
  writer->SetCompressorTypeToNone();
  writer->EncodeAppendedDataOff();
  writer->SetHeaderTypeToUInt32();
  writer->WriteToOutputStringOn();
  writer->SetInputData(grid);
  writer->Write();
  return writer->GetOutputString();
}

void writeMesh(vtkPointSet* mesh, const std::string& name) {
  if (auto* grid = vtkStructuredGrid::SafeDownCast(mesh)) return writeSurface(grid, name);
  requireEnding(name, {"vtp", "ply", "obj", "stl", "off"});
  writePolygons(vtkPolyData::SafeDownCast(mesh), fileEnding(name), name);
}

}  // namespace mien
