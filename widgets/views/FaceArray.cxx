#include "FaceArray.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <QObject>
#include <algorithm>
#include <cmath>

namespace mien {

namespace {

constexpr double tail = 0.02;  // of the values, at each end
constexpr const char* axes[] = {"x", "y", "z"};

/// An array of the pipeline in words.
struct Known {
  const char* name;
  QString title;
  bool hasLength = true;  ///< whether the length of its components means something
};

const std::vector<Known>& known() {
  static const std::vector<Known> table = {
      {"Displacement", QObject::tr("Displacement%1 (mm)")},
      {"Distance", QObject::tr("Distance (mm)")},
      {"Normals", QObject::tr("Normal%1"), false},
      {"TextureCoordinates", QObject::tr("Texture coordinate%1"), false},
  };
  return table;
}

/// "%1" in a title is the place of the component.
QString titleOf(const std::string& name, const QString& component) {
  for (const Known& array : known())
    if (name == array.name) return array.title.contains("%1") ? array.title.arg(component) : array.title;
  return QString::fromStdString(name) + component;
}

bool hasLength(const std::string& name) {
  return std::none_of(known().begin(), known().end(),
                      [&](const Known& array) { return name == array.name && !array.hasLength; });
}

bool isLeftOut(const std::string& name) {
  return name.empty() || name == "PatchId" || name.rfind("vtk", 0) == 0;
}

void add(vtkDataSetAttributes* data, bool ofCells, std::vector<FaceArray>& arrays) {
  for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
    vtkDataArray* array = data->GetArray(i);
    const std::string name = array && array->GetName() ? array->GetName() : "";
    if (isLeftOut(name)) continue;
    const int components = array->GetNumberOfComponents();
    if (components == 1 || hasLength(name)) arrays.push_back({name, -1, ofCells, titleOf(name, QString())});
    for (int k = 0; k < components && components > 1; ++k)
      arrays.push_back(
          {name, k, ofCells, titleOf(name, components > 3 ? QString(" %1").arg(k + 1) : QString(" %1").arg(axes[k]))});
  }
}

}  // namespace

std::vector<FaceArray> FaceArray::in(vtkPolyData* surface) {
  std::vector<FaceArray> arrays;
  if (!surface) return arrays;
  add(surface->GetPointData(), false, arrays);
  add(surface->GetCellData(), true, arrays);
  const auto isOnDemand = [](const FaceArray& array) { return array.isCurvature() || array.isDerivative(); };
  arrays.erase(std::remove_if(arrays.begin(), arrays.end(), isOnDemand), arrays.end());
  return arrays;
}

const std::vector<FaceArray>& FaceArray::onDemand() {
  static const std::vector<FaceArray> arrays = {
      {"MeanCurvature", -1, false, QObject::tr("Mean curvature H (1/mm)")},
      {"GaussianCurvature", -1, false, QObject::tr("Gaussian curvature K (1/mm\u00b2)")},
      {"MaximumCurvature", -1, false, QObject::tr("Curvature \u03ba1 (1/mm)")},
      {"MinimumCurvature", -1, false, QObject::tr("Curvature \u03ba2 (1/mm)")},
      {"Su", -1, false, QObject::tr("Length of dS/du (mm)")},
      {"Sv", -1, false, QObject::tr("Length of dS/dv (mm)")},
  };
  return arrays;
}

bool FaceArray::isCurvature() const {
  return name.size() > 9 && name.rfind("Curvature") == name.size() - 9;
}

bool FaceArray::isDerivative() const {
  return name == "Su" || name == "Sv";
}

vtkDataArray* FaceArray::find(vtkPolyData* surface) const {
  if (!surface || name.empty()) return nullptr;
  return ofCells ? surface->GetCellData()->GetArray(name.c_str()) : surface->GetPointData()->GetArray(name.c_str());
}

std::pair<double, double> FaceArray::spread(vtkPolyData* surface) const {
  vtkDataArray* array = find(surface);
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i) {
    double sum = 0.0;
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
      sum += array->GetComponent(i, k) * array->GetComponent(i, k);
    const double value = component >= 0                        ? array->GetComponent(i, component)
                         : array->GetNumberOfComponents() == 1 ? array->GetComponent(i, 0)
                                                               : std::sqrt(sum);
    if (std::isfinite(value)) values.push_back(value);
  }
  if (values.empty()) return {0.0, 0.0};
  const auto at = [&](double share) {
    const auto place = values.begin() + std::lround(share * (values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
  };
  const double low = at(tail), high = at(1.0 - tail);
  return {low, high};
}

std::pair<double, double> FaceArray::range(vtkPolyData* surface) const {
  vtkDataArray* array = find(surface);
  if (!array || array->GetNumberOfTuples() == 0) return {0.0, 0.0};
  double ends[2];
  array->GetFiniteRange(ends, component < 0 && array->GetNumberOfComponents() == 1 ? 0 : component);
  return {ends[0], ends[1]};
}

}  // namespace mien
