#include "ReferenceFormats.h"
#include "ValueChoices.h"

namespace mien {

namespace {

/// Between single quotes for a shell. None of the words has one itself but curve C22'.
std::string quoted(const std::string& text) {
  std::string safe = "'";
  for (const char c : text) safe += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return safe + "'";
}

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::string optionNames(const CommandDescription& command) {
  std::vector<std::string> names;
  for (const OptionDescription& option : command.options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  return joined(names, " ");
}

/// What may stand where no option does: the commands below, or the words of the first argument.
std::string argumentWords(const CommandDescription& command) {
  std::vector<std::string> words;
  for (const CommandDescription& below : command.commands)
    words.push_back(below.path.substr(below.path.rfind(' ') + 1));
  if (words.empty() && !command.arguments.empty()) words = valueChoices(command, command.arguments.front());
  return joined(words, " ");
}

/// One pattern per list of words; all options without one complete files.
std::string valueCases(const CommandDescription& command) {
  std::string cases;
  std::vector<std::string> others;
  for (const OptionDescription& option : command.options) {
    if (option.value.empty()) continue;
    const std::vector<std::string> words = valueChoices(command, option);
    if (words.empty())
      others.insert(others.end(), option.names.begin(), option.names.end());
    else
      cases += "        " + joined(option.names, " | ") + ") words=" + quoted(joined(words, " ")) + " ;;\n";
  }
  if (!others.empty()) cases += "        " + joined(others, " | ") + ") return ;;\n";
  return cases.empty() ? cases : "      case $before in\n" + cases + "      esac\n";
}

std::string commandCase(const CommandDescription& command) {
  return "    " + quoted(command.path) + ")\n      options=" + quoted(optionNames(command)) +
         "\n      arguments=" + quoted(argumentWords(command)) + "\n" + valueCases(command) + "      ;;\n";
}

/// Follows the words typed so far from command to command.
std::string commandSearch(const CommandDescription& program) {
  std::vector<std::string> paths;
  for (const CommandDescription* command : withAllBelow(program))
    if (command != &program) paths.push_back(quoted(command->path));
  return "  for ((i = 1; i < COMP_CWORD; ++i)); do\n"
         "    case \"$command ${COMP_WORDS[i]}\" in\n      " +
         joined(paths, " | ") +
         ")\n"
         "        command+=\" ${COMP_WORDS[i]}\" ;;\n"
         "    esac\n"
         "  done\n";
}

}  // namespace

std::string bashCompletion(const CommandDescription& program) {
  std::string text =
      "# Completion of mien for bash. Made by: mien reference --format bash\n"
      "# To try it: source <(mien reference --format bash)\n\n"
      "_mien() {\n"
      "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=mien\n"
      "  local options= arguments= words= i\n"
      "  COMPREPLY=()\n"
      "  # --option=value comes as three words.\n"
      "  [[ $before == '=' ]] && before=${COMP_WORDS[COMP_CWORD - 2]}\n"
      "  [[ $word == '=' ]] && before=${COMP_WORDS[COMP_CWORD - 1]} word=\n" +
      commandSearch(program) + "  case $command in\n";
  for (const CommandDescription* command : withAllBelow(program)) text += commandCase(*command);
  return text +
         "  esac\n"
         "  if [[ -z $words ]]; then\n"
         "    [[ $word == -* ]] && words=$options || words=$arguments\n"
         "  fi\n"
         "  # Without a word that fits, bash completes files (-o default).\n"
         "  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n"
         "}\n\n"
         "complete -o default -F _mien mien\n";
}

}  // namespace mien
