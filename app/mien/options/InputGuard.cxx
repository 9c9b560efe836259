#include "InputGuard.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <sstream>

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

/// What an argument may name: itself, and the files of TABLE[:WEIGHT],TABLE[:WEIGHT] ...
std::vector<std::string> filesIn(const std::string& argument) {
  std::vector<std::string> files = {argument};
  std::istringstream parts(argument);
  for (std::string part; std::getline(parts, part, ',');)
    for (const std::string& file : {part, part.substr(0, part.rfind(':'))}) files.push_back(file);
  return files;
}

}  // namespace

void refuseToOverwrite(const CLI::App& command) {
  for (const CLI::Option* output : command.get_options(isOutputOption))
    for (const CLI::Option* input : command.get_options(isInputOption))
      for (const std::string& written : output->results())
        for (const std::string& read : input->results())
          for (const std::string& file : filesIn(read))
            if (isSameFile(written, file))
              throw ValueFailure("output '" + written + "' is the input '" + file +
                                 "', which it would replace; give another name");
}

}  // namespace mien
