#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "Program.h"

namespace {

const std::vector<std::string> drawings = {"pde-1",       "pde-4",           "pde-5",         "pde-6",    "pde-table-1",
                                           "fdt-2",       "fdt-3",           "fdt-4",         "fdt-6",    "fdt-7",
                                           "fdt-table-1", "mien-continuity", "mien-spectrum", "mien-size"};

Outcome runFigure(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "figure");
  const Outcome outcome = runMien(arguments);
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  return outcome;
}

std::vector<std::string> knownFigures() {
  std::vector<std::string> ids;
  std::istringstream lines(runFigure({"--list"}).output);
  for (std::string line; std::getline(lines, line);) ids.push_back(line.substr(0, line.find('\t')));
  return ids;
}

long countOf(const std::string& text, const std::string& part) {
  long count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// All that stands between the tags of an SVG file's text, one after the other.
std::string wordsOf(const std::string& svg) {
  std::string words;
  static const std::regex tag("<text[^>]*>([^<]*)</text>");
  for (std::sregex_iterator it(svg.begin(), svg.end(), tag), end; it != end; ++it) words += (*it)[1].str() + " ";
  return words;
}

}  // namespace

TEST(FigureCommand, EveryFigureOfTheCatalogueIsDrawnWithoutADisplay) {
  const TemporaryFolder folder;
  const Outcome drawn = runFigure({"--all", "-o", folder.file("all"), "--width", "85", "--dpi", "72"});
  EXPECT_NE(drawn.errors.find("pde-9 (9 of 22)"), std::string::npos) << "a log has a line for each: " << drawn.errors;
  const std::string page = readTextFile(folder.file("all/index.html"));
  const std::set<std::string> plain(drawings.begin(), drawings.end());
  const std::vector<std::string> ids = knownFigures();
  EXPECT_EQ(ids.size(), 22u);
  for (const std::string& id : ids) {
    const std::string svg = readTextFile(folder.file("all/" + id + ".svg"));
    EXPECT_GT(countOf(svg, "<text"), 0) << id;
    EXPECT_NE(svg.find("mien figure " + id), std::string::npos) << id << " carries its command";
    EXPECT_NE(svg.find("mien_face_state"), std::string::npos) << id << " carries its face";
    if (plain.count(id)) {
      EXPECT_EQ(countOf(svg, "<image"), 0) << id << " is all paths and text";
    }
    EXPECT_NE(page.find("id=\"" + id + "\""), std::string::npos);
    EXPECT_NE(page.find("mien figure " + id), std::string::npos) << "the page shows the command of " << id;
  }
  static const std::regex link("(?:src|href)=\"([^\"#][^\"]*)\"");
  for (std::sregex_iterator it(page.begin(), page.end(), link), end; it != end; ++it)
    EXPECT_FALSE(readTextFile(folder.file("all/" + (*it)[1].str())).empty()) << "beside the page: " << (*it)[1];
  EXPECT_EQ(page.find("http://"), std::string::npos) << "the page works offline";
  EXPECT_EQ(page.find("https://"), std::string::npos);
}

TEST(FigureCommand, DrawingsAreTheSameBytesTwice) {
  setenv("SOURCE_DATE_EPOCH", "0", 1);
  const TemporaryFolder folder;
  for (const std::string id : {"pde-1", "pde-5", "fdt-4", "pde-4"})
    for (const std::string ending : {".svg", ".pdf"}) {
      runFigure({id, "-o", folder.file("a" + ending)});
      runFigure({id, "-o", folder.file("b" + ending)});
      EXPECT_EQ(readTextFile(folder.file("a" + ending)), readTextFile(folder.file("b" + ending))) << id << ending;
    }
}

TEST(FigureCommand, PdfHoldsFontsAndNoRaster) {
  const TemporaryFolder folder;
  runFigure({"pde-6", "-o", folder.file("x.pdf")});
  const std::string pdf = readTextFile(folder.file("x.pdf"));
  EXPECT_GT(countOf(pdf, "/FontFile"), 0);
  EXPECT_EQ(countOf(pdf, "/Subtype /Image"), 0);
}

