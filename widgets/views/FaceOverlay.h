#pragma once

#include <vtkNew.h>

#include <QObject>
#include <QString>
#include <optional>

#include "ColorLegend.h"

class vtkActor;
class vtkPolyData;
class vtkPolyDataMapper;

namespace mien {

class FaceView;

/// Numbers that a dock shows on the face in place of its plain skin. The face shows one overlay at a time: when another
/// is shown, or the skin again, this one hides itself. What it shows and its scale stand beside the face.
/// @sa FaceColoring
class FaceOverlay : public QObject {
  Q_OBJECT
 public:
  using Colors = ColorLegend::Colors;
  using Scale = ColorLegend::Scale;

  /// @param dock  the title of the dock
  FaceOverlay(FaceView* view, const QString& dock, QObject* parent);
  ~FaceOverlay() override;

  /// What is shown next, in words without unit: "Mean curvature".
  void setSubject(const QString& subject) { subject_ = subject; }

  void showSurface(vtkPolyData* surface, const char* array, const Scale& scale);  ///< coloured by a point array
  void showColors(vtkPolyData* surface,
                  const char* array);    ///< a point array of red, green, blue (0 .. 255); without a scale
  void showZebra(vtkPolyData* surface);  ///< light and dark bands of one direction of its normals, drawn per pixel
  void showLines(vtkPolyData* lines, const char* array,
                 const Scale& scale);  ///< on the skin, coloured by a point array
  void hide();

  QString words() const;                                        ///< "Regions (Deformation dock)"
  const std::optional<Scale>& scale() const { return scale_; }  ///< of what is shown; nothing: it has none

  bool isShown() const { return shown_; }

 signals:
  void shownChanged(bool shown);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void useTheme();
  void show(vtkActor* actor, bool withSkin, const std::optional<Scale>& scale);
  void color(vtkPolyDataMapper* mapper, const char* array, const Scale& scale);
  static Scale marked(vtkPolyData* data, const char* array, const Scale& scale);
  void addZebraShader();
  void remove();

  FaceView* view_;
  QString dock_, subject_;
  std::optional<Scale> scale_;
  ColorLegend legend_;
  vtkNew<vtkPolyDataMapper> surfaceMapper_, zebraMapper_, lineMapper_;
  vtkNew<vtkActor> surface_, zebra_, lines_;
  bool shown_ = false;
};

}  // namespace mien
