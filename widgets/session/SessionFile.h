#pragma once

#include <QString>
#include <nlohmann/json_fwd.hpp>

namespace mien {

/// Sessions on disk, in the form of SessionText.
class SessionFile {
 public:
  static constexpr const char* ending = ".mien-session.json";

  /// Reads a session, or a bare FaceState as figures carry it.
  /// @return nothing, or one sentence that names the file, says what is wrong and what to do
  static QString read(const QString& fileName, nlohmann::json& session);

  /// Appears under its name once it is whole. @return nothing, or what is wrong
  static QString write(const nlohmann::json& session, const QString& fileName);

  /// Another one when the file has been written since; empty where there is no file.
  static QString stampOf(const QString& fileName);
};

}  // namespace mien
