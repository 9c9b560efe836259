#include "FacePipeline.h"

#include "FaceLayout.h"
#include "PipelineErrors.h"

#include "vtkBoundaryCurveReader.h"
#include "vtkGeometryFilter.h"
#include "vtkNew.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPolyData.h"

namespace mien {

struct FacePipeline::Internals
{
  FaceState state;
  vtkNew<vtkBoundaryCurveReader> reader;
  vtkNew<vtkPDEFaceFilter> face;
  vtkNew<vtkGeometryFilter> surface;
  PipelineErrors errors;

  Internals()
  {
    face->SetInputConnection(reader->GetOutputPort());
    surface->SetInputConnection(face->GetOutputPort());
    for (vtkAlgorithm* algorithm : { static_cast<vtkAlgorithm*>(reader), static_cast<vtkAlgorithm*>(face),
           static_cast<vtkAlgorithm*>(surface) })
      errors.observe(algorithm);
  }

  void setSurface(const FaceSurfaceOptions& options)
  {
    face->SetScheme(options.scheme);
    for (int patch = 0; patch < FaceLayout::patchCount; ++patch)
      face->SetSmoothing(patch, options.smoothing[patch]);
    face->SetNumberOfModes(options.modes);
    face->SetRemainder(options.remainder);
    face->SetDerivativeStrength(options.derivativeStrength);
  }

  void setGrid()
  {
    face->SetResolution(state.rows, state.columns);
    face->SetUniformRows(state.uniformRows);
    face->SetOutputPointsPrecision(state.doublePrecision ? vtkAlgorithm::DOUBLE_PRECISION : vtkAlgorithm::SINGLE_PRECISION);
  }

  /// After a failure VTK does not run a filter again until it is modified.
  std::string update(vtkAlgorithm* algorithm)
  {
    errors.clear();
    algorithm->Update();
    const std::string fault = errors.first();
    if (!fault.empty())
      reader->Modified();
    return fault;
  }
};

FacePipeline::FacePipeline()
  : Impl(new Internals)
{
  this->setState({});
}

FacePipeline::~FacePipeline() = default;

void FacePipeline::setState(const FaceState& state)
{
  this->Impl->state = state;
  this->Impl->reader->SetFileName(state.curvesFile.empty() ? nullptr : state.curvesFile.c_str());
  this->Impl->setSurface(state.surface);
  this->Impl->setGrid();
}

const FaceState& FacePipeline::state() const
{
  return this->Impl->state;
}

vtkBoundaryCurveReader* FacePipeline::neutralCurves() const
{
  return this->Impl->reader;
}

vtkAlgorithm* FacePipeline::curves() const
{
  return this->Impl->reader;
}

vtkPDEFaceFilter* FacePipeline::face() const
{
  return this->Impl->face;
}

vtkAlgorithm* FacePipeline::surface() const
{
  return this->Impl->surface;
}

std::string FacePipeline::updateNeutralCurves()
{
  return this->Impl->update(this->Impl->reader);
}

int FacePipeline::pointsPerCurve() const
{
  vtkPolyData* curves = this->Impl->reader->GetOutput();
  return static_cast<int>(curves->GetNumberOfPoints() / FaceLayout::curveCount);
}

std::string FacePipeline::update()
{
  return this->Impl->update(this->Impl->surface);
}

} // namespace mien