TEST(FigureCommand, TheFontIsThatAskedFor) {
  const TemporaryFolder folder;
  runFigure({"fdt-4", "--font", "DejaVu Serif", "-o", folder.file("x.svg")});
  const std::string svg = readTextFile(folder.file("x.svg"));
  EXPECT_NE(svg.find("font-family=\"DejaVu Serif, "), std::string::npos);
  EXPECT_EQ(svg.find("font-family=\"DejaVu Sans"), std::string::npos);
  runFigure({"fdt-4", "--font", "DejaVu Serif", "-o", folder.file("x.pdf")});
  const std::string pdf = readTextFile(folder.file("x.pdf"));
  EXPECT_NE(pdf.find("DejaVuSerif"), std::string::npos);
  EXPECT_GT(countOf(pdf, "/FontFile"), 0);
  runFigure({"--from", folder.file("x.pdf"), "-o", folder.file("again.svg")});
  EXPECT_EQ(readTextFile(folder.file("again.svg")), svg);
}

TEST(FigureCommand, OptionsWithoutUseAreSaid) {
  const TemporaryFolder folder;
  const std::string file = folder.file("x.svg");
  EXPECT_EQ(runFigure({"pde-5", "-o", file}).errors, "");
  EXPECT_NE(runFigure({"pde-5", "--frames", "3", "-o", file}).errors.find("pde-9, pde-10 do"), std::string::npos);
  EXPECT_EQ(readTextFile(file).find("--frames"), std::string::npos) << "the command it carries is the one it heeds";
  const std::string painted = MIEN_DATA_DIR "/textures/painted.png";
  EXPECT_NE(runFigure({"fdt-4", "--texture", painted, "-o", file}).errors.find("--texture is ignored"),
            std::string::npos);
}

/// A figure with states of its own is the same with a motion that it has no use for, and does not claim to show it.
TEST(FigureCommand, WhatAFigureDoesNotHeedIsNotInIt) {
  const TemporaryFolder folder;
  const std::string still = folder.file("still.svg"), moved = folder.file("moved.svg");
  for (const std::string id : {"pde-1", "pde-5", "pde-6", "fdt-4", "fdt-7", "fdt-table-1", "pde-table-1"}) {
    runFigure({id, "-o", still});
    const std::string errors = runFigure({id, "--expression", "joy", "--fdt", "surprise", "-o", moved}).errors;
    EXPECT_NE(errors.find("--expression, --viseme and --set are ignored"), std::string::npos) << id;
    EXPECT_NE(errors.find("--fdt is ignored"), std::string::npos) << id;
    EXPECT_EQ(readTextFile(still), readTextFile(moved)) << id;
  }
  runFigure({"mien-spectrum", "-o", still});
  EXPECT_EQ(runFigure({"mien-spectrum", "--expression", "joy", "-o", moved}).errors, "");
  EXPECT_NE(wordsOf(readTextFile(still)), wordsOf(readTextFile(moved)));
  EXPECT_NE(readTextFile(moved).find("N = 20 with remainder; joy"), std::string::npos);
}

/// Tables are of no face.
TEST(FigureCommand, OnlyFiguresOfAFaceNameIt) {
  const TemporaryFolder folder;
  for (const auto& [id, named] : {std::pair{"pde-1", true}, {"fdt-table-1", false}, {"pde-table-1", false}}) {
    runFigure({id, "-o", folder.file("x.svg")});
    EXPECT_EQ(countOf(wordsOf(readTextFile(folder.file("x.svg"))), "Generic face") > 0, named) << id;
  }
}

/// However wide the figure, the colours reach to the longest vector of all frames.
TEST(FigureCommand, ThinnedArrowsKeepTheLongest) {
  const TemporaryFolder folder;
  const std::string file = folder.file("x.svg");
  for (const std::string width : {"85", "100", "140", "170"}) {
    runFigure({"pde-9", "--width", width, "--frames", "26,66,139,223,279", "-o", file});
    const std::string svg = readTextFile(file);
    EXPECT_NE(svg.find(">20<"), std::string::npos) << "the end of the colours at " << width << " mm";
  }
}

TEST(FigureCommand, WhatWouldBeCutIsRefusedWithTheWidthThatIsNeeded) {
  const TemporaryFolder folder;
  const std::string file = folder.file("x.svg");
  for (const auto& [id, width] : {std::pair{"fdt-table-1", "84"}, {"pde-9", "60"}, {"pde-8", "50"}}) {
    const Outcome result = runMien({"figure", id, "--width", width, "-o", file});
    EXPECT_EQ(result.exitCode, 2) << id;
    EXPECT_NE(result.errors.find("needs at least"), std::string::npos) << result.errors;
    EXPECT_FALSE(std::filesystem::exists(file));
  }
}

