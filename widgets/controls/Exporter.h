#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <string>

#include "ExportDrawing.h"

namespace mien {

class FaceModel;

/// Writes what a dock or a view shows: its figure as .svg, .pdf or .png, its numbers as .csv.
class Exporter : public QObject {
  Q_OBJECT
 public:
  using Drawing = std::function<ExportDrawing(const ExportOptions&)>;

  /// @param drawing  with title, caption and note, asked for when it is written
  /// @param numbers  text of a CSV file
  Exporter(FaceModel* model, Drawing drawing, std::function<std::string()> numbers, QObject* parent);

  /// The ending decides on the format. The message bar says what went wrong. @return whether it was written
  bool write(const QString& fileName, const ExportOptions& options = ExportOptions()) const;

  ExportDrawing drawing(const ExportOptions& options) const { return drawing_(options); }

  /// A name for the figure as it is now, made of its title: "joy_against_the_neutral_face.svg".
  QString suggestedName(const QString& ending) const;

 private:
  std::string writeFigure(const std::string& fileName, const ExportOptions& options) const;
  std::string writeNumbers(const QString& fileName) const;

  FaceModel* model_;
  Drawing drawing_;
  std::function<std::string()> numbers_;
};

}  // namespace mien
