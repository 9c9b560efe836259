#include "vtkSurfaceDistanceFilter.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "SurfaceDistance.h"
#include "SurfaceMesh.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLongLongArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

vtkStandardNewMacro(vtkSurfaceDistanceFilter);

namespace {

/// Points between two looks at the abort flag; at most about 0.1 s of work on one core.
constexpr vtkIdType measuredPerSlab = 1 << 14;
constexpr vtkIdType measuredPerTask = 256;
constexpr int portOfTable = 2;
constexpr double everywhere = std::numeric_limits<double>::lowest();

const char* const portNames[] = {"surface", "reference mesh"};
const char* const directionNames[] = {"to reference", "from reference"};

/// One of the two surfaces on its way through the filter.
struct Side : mien::SurfaceMesh {
  std::vector<double> areas, distances;
  std::vector<double> vectors;         ///< three for each point; empty when they are not wanted
  std::vector<unsigned char> covered;  ///< empty when all points count
};

vtkSmartPointer<vtkDoubleArray> column(const char* name) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  return array;
}

void fillTable(const std::array<mien::DistanceSummary, 2>& summaries, vtkTable* table) {
  vtkNew<vtkStringArray> directions;
  directions->SetName("direction");
  vtkNew<vtkLongLongArray> points;
  points->SetName("points");
  const auto rms = column("rms_mm"), mean = column("mean_mm"), median = column("median_mm");
  const auto percentile95 = column("p95_mm"), maximum = column("max_mm"), area = column("area_mm2");
  for (int i = 0; i < 2; ++i) {
    directions->InsertNextValue(directionNames[i]);
    rms->InsertNextValue(summaries[i].rms);
    mean->InsertNextValue(summaries[i].mean);
    median->InsertNextValue(summaries[i].median);
    percentile95->InsertNextValue(summaries[i].percentile95);
    maximum->InsertNextValue(summaries[i].maximum);
    area->InsertNextValue(summaries[i].area);
    points->InsertNextValue(summaries[i].points);
  }
  table->AddColumn(directions);
  for (const auto& array : {rms, mean, median, percentile95, maximum, area}) table->AddColumn(array);
  table->AddColumn(points);
}

void fillOutput(const Side& side, vtkPolyData* output) {
  output->ShallowCopy(side.surface);
  const auto distances = column("Distance");
  distances->SetNumberOfTuples(side.surface->GetNumberOfPoints());
  std::copy(side.distances.begin(), side.distances.end(), distances->GetPointer(0));
  output->GetPointData()->AddArray(distances);
  if (!side.covered.empty()) {
    vtkNew<vtkUnsignedCharArray> covered;
    covered->SetName("Covered");
    covered->SetNumberOfTuples(side.surface->GetNumberOfPoints());
    std::copy(side.covered.begin(), side.covered.end(), covered->GetPointer(0));
    output->GetPointData()->AddArray(covered);
  }
  if (side.vectors.empty()) return;
  const auto vectors = column("DistanceVector");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(side.surface->GetNumberOfPoints());
  std::copy(side.vectors.begin(), side.vectors.end(), vectors->GetPointer(0));
  output->GetPointData()->AddArray(vectors);
}

/// @return nothing, or one sentence that says why the data are no surface
std::string readSide(vtkDataObject* data, int port, bool largestOnly, Side& side) {
  const std::string fault = mien::readSurface(data, portNames[port], largestOnly, side);
  if (fault.empty()) side.areas = mien::pointAreas(side.triangles);
  return fault;
}

mien::DistanceSummary sumUp(const Side& side, double threshold) {
  return mien::summarize(side.distances, side.areas, [&](size_t i) {
    return side.areas[i] > 0.0 && side.triangles->GetPoint(i)[2] > threshold &&
           (side.covered.empty() || side.covered[i] != 0);
  });
}

}  // namespace

struct vtkSurfaceDistanceFilter::Internals {
  std::array<mien::DistanceSummary, 2> summaries;

  /// Distances of one side's points to the other side; false when aborted.
  static bool measure(Side& from, const Side& to, bool withSign, double progress, vtkAlgorithm* self) {
    const mien::SurfaceDistance distance(to.triangles);
    const vtkIdType count = from.triangles->GetNumberOfPoints();
    from.distances.resize(count);
    for (vtkIdType begin = 0; begin < count; begin += measuredPerSlab) {
      if (self->GetAbortExecute()) return false;
      const vtkIdType end = std::min(count, begin + measuredPerSlab);
      vtkSMPTools::For(begin, end, measuredPerTask, [&](vtkIdType first, vtkIdType last) {
        double point[3];
        for (vtkIdType i = first; i < last; ++i) {
          from.triangles->GetPoint(i, point);
          const mien::MeshDistance::Nearest found = distance.nearest(point);
          from.distances[i] = withSign && found.isBehind ? -found.distance : found.distance;
          if (!from.covered.empty()) from.covered[i] = !found.onRim;
          for (int k = 0; k < 3 && !from.vectors.empty(); ++k) from.vectors[3 * i + k] = found.point[k] - point[k];
        }
      });
      self->UpdateProgress(progress + 0.5 * end / count);
    }
    return !self->GetAbortExecute();
  }
};

