#pragma once

#include <functional>
#include <string>

#include "BoundaryCurveData.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataWriter.h"

/// Writes boundary curves as they are, sound or not.
inline void writeFaceFile(const mien::FaceCurves& face, const std::string& name) {
  vtkNew<vtkPolyData> data;
  mien::writeFaceCurves(face, data);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(name.c_str());
  writer->SetInputData(data);
  writer->Write();
}

inline mien::FaceCurves genericFace() {
  vtkNew<vtkBoundaryCurveReader> reader;
  reader->Update();
  mien::FaceCurves face;
  mien::readFaceCurves(reader->GetOutput(), face);
  return face;
}

/// The generic face with a change, sound or not, as a file.
inline void writeChangedFace(const std::function<void(mien::FaceCurves&)>& change, const std::string& name) {
  mien::FaceCurves face = genericFace();
  change(face);
  writeFaceFile(face, name);
}
