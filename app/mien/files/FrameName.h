#pragma once

#include <string>

namespace mien {

/// Stands for a frame's number in the name of an output: one file for each frame.
inline const std::string framePlaceholder = "{frame}";

bool isNumberedByFrame(const std::string& name);

/// The name with the frame's number in every place of the placeholder.
std::string nameForFrame(std::string name, const std::string& frame);

}  // namespace mien
