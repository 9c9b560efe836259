#pragma once

#include <string>

#include "JsonText.h"

namespace mien {

/// The number of a low-level FAP as a key, "3" to "68"; others are refused.
int parseFAPKey(const std::string& key);

}  // namespace mien
