#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace mien {

/// The program ffmpeg, which writes films when it is installed.
class Ffmpeg {
 public:
  static bool isInstalled();

  /// Whether it writes films with the ending of this name, found by writing two small pictures beside it. Pictures that
  /// ffmpeg could write are no films.
  static bool canWrite(const std::string& name);

  /// What makes a film with this ending play widely.
  static std::vector<std::string> format(const std::string& ending);

  /// A child with these arguments. @param input, output, messages  open files, or -1 for none
  static pid_t start(const std::vector<std::string>& arguments, int input, int output, int messages);

  /// Waits for a child; true when it was content.
  static bool wait(pid_t child);

  /// As ffmpeg takes a file name, whatever stands in it.
  static std::string fileArgument(const std::string& name) { return "file:" + name; }
};

}  // namespace mien
