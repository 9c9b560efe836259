#pragma once

#include <QString>
#include <nlohmann/json_fwd.hpp>

namespace mien {

/// Dynamic property of an input widget that sessions and undo leave alone, since it mirrors something else or asks.
constexpr const char* notInSession = "notInSession";

/// Dynamic property of a line edit that checks its text when it is finished: the last text that was accepted, which
/// sessions and undo keep instead of what stands there.
constexpr const char* acceptedText = "acceptedText";

/// Object name of the part that knows which arrangement of docks is open. A new session leaves it as it is.
constexpr const char* arrangementPart = "workspaceKeeper";

/// What a widget knows besides the values of its input widgets and the FaceState: pinned states, cameras, an open scan.
/// A QObject that is one is kept in sessions, and covered by undo, under its object name.
class SessionPart {
 public:
  virtual ~SessionPart() = default;

  /// Objects, lists, numbers, texts, true and false; no null, which stands for what is not there.
  virtual nlohmann::json sessionState() const = 0;

  /// A member that is missing or of another type than expected has its value at the start.
  virtual void restoreSession(const nlohmann::json& state) = 0;

  virtual bool isUndoable() const { return true; }  ///< else it is kept in sessions only

  virtual QString changeName() const { return {}; }  ///< of a change, in an Undo menu; empty: that of its dock
};

}  // namespace mien
