#pragma once

#include <QString>

namespace mien {

/// What an entry of a list is called now, which a session may have kept under an earlier name.
///
/// @param list  the list's object name
/// @return `kept` itself where the list was never renamed
QString presentChoice(const QString& list, const QString& kept);

}  // namespace mien
