#pragma once

#include <QObject>
#include <QString>
#include <functional>

#include "FileKind.h"

class QMainWindow;

namespace mien {

class FaceModel;

/// What becomes of a file that a dock or a view shows: boundary curves, scans, meshes, photographs, their meshes and
/// landmarks. The dock comes to the front once what it shows is there; a file that is refused opens none.
class FileOpener : public QObject {
  Q_OBJECT
 public:
  /// @param window  whose docks and views are meant
  FileOpener(FaceModel* model, QMainWindow* window);

  static bool opens(FileKind kind);
  bool open(FileKind kind,
            const QString& fileName);  ///< the model says what is wrong. @return whether it was taken over

  /// The endings of all files that are opened here, for the dialogue: "*.vtp *.mienz ..".
  static QString endings();

 private:
  struct Action;
  static const Action actions[];

  bool openCurves(const QString& fileName);
  bool openScan(const QString& fileName);
  bool openScanLandmarks(const QString& fileName);
  bool openMesh(const QString& fileName);
  bool openPhotograph(const QString& fileName);
  bool openPhotographMesh(const QString& fileName);
  bool succeeds(const std::function<void()>& act);
  void show(const QString& dock);

  FaceModel* model_;
  QMainWindow* window_;
  QString awaited_, photograph_;  ///< the dock of what is being read, and the photograph
};

}  // namespace mien
