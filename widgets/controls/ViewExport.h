#pragma once

#include <string>
#include <vector>

#include "ExportDrawing.h"

class QWidget;

namespace mien {

class RenderView;

/// A view in a figure.
struct ViewPanel {
  RenderView* view;
  std::string caption = {};  ///< below it, in words; may be empty
};

/// Views of the face as a figure: pictures of them beside each other, of one size, and below them what their colours
/// mean, as lines and text. The page is a column wide for one, the width of a page's text for several, unless the
/// options say otherwise.
/// @param key   drawn when it is visible
/// @param note  below all, small; may be empty
ExportDrawing viewDrawing(const std::vector<ViewPanel>& panels, QWidget* key, const std::string& title,
                          const std::string& note, const ExportOptions& options);

}  // namespace mien
