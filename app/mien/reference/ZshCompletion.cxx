#include "ReferenceFormats.h"
#include "ValueChoices.h"

namespace mien {

namespace {

/// The name of the function that completes a command: "_mien_fdt_fit".
std::string functionName(const CommandDescription& command) {
  std::string name = "_" + command.path;
  for (char& c : name)
    if (c == ' ') c = '_';
  return name;
}

/// Text inside '...' in a specification of _arguments, where brackets and colons have a meaning.
std::string zshText(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '\'') {
      safe += "'\\''";
      continue;
    }
    if (std::string("[]:\\").find(c) != std::string::npos) safe += '\\';
    safe += c;
  }
  return safe;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + zshText(word);
  return text;
}

/// ":value:what completes it".
std::string valuePart(const CommandDescription& command, const OptionDescription& option) {
  const std::vector<std::string> words = valueChoices(command, option);
  const std::string message = option.names.front().front() == '-' ? option.value : option.longestName();
  return ":" + zshText(message) + ":" + (words.empty() ? "_files" : "(" + joined(words) + ")");
}

/// A specification for each name; any of them ends the offer of all, unless the option may be given again.
std::string optionLines(const CommandDescription& command, const OptionDescription& option) {
  std::string names;
  for (const std::string& name : option.names) names += (names.empty() ? "" : " ") + name;
  std::string lines;
  for (const std::string& name : option.names) {
    lines +=
        " \\\n    '" + std::string(option.repeats ? "*" : "(" + names + ")") + name + "[" + zshText(option.help) + "]";
    lines += (option.value.empty() ? "" : valuePart(command, option)) + "'";
  }
  return lines;
}

std::string argumentLine(const CommandDescription& command, const OptionDescription& argument) {
  const std::string which = argument.repeats ? "*" : argument.required ? "" : ":";
  return " \\\n    '" + which + valuePart(command, argument) + "'";
}

std::string leafFunction(const CommandDescription& command) {
  std::string text = functionName(command) + "() {\n  _arguments -S";
  for (const OptionDescription& option : command.options) text += optionLines(command, option);
  for (const OptionDescription& argument : command.arguments) text += argumentLine(command, argument);
  return text + "\n}\n\n";
}

/// A command with others below it: completes their names, then hands over to the one that was named.
std::string branchFunction(const CommandDescription& command) {
  std::string text = functionName(command) +
                     "() {\n  local curcontext=$curcontext state line\n  typeset -A opt_args\n"
                     "  local -a commands=(";
  for (const CommandDescription& below : command.commands)
    text += "\n    '" + below.path.substr(below.path.rfind(' ') + 1) + ":" + zshText(below.summary) + "'";
  text += "\n  )\n  _arguments -C -S";
  for (const OptionDescription& option : command.options) text += optionLines(command, option);
  return text +
         " \\\n    '1: :->command' '*:: :->rest'\n"
         "  case $state in\n"
         "    command) _describe -t commands '" +
         command.path + " command' commands ;;\n    rest) (( $+functions[" + functionName(command) +
         "_$line[1]] )) && " + functionName(command) + "_$line[1] ;;\n  esac\n}\n\n";
}

}  // namespace

std::string zshCompletion(const CommandDescription& program) {
  std::string text = "#compdef mien\n# Completion of mien for zsh. Made by: mien reference --format zsh\n\n";
  for (const CommandDescription* command : withAllBelow(program))
    text += command->commands.empty() ? leafFunction(*command) : branchFunction(*command);
  return text +
         "# Loaded by compinit this is the function itself; sourced, it must be made known.\n"
         "if [[ $funcstack[1] == _mien ]]; then _mien \"$@\"; else compdef _mien mien; fi\n";
}

}  // namespace mien
