#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "Program.h"

namespace {

const std::array<const char*, 4> formats = {"markdown", "man", "bash", "zsh"};

std::string reference(const std::string& format) {
  const Outcome outcome = runMien({"reference", "--format", format});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  return outcome.output;
}

std::string helpOf(const std::string& path) {
  std::istringstream words(path + " --help");
  std::vector<std::string> arguments;
  for (std::string word; words >> word;) arguments.push_back(word);
  return runMien({arguments.begin() + 1, arguments.end()}).output;
}

/// The commands below one, as its help lists them.
std::vector<std::string> commandsIn(const std::string& path, const std::string& help) {
  const size_t list = help.find("\nSubcommands:\n");
  std::vector<std::string> paths;
  if (list == std::string::npos) return paths;
  std::istringstream lines(help.substr(help.find("\n  ", list) + 1));
  static const std::regex entry("  ([a-z-]+) .*");
  std::smatch found;
  for (std::string line; std::getline(lines, line) && std::regex_match(line, found, entry);)
    paths.push_back(path + " " + found[1].str());
  return paths;
}

/// The names of the options that a help explains: "-a", "--smoothing".
std::set<std::string> optionsIn(const std::string& help) {
  static const std::regex line("\n  (-[^ ]+)"), name("[^,]+");
  std::set<std::string> names;
  for (std::sregex_iterator found(help.begin(), help.end(), line), end; found != end; ++found) {
    const std::string list = (*found)[1];
    for (std::sregex_iterator one(list.begin(), list.end(), name); one != end; ++one) names.insert(one->str());
  }
  return names;
}

/// Every command with its options, told by the helps alone.
std::map<std::string, std::set<std::string>> everyCommand() {
  std::map<std::string, std::set<std::string>> commands;
  std::vector<std::string> open = {"mien"};
  while (!open.empty()) {
    const std::string path = open.back(), help = helpOf(path);
    open.pop_back();
    commands[path] = optionsIn(help);
    for (const std::string& below : commandsIn(path, help)) open.push_back(below);
  }
  return commands;
}

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const size_t first = text.find(begin);
  if (first == std::string::npos) return {};
  const size_t last = text.find(end, first + begin.size());
  return text.substr(first, last == std::string::npos ? last : last - first);
}

/// The part of a reference that is about a command.
std::string partOf(const std::string& format, const std::string& text, const std::string& path) {
  if (format == "markdown") return between(text, "\n## " + path + "\n", "\n## ");
  if (format == "bash") return between(text, "    '" + path + "')\n", "\n    'mien");
  if (format == "man") return between(text, "\n.SS " + path + " [", "\n.S");
  return between(text, "\n_" + std::regex_replace(path, std::regex(" "), "_") + "() {", "\n}\n");
}

/// A manual page without its escapes.
std::string withoutEscapes(const std::string& text) {
  return std::regex_replace(std::regex_replace(text, std::regex("\\\\f[BIR]"), ""), std::regex("\\\\-"), "-");
}

bool mentions(const std::string& text, const std::string& option) {
  return std::regex_search(text, std::regex("(^|[^A-Za-z0-9-])" + option + "($|[^A-Za-z0-9-])"));
}

