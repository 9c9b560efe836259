#pragma once

#include <stdexcept>
#include <string>

namespace mien {

/// Ends a command with one sentence on stderr and an exit code.
class Failure : public std::runtime_error {
 public:
  int exitCode() const { return exitCode_; }

 protected:
  Failure(const std::string& sentence, int exitCode) : std::runtime_error(sentence), exitCode_(exitCode) {}

 private:
  int exitCode_;
};

/// A file, or what is in it, is wrong: `FILE:LINE: what is wrong and what to do`.
class FileFailure : public Failure {
 public:
  explicit FileFailure(const std::string& sentence) : Failure(sentence, 1) {}
};

/// An option, or its value, is wrong.
class ValueFailure : public Failure {
 public:
  explicit ValueFailure(const std::string& sentence) : Failure(sentence, 2) {}
};

/// The user stopped the command.
class Stopped : public Failure {
 public:
  explicit Stopped(const std::string& sentence) : Failure(sentence, 130) {}
};

}  // namespace mien
