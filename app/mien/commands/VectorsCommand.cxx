#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "Command.h"
#include "CommandText.h"
#include "FaceStateText.h"
#include "Failure.h"
#include "FigureApplication.h"
#include "FigureFile.h"
#include "FrameName.h"
#include "MotionTableText.h"
#include "MotionVectorFigure.h"
#include "MotionWords.h"
#include "OutputFile.h"
#include "PolyDataFile.h"
#include "TableRows.h"
#include "VectorDrawing.h"
#include "VectorSource.h"
#include "VectorTable.h"
#include "vtkPolyData.h"

namespace mien {

namespace {

using json = nlohmann::ordered_json;

struct VectorsCommandOptions {
  VectorSource source;
  VectorDrawing drawing;
  std::vector<std::string> outputs;
  bool printJson = false;
  const CLI::App* command = nullptr;
};

/// Fields of one run and what of them is wanted.
class VectorReport {
 public:
  explicit VectorReport(VectorsCommandOptions& options) : options_(options), drawing_(options.drawing.options()) {}

  void run() {
    moments_ = options_.source.moments(drawing_.picture.plane);
    options_.drawing.chooseRegion(options_.source.face(), drawing_);
    chooseRows();
    addWords();
    figure_ = std::make_unique<MotionVectorFigure>(panels_, drawing_);
    for (const std::string& name : options_.outputs) write(name);
    options_.printJson ? printJson() : printReadable();
  }

 private:
  /// Tables hold what region and sampling choose, in front and behind; sampling in the picture knows only what is seen.
  void chooseRows() {
    VectorPictureOptions all = drawing_.picture;
    if (all.sampling.kind == VectorSampling::Kind::Automatic) all.sampling.kind = VectorSampling::Kind::Every;
    all.hidden = all.hidden || all.sampling.kind != VectorSampling::Kind::Even;
    for (VectorMoment& moment : moments_) {
      chosen_.push_back(drawnVectors(moment.field, all).chosen);
      panels_.push_back({moment.field, moment.frame.empty() ? "" : "frame " + moment.frame});
    }
    const bool empty = std::all_of(chosen_.begin(), chosen_.end(), [](const auto& rows) { return rows.empty(); });
    if (empty) throw ValueFailure("--region " + drawing_.picture.region.name + " holds no vertex of this surface");
  }

  void addWords() {
    if (options_.drawing.isBare()) return;
    MotionWords words = options_.source.words();
    words.view = options_.drawing.viewName();
    describeMotion(words, drawing_);
  }

  void write(const std::string& name) const {
    if (isNumberedByFrame(name))
      for (size_t i = 0; i < moments_.size(); ++i) writeOne(nameForFrame(name, moments_[i].frame), i);
    else if (FigureOptions::isFigure(name))
      writeFigure(*figure_, name, writeFaceState(moments_.front().state));
    else if (fileEnding(name) == "csv")
      OutputFile::write(name, allRows());
    else
      writeOne(name, 0);
  }

  void writeOne(const std::string& name, size_t moment) const {
    if (FigureOptions::isFigure(name))
      writeFigure(MotionVectorFigure(panels_, moment, drawing_), name, writeFaceState(moments_[moment].state));
    else if (fileEnding(name) == "csv")
      OutputFile::write(name, motionTableText(moments_[moment].field, chosen_[moment]));
    else
      writePolyData(chosenVectors(moments_[moment].vectors, moments_[moment].field, chosen_[moment]), name);
  }

  void writeFigure(const MotionVectorFigure& figure, const std::string& name, const std::string& state) const {
    options_.drawing.file().write(
        name, figure.size(), [&](QPainter& painter) { figure.paint(painter); }, options_.source.words().title(),
        commandText(*options_.command) + "\n" + options_.source.words().made + "\n" + state);
  }

  /// With the frame before the columns where there are several.
  std::string allRows() const {
    if (moments_.size() == 1) return motionTableText(moments_[0].field, chosen_[0]);
    std::vector<MotionTablePart> parts;
    for (size_t i = 0; i < moments_.size(); ++i) parts.push_back({moments_[i].frame, &moments_[i].field, &chosen_[i]});
    return motionTableText(parts);
  }

  json summary(size_t moment) const {
    json about = json::object();
    if (!moments_[moment].frame.empty()) about["frame"] = std::stod(moments_[moment].frame);
    about.update(vectorSummary(moments_[moment].field, chosen_[moment]));
    about["arrows"] = figure_->panels()[moment].picture().arrows.size();
    return about;
  }

  bool hasArrows() const {
    const auto& panels = figure_->panels();
    return std::any_of(panels.begin(), panels.end(), [](const auto& panel) { return !panel.picture().arrows.empty(); });
  }