TEST(FigureCommand, APatchOfTheCurvesHasItsBracket) {
  const TemporaryFolder folder;
  runFigure({"pde-1", "-o", folder.file("x.svg")});
  const std::string svg = readTextFile(folder.file("x.svg"));
  for (int patch = 0; patch < 9; ++patch)
    EXPECT_EQ(countOf(svg, ">P" + std::to_string(patch) + "<"), 2) << "mouth closed and open";
}

TEST(FigureCommand, AFigureIsDrawnAgainFromItsFile) {
  const TemporaryFolder folder;
  runFigure({"pde-1", "--scheme", "tangent", "-a", "2", "--width", "120", "-o", folder.file("a.svg")});
  for (const std::string ending : {".svg", ".pdf", ".png"}) {
    runFigure({"pde-1", "--scheme", "tangent", "-a", "2", "--width", "120", "-o", folder.file("made" + ending)});
    runFigure({"--from", folder.file("made" + ending), "-o", folder.file("again.svg")});
    EXPECT_EQ(readTextFile(folder.file("a.svg")), readTextFile(folder.file("again.svg"))) << ending;
  }
}

TEST(FigureCommand, OptionsBesideAFileReplaceItsOwn) {
  const TemporaryFolder folder;
  runFigure({"pde-1", "--scheme", "tangent", "--no-labels", "--width", "120", "-o", folder.file("made.svg")});
  runFigure({"--from", folder.file("made.svg"), "--width", "85", "--theme", "dark", "-o", folder.file("again.svg")});
  runFigure({"pde-1", "--scheme", "tangent", "--no-labels", "--width", "85", "--theme", "dark", "-o",
             folder.file("asked.svg")});
  const std::string again = readTextFile(folder.file("again.svg")), asked = readTextFile(folder.file("asked.svg"));
  EXPECT_EQ(wordsOf(again), wordsOf(asked));
  EXPECT_NE(again.find("width=\"85mm\""), std::string::npos);
  EXPECT_NE(again.find("--scheme tangent"), std::string::npos) << "what was not given anew stays";
}

TEST(FigureCommand, WordsAndLabelsCanBeLeftOut) {
  const TemporaryFolder folder;
  const std::string file = folder.file("x.svg");
  for (const std::string id : {"pde-5", "mien-spectrum", "mien-continuity"}) {
    runFigure({id, "-o", file});
    EXPECT_NE(wordsOf(readTextFile(file)).find("(b)"), std::string::npos) << id;
    runFigure({id, "--no-labels", "--no-caption", "-o", file});
    const std::string svg = readTextFile(file), words = wordsOf(svg);
    EXPECT_EQ(words.find("(b)"), std::string::npos) << id;
    EXPECT_EQ(words.find("N = 5"), std::string::npos) << id;
    EXPECT_NE(svg.find("N = "), std::string::npos) << id << " keeps its parameters in its metadata";
  }
}

TEST(FigureCommand, PicturesInPdfAreExactAndWithoutMasks) {
  const TemporaryFolder folder;
  runFigure({"pde-2", "--dpi", "60", "-o", folder.file("x.pdf")});
  const std::string pdf = readTextFile(folder.file("x.pdf"));
  EXPECT_GT(countOf(pdf, "/Subtype /Image"), 0);
  EXPECT_EQ(countOf(pdf, "DCTDecode"), 0) << "JPEG loses";
  EXPECT_EQ(countOf(pdf, "/SMask"), countOf(pdf, "/SMask /None"));
}

TEST(FigureCommand, AFigureHigherThanAPageIsSaid) {
  const TemporaryFolder folder;
  EXPECT_NE(runFigure({"pde-table-1", "--width", "40", "-o", folder.file("x.svg")}).errors.find("240 mm of a page"),
            std::string::npos);
}

TEST(FigureCommand, WidthsHaveUnits) {
  const TemporaryFolder folder;
  runFigure({"pde-5", "--width", "85", "-o", folder.file("a.svg")});
  runFigure({"pde-5", "--width", "8.5cm", "-o", folder.file("b.svg")});
  EXPECT_EQ(wordsOf(readTextFile(folder.file("a.svg"))), wordsOf(readTextFile(folder.file("b.svg"))));
  EXPECT_NE(readTextFile(folder.file("b.svg")).find("width=\"85mm\""), std::string::npos);
}