vtkSurfaceDistanceFilter::vtkSurfaceDistanceFilter() : Impl(new Internals) {
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

vtkSurfaceDistanceFilter::~vtkSurfaceDistanceFilter() = default;

double vtkSurfaceDistanceFilter::GetRMSDistance(int direction) const {
  return this->Impl->summaries[direction != 0].rms;
}

double vtkSurfaceDistanceFilter::GetMeanDistance(int direction) const {
  return this->Impl->summaries[direction != 0].mean;
}

double vtkSurfaceDistanceFilter::GetMaximumDistance(int direction) const {
  return this->Impl->summaries[direction != 0].maximum;
}

double vtkSurfaceDistanceFilter::GetMedianDistance(int direction) const {
  return this->Impl->summaries[direction != 0].median;
}

double vtkSurfaceDistanceFilter::GetPercentile95Distance(int direction) const {
  return this->Impl->summaries[direction != 0].percentile95;
}

const mien::DistanceSummary& vtkSurfaceDistanceFilter::GetSummary(int direction) const {
  return this->Impl->summaries[direction != 0];
}

int vtkSurfaceDistanceFilter::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkStructuredGrid");
  return 1;
}

int vtkSurfaceDistanceFilter::FillOutputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == portOfTable ? "vtkTable" : "vtkPolyData");
  return 1;
}

// Every piece of the output needs both whole inputs: the nearest point can lie anywhere.
int vtkSurfaceDistanceFilter::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs,
                                                  vtkInformationVector*) {
  for (int port = 0; port < 2; ++port) mien::requestWhole(inputs[port]->GetInformationObject(0));
  return 1;
}

int vtkSurfaceDistanceFilter::RequestData(vtkInformation* request, vtkInformationVector** inputs,
                                          vtkInformationVector* outputs) {
  if (mien::isLaterPiece(request, outputs)) return 1;
  this->Impl->summaries = {};
  std::array<Side, 2> sides;
  for (int port = 0; port < 2; ++port) {
    const std::string fault =
        readSide(vtkDataObject::GetData(inputs[port]), port, port == 1 && this->LargestComponentOnly, sides[port]);
    if (!fault.empty()) return this->Refuse(fault);
  }
  std::array<mien::DistanceSummary, 2> summaries;
  for (int port = 0; port < 2; ++port) {
    if (this->GenerateVectors) sides[port].vectors.resize(3 * sides[port].triangles->GetNumberOfPoints());
    if (this->CoveredOnly) sides[port].covered.resize(sides[port].triangles->GetNumberOfPoints());
    if (!Internals::measure(sides[port], sides[1 - port], this->Signed, 0.5 * port, this)) return 1;
    summaries[port] = sumUp(sides[port], this->FrontalOnly ? this->FrontalThreshold : everywhere);
    if (summaries[port].points == 0) return this->RefuseEmptiness(port);
  }
  this->Impl->summaries = summaries;
  for (int port = 0; port < 2; ++port) fillOutput(sides[port], vtkPolyData::GetData(outputs, port));
  fillTable(summaries, vtkTable::GetData(outputs, portOfTable));
  return 1;
}

int vtkSurfaceDistanceFilter::RefuseEmptiness(int port) {
  const std::string place = this->FrontalOnly ? " at z > " + vtkVariant(this->FrontalThreshold).ToString() + " mm" : "";
  if (this->CoveredOnly)
    return this->Refuse("no point of the " + std::string(portNames[port]) + place + " is covered by the " +
                        portNames[1 - port] + "; bring both surfaces into one frame, or compare all points");
  return this->Refuse("no point of the " + std::string(portNames[port]) + " lies" + place +
                      ", where a face in mm that looks along +z has its front; bring both surfaces into such a "
                      "frame, or compare all points");
}

int vtkSurfaceDistanceFilter::Refuse(const std::string& fault) {
  vtkErrorMacro(<< fault);
  return 0;
}

void vtkSurfaceDistanceFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FrontalOnly: " << this->FrontalOnly << "\n";
  os << indent << "FrontalThreshold: " << this->FrontalThreshold << "\n";
  os << indent << "Signed: " << this->Signed << "\n";
  os << indent << "GenerateVectors: " << this->GenerateVectors << "\n";
  os << indent << "LargestComponentOnly: " << this->LargestComponentOnly << "\n";
  os << indent << "CoveredOnly: " << this->CoveredOnly << "\n";
}
