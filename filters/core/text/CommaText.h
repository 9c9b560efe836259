#pragma once

#include <string>
#include <vector>

namespace mien {

/// The cells of a line of a comma-separated file, without the blanks and quotation marks around them.
std::vector<std::string> splitAtCommas(const std::string& line);

/// What to add to the refusal of a header that holds semicolons or tabs where commas belong; nothing for others.
std::string separatorHint(const std::vector<std::string>& header);

/// The position of a column by its name, -1 when there is none.
int columnNamed(const std::vector<std::string>& header, const std::string& name);

}  // namespace mien
