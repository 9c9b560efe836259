#pragma once

#include <QByteArray>
#include <QString>
#include <string>

namespace mien {

/// The title and description that FigureFile keeps in its files: PNG text, SVG metadata, PDF's XMP packet.
struct FigureMetadata {
  std::string title;
  std::string description;  ///< first the command that made the figure, last the state of its face

  /// Reads them from a .png, .svg or .pdf that FigureFile wrote.
  /// @return nothing, or one sentence that says what is wrong with the file
  std::string read(const std::string& name);

  /// The command that made the figure, "mien ..."; empty for those of Mien Studio and pictures of mien render.
  std::string command() const;

  /// The state of the face that it shows, as JSON; empty when it carries none.
  std::string state() const;

  /// As a PDF file keeps it.
  QByteArray xmp() const;

  ///@{
  /// As a PNG file keeps a text: Qt writes its runs of white space as one blank, so that lines are written as \\n.
  static QString oneLine(const std::string& text);
  static std::string fromOneLine(const QString& line);
  ///@}
};

}  // namespace mien
