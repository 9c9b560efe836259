#pragma once

#include <string>

#include "ExportDrawing.h"

class QWidget;

namespace mien {

class RenderView;

/// A view of the face as a figure: a picture of it, and below it what its colours mean, as lines and text.
/// @param key  drawn when it is visible
ExportDrawing viewDrawing(RenderView* view, QWidget* key, const std::string& title, const ExportOptions& options);

}  // namespace mien
