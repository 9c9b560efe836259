#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

class QObject;

namespace mien {

/// What the user has set in the input widgets of a window: choices, numbers, ticks, pressed buttons, texts and whatever
/// is a SessionPart. Each is kept under its object name within its dock, so that a new dock needs no code for it.
///
/// {"spectrumDock": {"spectrumMeasure": "RMS (mm)", "spectrumPartial": false}, .., "window": {..}}
class WidgetSettings {
 public:
  enum class Of {
    Session,  ///< all of them
    Undo      ///< those that change what is shown of the face, not which page or side of it is looked at
  };

  static nlohmann::json read(const QObject& window, Of of);

  /// Sets what differs, and lets it have its effect. A choice that its list does not hold yet is made as soon as it
  /// does; a widget that is not named, or with a value of another type, stays as it is.
  static void apply(const QObject& window, const nlohmann::json& settings);

  /// The widget of a setting; nullptr without one.
  static const QObject* find(const QObject& window, const std::string& dock, const std::string& name);
};

}  // namespace mien
