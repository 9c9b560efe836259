#pragma once

#include <string>
#include <vector>

namespace mien {

/// "23 yaw_l_eyeball, 24 yaw_r_eyeball", for messages; FAPs are 1 .. 68.
std::string listOfFAPs(const std::vector<int>& faps);

}  // namespace mien
