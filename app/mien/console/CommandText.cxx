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

/// " --name value" for each value that was given; a flag's name alone.
std::string optionText(const CLI::Option& option) {
  if (option.count() == 0) return "";
  const std::string name = option.get_positional() ? "" : " " + option.get_name();
  if (option.get_expected_max() == 0) return name;
  std::string text;
  for (const std::string& value : option.results()) text += name + " " + quoted(value);
  return text;
}

/// "mien fdt show"
std::string nameOf(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return (parent ? nameOf(*parent) + " " + command.get_name() : "mien");
}

}  // namespace

std::string commandText(const CLI::App& command, const std::set<std::string>& without) {
  std::string text = nameOf(command);
  for (const CLI::Option* option : command.get_options())
    if (without.count(option->get_name()) == 0) text += optionText(*option);
  return text;
}

std::string commandText(const CLI::App& command, const std::vector<std::string>& positionals,
                        const std::set<std::string>& without) {
  std::string text = nameOf(command);
  for (const std::string& word : positionals) text += " " + quoted(word);
  for (const CLI::Option* option : command.get_options())
    if (!option->get_positional() && without.count(option->get_name()) == 0) text += optionText(*option);
  return text;
}

std::vector<std::string> commandWords(const std::string& text) {
  std::vector<std::string> words;
  bool inQuotes = false, inWord = false;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool escaped = c == '\\' && !inQuotes && i + 1 < text.size();
    const bool ends = c == ' ' && !inQuotes;
    if (!ends && !inWord) words.emplace_back();
    inWord = !ends;
    if (escaped)
      words.back() += text[++i];
    else if (c == '\'')
      inQuotes = !inQuotes;
    else if (!ends)
      words.back() += c;
  }
  return words;
}

}  // namespace mien
