#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>

class QWidget;

namespace mien {

class FaceModel;
class History;
class Session;

/// The session as a document: the file that it came from or went to, and whether it has changed since.
class SessionDocument : public QObject {
  Q_OBJECT
 public:
  enum class Answer { Save, Discard, Cancel };
  using Question = std::function<Answer()>;
  using Warning = std::function<bool()>;  ///< @return whether to go on

  SessionDocument(Session* session, History* history, FaceModel* model, QWidget* window);
  ~SessionDocument() override;

  /// Opens a session, or a FaceState as figures carry it; the message bar says what is wrong with it, and all stays as
  /// it was. @return whether it was good
  bool open(const QString& fileName);

  /// Everything but the window's places as it is at the start; asks first where something would be lost.
  void startNew();
  void rememberStart();  ///< what that is

  /// Shows a session that an autosave kept, under its own name; or says what was wrong with it. @return whether it is
  /// shown
  bool recover(const nlohmann::json& session, const QString& fault);

  bool save(const QString& fileName);  ///< @return whether it was written; else the message bar says why not
  bool save();  ///< under its name; asks for one where it has none, and where others have written the file since
  bool saveAs();

  const QString& fileName() const { return file_; }
  bool isModified() const;

  /// Whether the window may close: asks once where something would be lost.
  bool mayClose();

  void followCameras();  ///< which are no steps of undo, but kept

  /// Who is asked about changes that are not saved. Default: a dialog, and nobody in a program without a name.
  void setQuestion(const Question& question) { question_ = question; }

  /// Who is asked before what others have written into the file is replaced. Default: as above.
  void setWarning(const Warning& warning) { warning_ = warning; }

 signals:
  void changed(bool isModified);  ///< perhaps: what it holds, or whether that is saved
  void opened(const QString& fileName);
  void saved(const QString& fileName);
  /// Whose session this is now, and how its file was then; empty: a new one.
  void named(const QString& fileName, const QString& stamp);

 private:
  bool show(const nlohmann::json& session, const QString& name, const QString& folder = QString());
  bool refuse(const QString& fault);  ///< @return false
  void take(const QString& fileName);
  bool mayReplace();
  void showTitle();

  Session* session_;
  History* history_;
  FaceModel* model_;
  QWidget* window_;
  QString file_, stamp_;
  bool recovered_ = false;
  std::unique_ptr<nlohmann::json> start_;
  std::unique_ptr<nlohmann::json> cameras_;  ///< as they were saved or opened
  Question question_;
  Warning warning_;
};

}  // namespace mien
