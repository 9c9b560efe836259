#pragma once

#include <optional>
#include <string>
#include <vector>

#include "CommaReader.h"

namespace mien {

/// The number in a cell of the current row. An empty or missing cell gives nothing and is no fault; text that is no
/// finite number is one: it names the column and what to do.
std::optional<double> numberIn(const CommaReader& reader, std::size_t column, std::string& fault);

/// "columns 'a', 'b' and 7 more are not used"; nothing for none.
std::string describeUnused(const std::vector<std::string>& names);

/// Why a row does not fit its header, or nothing.
std::string describeWidth(const CommaReader& reader);

}  // namespace mien
