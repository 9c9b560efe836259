#pragma once

#include <QString>
#include <nlohmann/json_fwd.hpp>

class QObject;

namespace mien {

/// A change of a Session in the words of a menu: "FAP 31", "Scheme", "Motion vectors: Scale".
/// @param change  a merge patch of an undoable session
QString changeText(const nlohmann::json& change, const QObject& window);

}  // namespace mien
