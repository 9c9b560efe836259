#pragma once

#include <string>
#include <vector>

#include "vtkSmartPointer.h"

class vtkImageData;

namespace mien {

/// Evenly chosen frames of an animation side by side, each with its caption.
class ContactSheet {
 public:
  static constexpr int columns = 6, rows = 4;
  static constexpr int tileSide = 240;  ///< pixels, the longer side of a frame on the sheet

  /// @param frameCount  of the animation; the sheet shows all when they fit
  explicit ContactSheet(int frameCount);

  bool wants(int frame) const;

  void add(vtkImageData* picture, const std::string& caption);

  /// Writes the sheet as PNG; without frames it does nothing.
  void write(const std::string& name) const;

 private:
  struct Tile {
    vtkSmartPointer<vtkImageData> picture;
    std::string caption;
  };

  std::vector<int> chosen_;
  std::vector<Tile> tiles_;
};

}  // namespace mien
