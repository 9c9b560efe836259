#pragma once

namespace mien {

/// What a reference of the command line tells beside its commands, in sentences that both pages and manual pages print.
struct ReferenceText {
  struct Entry {
    const char* name;
    const char* meaning;
  };

  static constexpr const char* introduction =
      "The same options describe the face in every command. Results go to standard output, in units that are named; "
      "problems go to standard error as one sentence that names the file, and where there is one the line. A file "
      "appears under its name only once it is complete. A value in square brackets is the one without the option.";

  static constexpr Entry exitCodes[] = {
      {"0", "done"},
      {"1", "a file cannot be read or written, or its content is wrong"},
      {"2", "an option, its value or a command is wrong"},
      {"130", "interrupted (Ctrl-C)"},
  };

  static constexpr Entry environment[] = {
      {"DISPLAY", "where pictures are rendered; without it a private Xvfb is started"},
      {"SOURCE_DATE_EPOCH",
       "seconds since 1970: the date of PDF figures, so that the same command gives the same bytes"},
  };
};

}  // namespace mien
