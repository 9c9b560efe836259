#include "CommandText.h"

#include <CLI/CLI.hpp>

namespace mien {

namespace {

/// As a shell reads it back.
std::string quoted(const std::string& word) {
  const std::string plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

}  // namespace

std::string commandText(const CLI::App& command) {
  std::string text = "mien " + command.get_name();
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0) continue;
    const bool isFlag = option->get_expected_max() == 0;
    const std::string name = option->get_positional() ? "" : " " + option->get_name();
    if (isFlag) text += name;
    for (const std::string& value : isFlag ? std::vector<std::string>() : option->results())
      text += name + " " + quoted(value);
  }
  return text;
}

}  // namespace mien