bool isInstalled(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

/// What a shell prints when it runs a script, its complaints included.
std::string printedBy(const std::string& shell, const std::string& script) {
  const TemporaryFolder folder;
  const std::string file = folder.file("script"), output = folder.file("output");
  writeTextFile(file, script);
  const int status = std::system((shell + " " + file + " >" + output + " 2>&1").c_str());
  return readTextFile(output) + (status == 0 ? "" : "failed");
}

/// What bash offers for the last of these words.
std::string completed(const std::string& words) {
  return printedBy("bash", reference("bash") + "COMP_WORDS=(" + words +
                               ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_mien\necho -n \"${COMPREPLY[*]}\"\n");
}

TEST(ReferenceCommand, TheManualHasWhatTheProgramPrints) {
  EXPECT_TRUE(readTextFile(MIEN_DATA_DIR "/../doc/manual/commands.md") == reference("markdown"))
      << "the options have changed; make the page anew: mien reference --format markdown -o doc/manual/commands.md";
}

TEST(ReferenceCommand, EveryOptionOfEveryCommandIsInEachFormat) {
  const auto commands = everyCommand();
  EXPECT_GT(commands.size(), 30u);
  EXPECT_GT(commands.at("mien render").size(), 30u);
  EXPECT_EQ(commands.count("mien fdt fit"), 1u);
  for (const std::string format : formats) {
    const std::string text = format == "man" ? withoutEscapes(reference(format)) : reference(format);
    for (const auto& [path, options] : commands) {
      const std::string part = partOf(format, text, path);
      EXPECT_FALSE(part.empty()) << format << ": " << path;
      for (const std::string& option : options)
        EXPECT_TRUE(mentions(part, option)) << format << ": " << path << " " << option;
    }
  }
}

TEST(ReferenceCommand, OptionsInCommonAreExplainedOnce) {
  const std::string page = reference("markdown"), help = "Boundary curves, FILE.vtp or .mienz";
  const size_t first = page.find(help);
  ASSERT_NE(first, std::string::npos);
  EXPECT_GT(first, page.find("\n## Options of many commands"));
  EXPECT_EQ(page.find(help, first + 1), std::string::npos);
}

TEST(ReferenceCommand, FormatsManualPageWithoutWarnings) {
  if (!isInstalled("groff")) GTEST_SKIP() << "groff is not installed";
  const TemporaryFolder folder;
  const std::string page = folder.file("mien.1"), errors = folder.file("errors"), output = folder.file("output");
  ASSERT_EQ(runMien({"reference", "--format", "man", "-o", page}).exitCode, 0);
  const std::string groff = "groff -k -man -Tutf8 -ww " + page + " >" + output + " 2>" + errors;
  EXPECT_EQ(std::system(groff.c_str()), 0);
  EXPECT_EQ(readTextFile(errors), "");
  EXPECT_GT(readTextFile(output).size(), 20000u);
}

TEST(ReferenceCommand, BashCompletesCommandsOptionsAndValues) {
  if (!isInstalled("bash")) GTEST_SKIP() << "bash is not installed";
  EXPECT_EQ(printedBy("bash -n", reference("bash")), "");
  EXPECT_EQ(completed("mien sp"), "spectrum");
  EXPECT_EQ(completed("mien fdt cl"), "classify");
  EXPECT_EQ(completed("mien render --sch"), "--scheme");
  EXPECT_EQ(completed("mien fdt fit --stri"), "--strict");
  EXPECT_EQ(completed("mien render --scheme sp"), "spline");
  EXPECT_EQ(completed("mien render --scheme = t"), "tangent");
  EXPECT_EQ(completed("mien sweep --scheme al"), "all");
  EXPECT_EQ(completed("mien render --expression su"), "surprise");
  EXPECT_EQ(completed("mien render --viseme p_"), "p_b_m");
  EXPECT_EQ(completed("mien fdt apply sm"), "smile");
  EXPECT_EQ(completed("mien figure pde-t"), "pde-table-1");
  EXPECT_EQ(completed("mien patch --precision d"), "double");
  EXPECT_EQ(completed("mien render --face sp"), "") << "a file; bash completes it by itself";
  EXPECT_EQ(completed("mien fdt fit --expression jo"), "") << "a file here";
  EXPECT_EQ(completed("mien ref"), "") << "hidden";
}

TEST(ReferenceCommand, ZshReadsItsCompletion) {
  if (!isInstalled("zsh")) GTEST_SKIP() << "zsh is not installed";
  EXPECT_EQ(printedBy("zsh -n", reference("zsh")), "");
}

TEST(ReferenceCommand, IsForThoseWhoBuildMien) {
  EXPECT_EQ(runMien({"--help"}).output.find("reference"), std::string::npos);
  EXPECT_EQ(runMien({"sculpt"}).errors.find("reference"), std::string::npos);
  EXPECT_EQ(runMien({"reference", "--format", "html"}).exitCode, 2);
  EXPECT_EQ(runMien({"reference", "-o", "/nowhere/mien.1"}).exitCode, 1);
}

}  // namespace
