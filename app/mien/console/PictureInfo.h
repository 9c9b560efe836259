#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace mien {

/// What a photograph (.png .jpg .tif) holds, and the warp mesh beside it; or a warp mesh, or landmarks of a photograph
/// or a scan (.csv). Null for any other file. Throws a FileFailure for a file that is none.
nlohmann::ordered_json describePictureFile(const std::string& file);

/// The same for reading.
void printPictureFile(const nlohmann::ordered_json& picture);

}  // namespace mien