  void printJson() const {
    json about = {{"against", options_.source.against()},
                  {"head_motion_removed", options_.source.headMotionRemoved()},
                  {"view", options_.drawing.view()},
                  {"sampling", figure_->sampling().text()},
                  {"scale_mm_motion_per_mm_arrow", figure_->scale()},
                  {"range_mm", figure_->lacksTowards() ? json() : json{figure_->rangeBegin(), figure_->rangeEnd()}},
                  {"reference_arrow_mm", figure_->reference()}};
    if (!drawing_.picture.region.isWhole()) about["region"] = drawing_.picture.region.name;
    for (size_t i = 0; i < moments_.size(); ++i) about["fields"].push_back(summary(i));
    std::cout << about.dump(2, ' ', false, json::error_handler_t::replace) << "\n";
  }

  void printReadable() const {
    json rows = json::array();
    for (size_t i = 0; i < moments_.size(); ++i) {
      rows.push_back(summary(i));
      rows.back().erase("largest_at");
    }
    std::cout << readableText(rows);
    if (hasArrows())
      std::cout << "1 mm of arrow is " << readableNumber(figure_->scale()) << " mm of motion; " << colorText() << "\n";
    else
      std::cout << "no motion: the figure has no arrows\n";
  }

  /// The largest vector may be hidden, or not be sampled.
  std::string colorText() const {
    if (figure_->lacksTowards()) return "no motion towards the viewer, all arrows have one colour";
    double largest = 0.0;
    for (size_t i = 0; i < moments_.size(); ++i)
      for (const int row : chosen_[i]) largest = std::max(largest, moments_[i].field.vectors.row(row).norm());
    const std::string text =
        "colours from " + readableNumber(figure_->rangeBegin()) + " to " + readableNumber(figure_->rangeEnd()) + " mm";
    if (drawing_.range || drawing_.color != MotionVectorOptions::Color::Magnitude || largest <= figure_->rangeEnd())
      return text;
    return text + ", which the arrows need; larger vectors are hidden or not sampled";
  }

  VectorsCommandOptions& options_;
  const FigureApplication application_;
  MotionVectorOptions drawing_;
  std::vector<VectorMoment> moments_;
  std::vector<std::vector<int>> chosen_;
  std::vector<MotionVectorPanel> panels_;
  std::unique_ptr<MotionVectorFigure> figure_;
};

void checkOutputs(const VectorsCommandOptions& options) {
  std::vector<std::string> known = FigureFile::endings();
  known.insert(known.end(), {"csv", "vtp"});
  for (const std::string& name : options.outputs) {
    requireEnding(name, known);
    if (isNumberedByFrame(name) && !options.source.isSeries())
      throw ValueFailure("output '" + name + "' has " + framePlaceholder + " in its name, which --frames fills in");
    if (options.source.isSeries() && !isNumberedByFrame(name) && fileEnding(name) == "vtp")
      throw ValueFailure("output '" + name + "' can hold one frame only; name it " + framePlaceholder +
                         ".vtp, one file for each");
    const OutputFile writable(name);  // known before a long computation, not after
  }
}

void run(VectorsCommandOptions& options) {
  checkOutputs(options);
  options.drawing.check();
  VectorReport(options).run();
}

const char* const help =
    "Examples:\n"
    "  mien vectors --expression joy -o joy.pdf\n"
    "  mien vectors --fap talk.fap --frames 100,120,125 --width 170 -o talk.svg       panels (a) (b) (c)\n"
    "  mien vectors --fap talk.fap --frames 100,120,125 -o 'talk-{frame}.svg'         a file for each frame\n"
    "  mien vectors --fap talk.fap --frame 120 --against previous --region mouth -o mouth.svg -o mouth.csv\n"
    "  mien vectors smile.ply --against neutral.ply --remove-head-motion --sample even:4 -o scan.pdf\n"
    "Arrows start where the surface is before the motion. All frames of a series have one scale and one range of "
    "colours,\n"
    "in one figure or in several. Lengths are drawn as seen, colours tell the length in space; what moves by less "
    "than\n"
    "0.0001 mm has no arrow, with --length equal what moves by less than 1 % of the largest. Tables (.csv: u, v, x, y, "
    "z, dx, dy, dz, magnitude_mm; u runs over the whole face from 0 "
    "to 1)\n"
    "and .vtp files hold all vectors that --region and --sample choose, behind the face too.";

}  // namespace

void addVectorsCommand(CLI::App& program) {
  const auto options = std::make_shared<VectorsCommandOptions>();
  CLI::App* command = program.add_subcommand("vectors", "Draw how a face moves: its motion vector field");
  options->command = command;
  command->add_flag("--json", options->printJson, "Machine-readable results on stdout");
  command->add_option(
      "-o,--output", options->outputs,
      "Files to write, once for each: the figure as .svg .pdf .png, the vectors as .csv .vtp; {frame} in "
      "the name stands for the number of the frame");
  options->source.addTo(*command);
  options->drawing.addTo(*command);
  command->footer(help);
  command->callback([options] { run(*options); });
}

}  // namespace mien
