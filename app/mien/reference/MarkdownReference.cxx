#include <iterator>

#include "FooterText.h"
#include "ReferenceFormats.h"
#include "ReferenceText.h"
#include "SharedOptions.h"

namespace mien {

namespace {

constexpr const char* moreOptions = "Options of many commands";

/// Text in which no character has a meaning of its own.
std::string plain(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string("\\`*_<>#[]|").find(c) != std::string::npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string code(const std::string& text) {
  return "`" + text + "`";
}

std::string anchor(const std::string& heading) {
  std::string name;
  for (const char c : heading) name += c == ' ' ? '-' : c;
  return name;
}

std::string link(const std::string& text, const std::string& heading) {
  return "[" + text + "](#" + anchor(heading) + ")";
}

/// With an anchor that every reader of Markdown understands alike.
std::string heading(const std::string& text) {
  return "<a name=\"" + anchor(text) + "\"></a>\n## " + text + "\n\n";
}

std::string optionLine(const OptionDescription& option) {
  std::string head = option.namesText();
  if (!option.value.empty() && option.names.front().front() == '-') head += " " + option.value;
  if (option.repeats) head += " ...";
  return "- " + code(head) + (option.required ? " (required): " : ": ") + plain(option.text()) + "\n";
}

std::string optionList(const std::string& title, const std::vector<OptionDescription>& options) {
  if (options.empty()) return {};
  std::string text = "**" + title + "**\n\n";
  for (const OptionDescription& option : options) text += optionLine(option);
  return text + "\n";
}

std::string noteText(const FooterText::Note& note) {
  std::string text;
  for (const std::string& line : note.lines) text += note.indented ? "  " + line + "\n" : plain(line) + "\n";
  return text + "\n";
}

std::string exampleText(const FooterText& footer) {
  if (footer.examples.empty()) return {};
  std::string text = "```sh\n";
  for (const FooterText::Example& example : footer.examples)
    text += example.command + (example.remark.empty() ? "" : "   # " + example.remark) + "\n";
  return text + "```\n\n";
}

std::string sharedText(const std::vector<SharedOptions::Group>& groups) {
  std::string text;
  for (const SharedOptions::Group& group : groups) {
    text += text.empty() ? "" : "; ";
    text += group.name.empty() ? "" : group.name + ": ";
    for (const OptionDescription& option : group.options)
      text += (&option == &group.options.front() ? "" : ", ") + code(option.namesText());
  }
  return text.empty() ? text : "Also, " + link("as in many commands", moreOptions) + ": " + text + ".\n\n";
}

std::string commandText(const CommandDescription& command, const SharedOptions& shared) {
  std::string text = heading(command.path) + plain(command.summary) + ".\n\n";
  text += "    " + command.usage() + "\n\n";
  text += optionList("Arguments", command.arguments);
  for (const SharedOptions::Group& group : shared.own(command))
    text += optionList(group.name.empty() ? "Options" : group.name, group.options);
  text += sharedText(shared.sharedBy(command));
  const FooterText footer(command.footer);
  for (const FooterText::Note& note : footer.notes) text += noteText(note);
  return text + exampleText(footer);
}

std::string overview(const CommandDescription& program) {
  std::string text = "| command | what it does |\n|---|---|\n";
  for (const CommandDescription* command : withAllBelow(program))
    if (command != &program)
      text += "| " + link(command->path, command->path) + " | " + plain(command->summary) + " |\n";
  return text + "\n";
}

std::string entries(const std::string& title, const ReferenceText::Entry* begin, const ReferenceText::Entry* end) {
  std::string text = heading(title);
  for (const ReferenceText::Entry* entry = begin; entry != end; ++entry)
    text += "- " + code(entry->name) + ": " + plain(entry->meaning) + "\n";
  return text + "\n";
}

std::string sharedSection(const SharedOptions& shared) {
  std::string text = heading(moreOptions);
  for (const SharedOptions::Group& group : shared.groups())
    text += optionList(group.name.empty() ? "Results and help" : group.name, group.options);
  return text;
}

}  // namespace

std::string markdownReference(const CommandDescription& program) {
  const SharedOptions shared(program);
  std::string text =
      "# The commands\n\n<!-- Made by: mien reference --format markdown -o doc/manual/commands.md -->\n\n" +
      plain(program.summary) + ". " + plain(ReferenceText::introduction) + "\n\n" + overview(program);
  for (const CommandDescription* command : withAllBelow(program)) text += commandText(*command, shared);
  text += sharedSection(shared);
  text += entries("Exit codes", std::begin(ReferenceText::exitCodes), std::end(ReferenceText::exitCodes));
  text += entries("Environment", std::begin(ReferenceText::environment), std::end(ReferenceText::environment));
  text.pop_back();
  return text;
}

}  // namespace mien
