#include "FooterText.h"

#include <sstream>

namespace mien {

namespace {

std::string withoutSpaces(const std::string& text) {
  const size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

}  // namespace

FooterText::FooterText(const std::string& footer) {
  std::istringstream lines(footer);
  bool inExamples = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("Example: ", 0) == 0 || line == "Examples:") {
      inExamples = true;
      addExample(line.substr(line.find(':') + 1));
    } else if (inExamples && line.rfind(' ', 0) == 0) {
      addExample(line);
    } else {
      inExamples = false;
      addNote(line);
    }
  }
}

void FooterText::addExample(const std::string& line) {
  const std::string text = withoutSpaces(line);
  if (text.empty()) return;
  const size_t gap = text.find("  ");
  examples.push_back({text.substr(0, gap), gap == std::string::npos ? "" : withoutSpaces(text.substr(gap))});
}

void FooterText::addNote(const std::string& line) {
  if (line.empty()) return;
  const bool indented = line.front() == ' ';
  if (notes.empty() || notes.back().indented != indented) notes.push_back({{}, indented});
  notes.back().lines.push_back(line);
}

}  // namespace mien
