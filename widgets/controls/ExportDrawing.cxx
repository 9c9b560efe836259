#include "ExportDrawing.h"

#include <memory>

#include "FigurePainter.h"

namespace mien {

ExportDrawing::ExportDrawing(const Figure& figure) {
  if (figure.panels.empty()) return;
  const auto painter = std::make_shared<FigurePainter>(figure, *FigureTheme::find("light"), width);
  size = painter->size();
  paint = [painter](QPainter& target) { painter->paint(target); };
  title = figure.title;
}

}  // namespace mien
