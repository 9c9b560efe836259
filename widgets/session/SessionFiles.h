#pragma once

#include <QString>
#include <QStringList>
#include <nlohmann/json.hpp>
#include <vector>

namespace mien {

/// The files that a session names: animation, curves, tables, photograph, scan, and what the face is compared with.
class SessionFiles {
 public:
  /// A part of the session that cannot be shown without a file that is not there.
  struct Absent {
    nlohmann::json::json_pointer place, owner;  ///< of the name, and of the member or dock's part that needs it
    nlohmann::json value, rest;                 ///< of the owner: with the file, and as it is shown without
  };

  /// The session with names that hold here: what is not under its name is looked for where it lay beside the session
  /// when that was saved (its member `folder`), and in the session's folder. Relative names begin there.
  /// @param folder  in which the session lies; empty: nowhere
  static nlohmann::json found(nlohmann::json session, const QString& folder);

  static std::vector<Absent> absentIn(const nlohmann::json& session);
  static QStringList names(const nlohmann::json& session, const std::vector<Absent>& absent);

  /// The session without the parts of docks that are absent. Of the face Session leaves out what is.
  static nlohmann::json without(nlohmann::json session, const std::vector<Absent>& absent);

  /// Says how the session is shown without them.
  static void setRest(const nlohmann::json& session, std::vector<Absent>& absent);

  /// Puts back what is absent, so that saving loses nothing; forgets what has been changed since.
  static void keep(nlohmann::json& session, std::vector<Absent>& absent);
};

}  // namespace mien
