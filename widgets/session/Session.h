#pragma once

#include <QObject>
#include <QString>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "SessionFiles.h"

class QMainWindow;

namespace mien {

class FaceModel;
struct FaceState;

/// All that the window shows, as one JSON object with the members
/// - `face`: the FaceState, as FaceStateText writes it;
/// - `docks`: the settings of each dock, and of what is around them (`window`), as WidgetSettings reads them;
/// - `window`: `geometry`, `layout` and `splitters`, as Qt writes them, in base64.
class Session : public QObject {
  Q_OBJECT
 public:
  Session(FaceModel* model, QMainWindow* window);

  /// For a file; a stream, which nobody can read twice, as the frame it is at. What was left out as its file is gone is
  /// still named, until it is changed.
  nlohmann::json whole();
  nlohmann::json cameras() const;   ///< of the views, by object name: kept, and no step of undo
  nlohmann::json undoable() const;  ///< `face`, and of `docks` what undo covers

  /// Shows a session; what it does not name stays as it is. Files that are gone are left out.
  /// @return nothing, or one sentence that says what is wrong; all is then as it was
  QString restore(const nlohmann::json& session);

  /// The same of a session of a file: looks for its files in the folder where it lies, too (SessionFiles), and the
  /// message bar names what is left out.
  QString open(const nlohmann::json& session, const QString& folder);

 private:
  nlohmann::json shown() const;
  QString show(const FaceState& state);
  void restoreWindow(const nlohmann::json& window);
  nlohmann::json windowState() const;

  FaceModel* model_;
  QMainWindow* window_;
  std::vector<SessionFiles::Absent> absent_;
};

}  // namespace mien
