#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <QObject>
#include <string>
#include <vector>

#include "ArrowLayer.h"

class vtkPolyData;

namespace mien {

class RenderView;

/// Vectors of a surface (mm) as arrows in its view, from each point to its counterpart; of many points a share, none
/// nearer to the next than a distance that leaves room for an arrow. What is shorter than a tenth of a millimetre has
/// none.
class DifferenceArrows : public QObject {
  Q_OBJECT
 public:
  static constexpr double leastLength = 0.1;  ///< mm

  DifferenceArrows(RenderView* view, QObject* parent);
  ~DifferenceArrows() override;

  /// nullptr: none. @param array  name of a point array of three components
  /// @param longest  mm; longer ones are not drawn
  void show(vtkPolyData* surface, const char* array, double longest);
  void setFactor(double factor);  ///< mm of arrow per mm of difference; 0: no arrows. Default 0
  double factor() const { return factor_; }
  int count() const;                                                        ///< how many there are, on all sides
  const std::vector<ArrowLayer::Arrow>& arrows() const { return arrows_; }  ///< with their tips as they are drawn

 private:
  void choose(double apart);
  void prepare();

  RenderView* view_;
  vtkSmartPointer<vtkRenderer> renderer_;  ///< may outlive the view
  ArrowLayer layer_;
  vtkNew<vtkPolyData> surface_;
  std::vector<ArrowLayer::Arrow> arrows_;
  std::string array_;
  double factor_ = 0.0, longest_ = 0.0;
  double apart_ = 6.0;  ///< mm between arrows, at least
  unsigned long started_ = 0;
};

}  // namespace mien
