#pragma once

#include <QString>
#include <QToolButton>
#include <functional>
#include <string>

#include "ExportDrawing.h"

namespace mien {

class FaceModel;

/// A small menu that writes what a dock shows: its figure as SVG, PDF or PNG, its numbers as CSV.
class ExportButton : public QToolButton {
  Q_OBJECT
 public:
  /// @param figure   with title, caption and note, asked for when it is written
  /// @param numbers  text of a CSV file
  ExportButton(const QString& objectName, FaceModel* model, std::function<ExportDrawing()> figure,
               std::function<std::string()> numbers, QWidget* parent = nullptr);

  /// The ending decides on the format. The message bar says what went wrong. @return whether it was written
  bool write(const QString& fileName);

  /// A name for the figure as it is now, made of its title: "joy_against_the_neutral_face.svg".
  QString suggestedName(const QString& ending) const;

 private:
  void ask(const QString& ending, const QString& description);
  std::string writeFigure(const std::string& fileName) const;
  std::string writeNumbers(const QString& fileName) const;

  FaceModel* model_;
  std::function<ExportDrawing()> figure_;
  std::function<std::string()> numbers_;
};

}  // namespace mien
