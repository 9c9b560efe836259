#include <gtest/gtest.h>

#include <cstdlib>

#include "Program.h"

namespace {

const std::vector<std::string> commands = {"info",    "surface",    "curves",   "patch", "render",    "animate",
                                           "acquire", "continuity", "spectrum", "sweep", "influence", "compare"};

TEST(Program, EveryCommandExplainsItselfWithAnExample) {
  const Outcome overview = runMien({"--help"});
  EXPECT_EQ(overview.exitCode, 0);
  for (const std::string& command : commands) {
    EXPECT_NE(overview.output.find("\n  " + command + " "), std::string::npos) << command;
    const Outcome help = runMien({command, "--help"});
    EXPECT_EQ(help.exitCode, 0) << command;
    EXPECT_NE(help.output.find("Example: mien " + command), std::string::npos) << command;
    EXPECT_EQ(help.errors, "") << command;
  }
}

TEST(Program, WrongUseEndsWithTwoAndSaysWhatThereIs) {
  EXPECT_EQ(runMien({}).exitCode, 2);
  const Outcome unknown = runMien({"sculpt"});
  EXPECT_EQ(unknown.exitCode, 2);
  EXPECT_EQ(unknown.errors.rfind("mien: there is no command 'sculpt'; the commands are info, ", 0), 0u)
      << unknown.errors;
  const Outcome option = runMien({"info", "--hat"});
  EXPECT_EQ(option.exitCode, 2);
  EXPECT_NE(option.errors.find("--hat"), std::string::npos) << option.errors;
  EXPECT_NE(option.errors.find("mien info --help"), std::string::npos) << option.errors;
}

TEST(Program, TellsItsVersion) {
  const Outcome version = runMien({"--version"});
  EXPECT_EQ(version.exitCode, 0);
  EXPECT_EQ(version.output.rfind("mien ", 0), 0u);
}

TEST(Program, ResultsThatCannotBeWrittenAreNoSuccess) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full here";
  const TemporaryFolder folder;
  const std::string errors = folder.file("errors");
  const int status = std::system((std::string(MIEN_PROGRAM) + " info >/dev/full 2>" + errors).c_str());
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_NE(readTextFile(errors).find("mien: the results cannot be written"), std::string::npos);
}

}  // namespace
