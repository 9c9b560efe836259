#include "ExportDrawing.h"

#include <memory>

#include "FigurePainter.h"

namespace mien {

ExportDrawing::ExportDrawing(const Figure& figure, const ExportOptions& options) {
  if (figure.panels.empty()) return;
  const double width = options.width > 0.0 ? options.width : pageWidth;
  const auto painter = std::make_shared<FigurePainter>(figure, options.figureTheme(), width);
  size = painter->size();
  paint = [painter](QPainter& target) { painter->paint(target); };
  title = figure.title;
}

}  // namespace mien
