#pragma once

#include <string>
#include <vector>

namespace mien {

/// A command's footer, taken apart: examples begin at "Example:" or "Examples:" and go on while lines are indented; all
/// else are notes.
struct FooterText {
  struct Example {
    std::string command;
    std::string remark;  ///< what stands beside the command, set off by two spaces; may be empty
  };

  /// Lines that belong together: a paragraph, or indented lines, which keep their layout.
  struct Note {
    std::vector<std::string> lines;
    bool indented = false;
  };

  explicit FooterText(const std::string& footer);

  std::vector<Example> examples;
  std::vector<Note> notes;

 private:
  void addExample(const std::string& line);
  void addNote(const std::string& line);
};

}  // namespace mien
