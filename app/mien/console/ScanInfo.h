#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace mien {

/// What a scan (.ply .obj .stl .off) holds: points, polygons, components, box, unit, boundary loops; null for a file of
/// another ending. Throws a FileFailure for a file that is no scan.
nlohmann::ordered_json describeScanFile(const std::string& file);

/// The same for reading.
void printScanFile(const nlohmann::ordered_json& scan);

}  // namespace mien
