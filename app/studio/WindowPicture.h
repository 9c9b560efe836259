#pragma once

#include <QObject>
#include <QString>

namespace mien {

class StudioWindow;

/// Takes a picture of the window once its views have been drawn, writes it and ends the application: for figures and
/// documentation. Exit code 1 when the file cannot be written.
class WindowPicture : public QObject {
 public:
  WindowPicture(StudioWindow& window, const QString& file);

  /// @return nothing, or one sentence when the file is not to be a .png
  static QString describeEnding(const QString& file);

  /// Shows the face of a session, or of a state as figures carry it. @return nothing, or one sentence that says what is
  /// wrong
  static QString show(StudioWindow& window, const QString& stateFile);

 private:
  void take();

  StudioWindow& window_;
  QString file_;
};

}  // namespace mien
