#pragma once

#include <QString>
#include <string>

namespace mien {

struct FaceDeformation;

/// What to call a table (FaceDeformation::table) in a list: "joy", the name of a file without its folder, "Fit 1".
QString shortTableText(const std::string& table);

/// "joy at 80 %", "Fit 1 at 100 %, hard"; nothing without a table.
QString deformationText(const FaceDeformation& deformation);

}  // namespace mien