TEST(FigureCommand, TheTableOfExpressionsIsTheFile) {
  const TemporaryFolder folder;
  runFigure({"pde-table-1", "-o", folder.file("x.svg")});
  const std::string words = wordsOf(readTextFile(folder.file("x.svg")));
  const auto library = nlohmann::json::parse(readTextFile(MIEN_DATA_DIR "/animation/expressions.json"));
  int checked = 0;
  for (const auto& expression : library["expressions"])
    for (const auto& action : expression["actions"])
      for (const auto& [fap, value] : action["faps"].items()) {
        std::ostringstream cell;
        const double number = value.get<double>();
        cell << fap << ":\u00a0" << (number < 0.0 ? "−" : "") << std::abs(number);
        EXPECT_NE(words.find(cell.str()), std::string::npos) << expression["name"] << " " << cell.str();
        ++checked;
      }
  EXPECT_GT(checked, 60);
}

TEST(FigureCommand, AnglesInTheTableOfContinuityAreThoseMeasured) {
  const TemporaryFolder folder;
  runFigure({"mien-continuity", "-o", folder.file("x.svg")});
  const std::string words = wordsOf(readTextFile(folder.file("x.svg")));
  const auto measured = nlohmann::json::parse(runMien({"continuity", "--scheme", "four-curve", "--json"}).output);
  for (const auto& seam : measured["seams"]) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", seam["g1_max_deg"].get<double>());
    EXPECT_NE(words.find(std::string(text) + " "), std::string::npos) << seam["seam"] << " " << text;
  }
}

TEST(FigureCommand, WrongRequestsAreRefused) {
  const TemporaryFolder folder;
  const std::string file = folder.file("x.svg");
  const auto expect = [&](std::vector<std::string> arguments, int code, const std::string& part) {
    arguments.insert(arguments.begin(), "figure");
    const Outcome outcome = runMien(arguments);
    EXPECT_EQ(outcome.exitCode, code) << part;
    EXPECT_NE(outcome.errors.find(part), std::string::npos) << outcome.errors;
  };
  expect({"pde-77", "-o", file}, 2, "fdt-table-1, mien-continuity");
  expect({"pde-1"}, 2, "-o");
  expect({"pde-1", "-o", folder.file("x.gif")}, 2, ".svg");
  expect({"pde-1", "-o", file, "--width", "5"}, 2, "--width");
  for (const char* const width : {"nan", "0", "-85", "1e300", "85 bananas"})
    expect({"pde-1", "-o", file, "--width", width}, 2, "--width");
  expect({"pde-1", "-o", file, "--font", "DejaVu Sams"}, 2, "near ones are DejaVu");
  expect({"pde-1", "-o", file, "--font", "Xyzzyx"}, 2, "fc-list");
  expect({"pde-1", "-o", folder.file("none/x.svg")}, 1, "none");
  expect({"pde-1", "-o", file, "--resolution", "1000000x1000000"}, 2, "too fine");
  expect({"--all", "-o", folder.file("all"), "--format", "gif"}, 2, "--format");
  expect({"--all", "-o", "/dev/null/x"}, 1, "/dev/null/x");
  expect({"pde-2", "-o", file, "--dpi", "100000"}, 2, "--dpi");
  expect({"pde-9", "-o", file, "--frames", "99999"}, 2, "their numbers run from 0 to 300");
  expect({"pde-9", "-o", file, "--frames", "1,2,3,4,5,6,7,8,9"}, 2, "at most");
  expect({"--from", MIEN_DATA_DIR "/textures/painted.png", "-o", file}, 1, "painted.png");
  const std::string shown = folder.file("shown.svg");
  writeTextFile(shown, "<svg><desc>{\n  \"mien_face_state\": 2\n}</desc></svg>");
  expect({"--from", shown, "-o", file}, 1, "shown.svg: carries no command of mien figure, but its face");
  writeTextFile(shown, "<svg><desc>mien spectrum -a 2\n{}</desc></svg>");
  expect({"--from", shown, "-o", file}, 1, "run its own command again: mien spectrum -a 2\n");
  std::filesystem::remove(shown);
  expect({"--all"}, 2, "folder");
  expect({"--all", "--frames", "99999", "-o", folder.file("")}, 2, "their numbers run from 0 to 300");
  EXPECT_EQ(entriesIn(folder.file("")), 0) << "nothing is left behind";
}
