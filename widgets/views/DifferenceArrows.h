#pragma once

#include <vtkNew.h>

#include <QObject>
#include <string>

class vtkActor;
class vtkGlyph3DMapper;
class vtkPolyData;

namespace mien {

class RenderView;

/// Vectors of a surface (mm) as arrows in its view, from each point to its counterpart; of many points a share, spread
/// evenly. What is shorter than a tenth of a millimetre has none.
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
  int count() const;  ///< how many are drawn

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void useTheme();
  void draw();

  RenderView* view_;
  vtkNew<vtkGlyph3DMapper> mapper_;
  vtkNew<vtkActor> actor_;
  vtkNew<vtkPolyData> surface_, origins_;
  std::string array_;
  double factor_ = 0.0, longest_ = 0.0;
};

}  // namespace mien
