#pragma once

#include <QString>

namespace mien {

/// A file that comes with the application, where it was installed or in the sources that it was built from.
/// @param name below the data folder, such as "animation/demo.fap"
QString bundledFile(const QString& name);

}  // namespace mien
