#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include "TemporaryFolder.h"
#include "TextFile.h"

/// What a run of the command line said and how it ended.
struct Outcome {
  int exitCode = -1;
  std::string output;
  std::string errors;
};

/// Runs the command line `mien` with these arguments, without any display, in the locale of the test.
inline Outcome runMien(const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {MIEN_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv, environment;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  for (char** variable = environ; *variable; ++variable)
    if (std::string(*variable).rfind("DISPLAY=", 0) != 0) environment.push_back(*variable);
  environment.push_back(nullptr);
  const TemporaryFolder folder;
  const std::string outputFile = folder.file("output"), errorFile = folder.file("errors");
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, 1, outputFile.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&files, 2, errorFile.c_str(), O_WRONLY | O_CREAT, 0600);
  pid_t child = 0;
  int status = -1;
  Outcome outcome;
  if (posix_spawn(&child, argv[0], &files, nullptr, argv.data(), environment.data()) == 0 &&
      waitpid(child, &status, 0) == child)
    outcome.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  posix_spawn_file_actions_destroy(&files);
  outcome.output = readTextFile(outputFile);
  outcome.errors = readTextFile(errorFile);
  return outcome;
}
