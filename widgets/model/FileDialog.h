#pragma once

#include <QString>

class QWidget;

namespace mien {

/// Asks for names of files, beginning in the folder of the file that was opened or saved last.
class FileDialog {
 public:
  /// @return the name; empty when none was chosen
  static QString open(QWidget* parent, const QString& title, const QString& filters);

  /// @param suggestion  a name without a folder, or with one of its own; empty: none
  /// @param ending      that a name without one gets, ".csv"
  static QString save(QWidget* parent, const QString& title, const QString& suggestion, const QString& filters,
                      const QString& ending);

  /// That this was the last one.
  static void remember(const QString& fileName);

  /// The name in that folder; as it is until there is one.
  static QString beside(const QString& name);
};

}  // namespace mien
