#include "InfoText.h"

#include <algorithm>
#include <cstdio>
#include <iostream>

namespace mien {

namespace {

constexpr size_t labelWidth = 18;

}  // namespace

void printLine(const std::string& label, const std::string& text) {
  std::cout << label << std::string(labelWidth - std::min(label.size(), labelWidth - 1), ' ') << text << "\n";
}

std::string joined(const nlohmann::ordered_json& list) {
  std::string text;
  for (const auto& item : list)
    text += (text.empty() ? "" : " ") + (item.is_string() ? item.get<std::string>() : item.dump());
  return text.empty() ? "none" : text;
}

std::string twoDigits(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

}  // namespace mien
