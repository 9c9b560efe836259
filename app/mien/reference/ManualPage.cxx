#include <iterator>

#include "FooterText.h"
#include "ReferenceFormats.h"
#include "ReferenceText.h"
#include "SharedOptions.h"

namespace mien {

namespace {

/// Text in which no character has a meaning of its own. A line that begins with a dot or a quote would be a request.
std::string plain(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    const bool starts = escaped.empty() || escaped.back() == '\n';
    if (starts && (c == '.' || c == '\'')) escaped += "\\&";
    if (c == '\\')
      escaped += "\\e";
    else if (c == '-')
      escaped += "\\-";
    else
      escaped += c;
  }
  return escaped;
}

std::string bold(const std::string& text) {
  return "\\fB" + plain(text) + "\\fR";
}

std::string optionText(const OptionDescription& option) {
  std::string text = ".TP\n";
  for (const std::string& name : option.names) text += (&name == &option.names.front() ? "" : ", ") + bold(name);
  if (!option.value.empty() && option.names.front().front() == '-') text += " \\fI" + plain(option.value) + "\\fR";
  if (option.repeats) text += " ...";
  return text + (option.required ? " (required)\n" : "\n") + plain(option.text()) + "\n";
}

std::string optionList(const std::string& title, const std::vector<OptionDescription>& options) {
  std::string text = title.empty() ? "" : ".PP\n" + bold(title) + "\n";
  for (const OptionDescription& option : options) text += optionText(option);
  return text;
}

std::string unfilled(const std::vector<std::string>& lines) {
  std::string text = ".PP\n.nf\n";
  for (const std::string& line : lines) text += plain(line) + "\n";
  return text + ".fi\n";
}

std::string noteText(const FooterText::Note& note) {
  if (note.indented) return unfilled(note.lines);
  std::string text = ".PP\n";
  for (const std::string& line : note.lines) text += plain(line) + "\n";
  return text;
}

std::string exampleText(const FooterText& footer) {
  std::vector<std::string> lines;
  for (const FooterText::Example& example : footer.examples)
    lines.push_back("    " + example.command + (example.remark.empty() ? "" : "   # " + example.remark));
  return lines.empty() ? std::string() : unfilled(lines);
}

std::string sharedText(const std::vector<SharedOptions::Group>& groups) {
  std::string names;
  for (const SharedOptions::Group& group : groups)
    for (const OptionDescription& option : group.options)
      names += (names.empty() ? "" : ", ") + bold(option.namesText());
  return names.empty() ? names : ".PP\nAlso, as in many commands: " + names + ".\n";
}

std::string commandText(const CommandDescription& command, const SharedOptions& shared) {
  std::string text = ".SS " + plain(command.usage()) + "\n" + plain(command.summary) + ".\n";
  text += optionList("", command.arguments);
  for (const SharedOptions::Group& group : shared.own(command)) text += optionList(group.name, group.options);
  text += sharedText(shared.sharedBy(command));
  const FooterText footer(command.footer);
  for (const FooterText::Note& note : footer.notes) text += noteText(note);
  return text + exampleText(footer);
}

std::string entries(const std::string& title, const ReferenceText::Entry* begin, const ReferenceText::Entry* end) {
  std::string text = ".SH " + title + "\n";
  for (const ReferenceText::Entry* entry = begin; entry != end; ++entry)
    text += ".TP\n" + bold(entry->name) + "\n" + plain(entry->meaning) + "\n";
  return text;
}

/// What the program is, without its name, which a manual page puts before it.
std::string purpose(const CommandDescription& program) {
  const size_t colon = program.summary.find(": ");
  return colon == std::string::npos ? program.summary : program.summary.substr(colon + 2);
}

std::string heading(const CommandDescription& program, const std::string& version) {
  return ".\\\" Made by: mien reference --format man\n.TH MIEN 1 \"\" \"mien " + plain(version) +
         "\" \"User commands\"\n.SH NAME\nmien \\- " + plain(purpose(program)) + "\n.SH SYNOPSIS\n" + bold("mien") +
         " \\fICOMMAND\\fR [\\fIOPTIONS\\fR] [\\fIARGUMENTS\\fR]\n.SH DESCRIPTION\n" +
         plain(ReferenceText::introduction) + "\n";
}

}  // namespace

std::string manualPage(const CommandDescription& program, const std::string& version) {
  const SharedOptions shared(program);
  std::string text = heading(program, version) + ".SH COMMANDS\n";
  for (const CommandDescription* command : withAllBelow(program)) text += commandText(*command, shared);
  text += ".SH OPTIONS OF MANY COMMANDS\n";
  for (const SharedOptions::Group& group : shared.groups()) text += optionList(group.name, group.options);
  text += entries("EXIT STATUS", std::begin(ReferenceText::exitCodes), std::end(ReferenceText::exitCodes));
  text += entries("ENVIRONMENT", std::begin(ReferenceText::environment), std::end(ReferenceText::environment));
  return text + ".SH SEE ALSO\nThe manual in the folder doc/manual of Mien.\n";
}

}  // namespace mien
