#include "InputGuard.h"

#include <CLI/CLI.hpp>
#include <filesystem>

#include "Failure.h"

namespace mien {

namespace {

namespace fs = std::filesystem;

bool isOutputOption(const CLI::Option* option) {
  return option->check_name("--output");
}

bool isInputOption(const CLI::Option* option) {
  return !isOutputOption(option);
}

bool isSameFile(const std::string& a, const std::string& b) {
  std::error_code error;
  return fs::is_regular_file(a, error) && fs::is_regular_file(b, error) && fs::equivalent(a, b, error);
}

}  // namespace

void refuseToOverwrite(const CLI::App& command) {
  for (const CLI::Option* output : command.get_options(isOutputOption))
    for (const CLI::Option* input : command.get_options(isInputOption))
      for (const std::string& written : output->results())
        for (const std::string& read : input->results())
          if (isSameFile(written, read))
            throw ValueFailure("output '" + written + "' is the input '" + read +
                               "', which it would replace; give another name");
}

}  // namespace mien
