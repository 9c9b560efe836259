#pragma once

#include <fstream>
#include <iterator>
#include <string>

#include "FigureFile.h"
#include "FigurePainter.h"

namespace mien {

inline std::string bytesOf(const std::string& name) {
  std::ifstream stream(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Writes a figure and gives the file's bytes; the fault when it could not be written.
inline std::string writtenFigure(const Figure& figure, const std::string& name, double width = 170.0,
                                 const std::string& theme = "light") {
  const FigurePainter painter(figure, *FigureTheme::find(theme), width);
  FigureFile file(name);
  file.setTitle("Sample");
  file.setDescription("mien sweep --scheme all");
  const std::string fault = file.write(painter.size(), [&](QPainter& p) { painter.paint(p); });
  return fault.empty() ? bytesOf(name) : fault;
}

}  // namespace mien
