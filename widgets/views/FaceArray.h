#pragma once

#include <QString>
#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace mien {

/// An array of the face's surface, or one component of it, that the face can be coloured by.
struct FaceArray {
  std::string name;
  int component = -1;  ///< -1: the only one, or the length of several
  bool ofCells = false;
  QString title;  ///< in words, with unit

  bool operator==(const FaceArray& other) const { return title == other.title; }

  /// What there is in a surface, patches and what VTK keeps for itself left out; nullptr: nothing.
  static std::vector<FaceArray> in(vtkPolyData* surface);

  /// What the face filter computes when it is asked to: curvatures and derivatives.
  static const std::vector<FaceArray>& onDemand();
  bool isCurvature() const;
  bool isDerivative() const;

  /// nullptr where a surface has none of that name.
  vtkDataArray* find(vtkPolyData* surface) const;

  /// Where 96 % of its finite values lie: a few at lids and mouth corners are larger by far. {0, 0} without any.
  std::pair<double, double> spread(vtkPolyData* surface) const;
  std::pair<double, double> range(vtkPolyData* surface) const;  ///< of all finite values
};

}  // namespace mien
