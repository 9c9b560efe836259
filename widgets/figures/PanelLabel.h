#pragma once

#include <QString>

namespace mien {

/// "(a)", "(b)" .. for the panels of a figure; nothing when there is only one.
QString panelLabel(size_t index, size_t count);

}  // namespace mien
