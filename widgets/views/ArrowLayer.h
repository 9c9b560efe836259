#pragma once

#include <vtkNew.h>

#include <Eigen/Core>
#include <vector>

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace mien {

/// Arrows in a view as flat, white shapes with a dark rim, which stand out from light and from dark colours: of one
/// width in pixels, turned to the camera and before everything else, so that none ends within a surface. They are
/// where their ends are seen; what points at the camera is too short to be an arrow, and is left out.
class ArrowLayer {
 public:
  struct Arrow {
    Eigen::Vector3d tail, tip, normal;  ///< mm; of the surface at the tail, (0, 0, 0) where it is unknown
  };

  explicit ArrowLayer(vtkRenderer* renderer);

  void setVisible(bool visible);
  /// For the camera as it is; arrows on skin that is turned away are left out.
  /// @param pixel    mm of the view, in its middle, that a pixel of the screen is wide
  /// @param surface  whose box the arrows stand before
  void draw(const std::vector<Arrow>& arrows, double pixel, vtkPolyData* surface);

 private:
  vtkRenderer* renderer_;
  vtkNew<vtkPolyData> shapes_;
  vtkNew<vtkActor> actor_;
};

}  // namespace mien
