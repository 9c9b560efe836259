#include "AnimationJson.h"

#include "FAPFrame.h"

namespace mien {

int parseFAPKey(const std::string& key) {
  const bool digits = !key.empty() && key.size() <= 2 && key.find_first_not_of("0123456789") == std::string::npos;
  const int fap = digits ? std::stoi(key) : 0;
  if (fap < FAPFrame::firstLowLevel || fap > FAPFrame::count) refuse("\"" + key + "\" is no FAP; use 3 to 68");
  return fap;
}

}  // namespace mien
