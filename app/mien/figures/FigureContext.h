#pragma once

#include <QImage>
#include <map>
#include <memory>
#include <optional>

#include "FaceCurves.h"
#include "FacePipeline.h"
#include "FaceState.h"
#include "Figure.h"
#include "FigureDrawing.h"
#include "FigureSettings.h"
#include "MotionField.h"
#include "MotionVectorOptions.h"
#include "Plate.h"
#include "SceneStyle.h"
#include "VirtualDisplay.h"
#include "vtkSmartPointer.h"

class vtkImageData;
class vtkPolyData;

namespace mien {

struct CatalogueFigure;

constexpr double faceShape = 1.28;  ///< height over width of a picture of a face

/// What the figures of the catalogue are made with: the face that was asked for and ways to draw it.
class FigureContext {
 public:
  FigureContext(const FaceState& state, const FigureSettings& settings);

  /// From now on state() is what this figure heeds of the face that was asked for.
  void begin(const CatalogueFigure& figure);

  const FaceState& state() const { return state_; }
  const FigureSettings& settings() const { return settings_; }

  /// The pipeline of a face, up to date; valid until the next call. Throws a FileFailure or a ValueFailure.
  FacePipeline& pipeline(const FaceState& state);

  /// The face's boundary curves, animated, with features and pupils.
  FaceCurves curves(const FaceState& state);

  /// The neutral curves, as read and edited.
  FaceCurves neutralFace();
  vtkPolyData* neutralCurves(const FaceState& state);

  /// A picture of VTK's, whose first line is at the bottom.
  static QImage imageOf(vtkImageData* picture);

  /// Before anything else draws on a display.
  void requireDisplay();

  /// The face as a picture that fills a panel.
  ///
  /// @param width  of the panel, mm
  /// @param shape  height over width
  /// @param framed  points that the camera sees; without them the face alone
  QImage picture(const FaceState& state, SceneStyle style, double width, double shape, vtkPolyData* framed = nullptr);

  /// The same as a panel of a plate.
  PlatePanel facePanel(const std::string& heading, const FaceState& state, const SceneStyle& style, double width,
                       double shape);

  struct NamedFace {
    std::string heading;
    FaceState state;
  };

  /// Several faces at one scale and place, so that what moves is seen to move.
  std::vector<PlatePanel> facePanels(const std::vector<NamedFace>& faces, const SceneStyle& style, double width,
                                     double shape);

  /// The motion of the face from one state to another.
  MotionField motion(const FaceState& moved, const FaceState& origin);

  /// Motion vectors of a figure in the theme that was asked for.
  MotionVectorOptions vectorOptions() const;

  /// The face with one of the textures that were asked for, else the painted one that comes with Mien.
  FaceState textured(FaceState state, size_t texture = 0) const;

  /// Width of a panel that spans the figure, mm.
  double innerWidth() const;

  /// @param labelled  (a), (b) .. before panels, unless --no-labels
  FigureDrawing drawn(Plate plate, bool labelled = true) const;
  FigureDrawing drawn(Figure figure) const;

  /// Whether the figure is for one column of a page.
  bool isNarrow() const { return settings_.width < 120.0; }

 private:
  template <class Words>
  void keepWords(Words& words, FigureDrawing& drawing) const;
  vtkSmartPointer<vtkImageData> textureOf(FacePipeline& pipeline);

  FaceState asked_, state_;
  bool showsFace_ = true;
  FigureSettings settings_;
  FacePipeline pipeline_;
  std::map<std::pair<std::string, std::string>, vtkSmartPointer<vtkImageData>> warped_;  ///< by image and mesh
  std::optional<VirtualDisplay> display_;
};

}  // namespace mien
