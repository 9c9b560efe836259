#pragma once

#include <gtest/gtest.h>
#include <signal.h>

#include <sstream>

#include "Program.h"

inline const std::string demo = std::string(MIEN_DATA_DIR) + "/animation/demo.fap";
inline const std::vector<std::string> small = {"--size", "48x40", "--resolution", "29x20"};

inline Outcome animate(std::vector<std::string> options) {
  options.insert(options.begin(), "animate");
  options.insert(options.end(), small.begin(), small.end());
  return runMien(options);
}

inline std::string frameName(int index) {
  char name[32];
  std::snprintf(name, sizeof name, "frame_%04d.png", index);
  return name;
}

inline std::vector<double> timesIn(const std::string& series) {
  const std::string text = readTextFile(series);
  std::vector<double> times;
  for (size_t at = 0; (at = text.find("timestep=\"", at)) != std::string::npos; ++at)
    times.push_back(std::stod(text.substr(at + 10)));
  return times;
}

/// A command with a pipe as its standard input.
class Piped {
 public:
  explicit Piped(std::vector<std::string> words) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return;
    words.insert(words.begin(), MIEN_PROGRAM);
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, ends[0], 0);
    posix_spawn(&child_, argv[0], &files, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    close(ends[0]);
    input_ = ends[1];
  }
  void send(const std::string& text) {
    ASSERT_EQ(write(input_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  void interrupt() { kill(child_, SIGINT); }
  int end() {
    close(input_);
    int status = 0;
    waitpid(child_, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t child_ = 0;
  int input_ = -1;
};

/// Lines of the demonstration: two of header, two per frame.
inline std::string demoLines(int first, int last) {
  std::istringstream lines(readTextFile(demo));
  std::string text, line;
  for (int number = 1; std::getline(lines, line); ++number)
    if (number >= first && number <= last) text += line + "\n";
  return text;
}

inline bool appears(const std::string& file) {
  for (int i = 0; i < 3000 && !std::filesystem::exists(file); ++i) usleep(10000);
  return std::filesystem::exists(file);
}

/// Seconds that a Theora film lasts: the number in its last Ogg page's granule position over the rate in its first
/// header.
inline double secondsOfFilm(const std::string& bytes) {
  const auto byte = [&](size_t at) { return static_cast<unsigned long>(static_cast<unsigned char>(bytes.at(at))); };
  const size_t header = bytes.find("\x80theora");
  const auto number = [&](size_t at) { return byte(at) << 24 | byte(at + 1) << 16 | byte(at + 2) << 8 | byte(at + 3); };
  const double rate = static_cast<double>(number(header + 22)) / static_cast<double>(number(header + 26));
  const unsigned long shift = (byte(header + 40) & 3) << 3 | byte(header + 41) >> 5;
  const size_t last = bytes.rfind("OggS");
  unsigned long position = 0;
  for (size_t i = 0; i < 8; ++i) position |= byte(last + 6 + i) << (8 * i);
  return static_cast<double>((position >> shift) + (position & ((1ul << shift) - 1))) / rate;
}
