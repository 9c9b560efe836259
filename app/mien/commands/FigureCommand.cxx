#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <set>

#include "Arguments.h"
#include "Command.h"
#include "CommandText.h"
#include "CsvText.h"
#include "FaceMotion.h"
#include "FaceOptions.h"
#include "FacePipeline.h"
#include "FaceStateText.h"
#include "FaceTexture.h"
#include "Failure.h"
#include "FigureApplication.h"
#include "FigureCatalogue.h"
#include "FigureContext.h"
#include "FigureGallery.h"
#include "FigureMetadata.h"
#include "FigureOptions.h"
#include "FrameChoice.h"
#include "Interruption.h"
#include "OutputFile.h"
#include "ProgressLine.h"

namespace mien {

namespace {

namespace fs = std::filesystem;

struct FigureCommandOptions {
  FaceOptions face;
  FigureOptions figure{"170"};
  std::string id, output, from, format = "svg", frames;
  std::vector<std::string> textures;
  bool all = false, noLabels = false, noCaption = false, list = false;
  const CLI::App* command = nullptr;
};

FigureSettings settingsOf(const FigureCommandOptions& options) {
  FigureSettings settings;
  settings.width = options.figure.width();
  settings.dotsPerInch = options.figure.dotsPerInch();
  settings.theme = *FigureTheme::find(options.figure.theme());
  settings.labelled = !options.noLabels;
  settings.captioned = !options.noCaption;
  settings.hasResolution = options.face.hasResolution();
  settings.textures = options.textures;
  settings.frames = options.frames;
  return settings;
}

/// The command that draws one figure, with the face and figure options of this run that it heeds.
std::string commandFor(const FigureCommandOptions& options, const CatalogueFigure& figure) {
  std::set<std::string> without = {"--output", "--all", "--from", "--format", "--list"};
  if (!figure.heeds.motion)
    without.insert({"--fap", "--frame", "--index", "--time", "--expression", "--viseme", "--set"});
  if (!figure.heeds.table) without.insert({"--fdt", "--fdt-hard"});
  without.insert(figure.ignores.begin(), figure.ignores.end());
  if (!figure.frames) without.insert("--frames");
  if (figure.textures == 0) without.insert("--texture");
  return commandText(*options.command, {figure.id}, without);
}

/// The figures that heed an option, as words.
std::string figuresWith(bool (*heeds)(const CatalogueFigure&)) {
  std::string ids;
  for (const CatalogueFigure& figure : figureCatalogue())
    if (heeds(figure)) ids += (ids.empty() ? "" : ", ") + figure.id;
  return ids;
}

/// What a figure has no use for, and which figures have.
void remarkIgnored(const CatalogueFigure& figure, const std::string& remark, bool (*heeds)(const CatalogueFigure&)) {
  std::cerr << "mien: " << figure.id << " " << remark << "; " << figuresWith(heeds) << " do\n";
}

void requireWidth(const FigureCommandOptions& options, const CatalogueFigure& figure) {
  if (options.figure.width() < figure.leastWidth)
    throw ValueFailure("--width " + shortestText(options.figure.width()) + " mm is too narrow for " + figure.id +
                       ", which needs at least " + shortestText(figure.leastWidth) + " mm");
}

/// What is wrong with the face is told by figures that do not heed it, too.
void requireFace(const FaceState& state) {
  FacePipeline face;
  face.setState(state);
  checkOrThrow(face);
}

/// Says which options this figure has no use for.
void remarkUnused(const FigureCommandOptions& options, const FaceState& state, const CatalogueFigure& figure) {
  FaceState still = FaceMotion::neutralOf(state);
  still.deformation = state.deformation;
  if (still != state && !figure.heeds.motion)
    remarkIgnored(figure, "has motions of its own or none, so that --fap, --expression, --viseme and --set are ignored",
                  [](const CatalogueFigure& f) { return f.heeds.motion; });
  if (!state.deformation.table.empty() && !figure.heeds.table)
    remarkIgnored(figure, "shows no deformation table on the face, so that --fdt is ignored",
                  [](const CatalogueFigure& f) { return f.heeds.table; });
  if (!options.frames.empty() && !figure.frames)
    remarkIgnored(figure, "shows no frames of an animation, so that --frames is ignored",
                  [](const CatalogueFigure& f) { return f.frames; });
  for (const std::string& name : figure.ignores)
    if (options.command->get_option(name)->count() > 0)
      std::cerr << "mien: " << figure.id << " has values of its own in place of " << name << ", which is ignored\n";
  const int textures = static_cast<int>(options.textures.size());
  if (textures > 0 && figure.textures == 0)
    remarkIgnored(figure, "shows no texture, so that --texture is ignored",
                  [](const CatalogueFigure& f) { return f.textures > 0; });
  else if (textures > figure.textures)
    std::cerr << "mien: " << figure.id << " shows " << figure.textures << " of the " << textures << " textures; "
              << figuresWith([](const CatalogueFigure& f) { return f.textures > 1; }) << " shows several\n";
}

/// A figure that is higher than a page is of no use in a paper.
void remarkHeight(const FigureCommandOptions& options, const CatalogueFigure& figure, const QSizeF& size) {
  constexpr double page = 240.0;  // mm
  const int height = static_cast<int>(std::lround(size.height() / figureUnitsPerMillimetre));
  constexpr double widest = 170.0;  // mm, of a page
  const bool wider = options.figure.width() < widest;
  if (height > page)
    std::cerr << "mien: " << figure.id << " is " << height << " mm high at a width of " << options.figure.width()
              << " mm, more than the " << page << " mm of a page; "
              << (wider ? "a larger --width or --no-caption" : "a smaller --width") << " makes it lower\n";
}

/// @return what was drawn
FigureDrawing write(const FigureCommandOptions& options, FigureContext& context, const CatalogueFigure& figure,
                    const std::string& name) {
  const std::string command = commandFor(options, figure);
  context.begin(figure);
  FigureDrawing drawing = figure.draw(context);
  remarkHeight(options, figure, drawing.size);
  options.figure.write(name, drawing.size, drawing.paint, figure.id + ": " + figure.title,
                       command + "\n" + drawing.caption + "\n" + drawing.note + "\n" + writeFaceState(context.state()));
  return drawing;
}

void drawOne(const FigureCommandOptions& options) {
  requireEnding(options.output, {"svg", "pdf", "png"});
  const OutputFile writable(options.output);
  const CatalogueFigure& figure = catalogueFigure(options.id);
  requireWidth(options, figure);
  const FaceState state = options.face.state();
  requireFace(state);
  remarkUnused(options, state, figure);
  const FigureApplication application;
  FigureContext context(state, settingsOf(options));
  write(options, context, figure, options.output);
}

void makeFolder(const std::string& folder) {
  if (folder.empty()) throw ValueFailure("--all needs a folder; give one with -o");
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder, error)) throw FileFailure(folder + ": the folder cannot be made");
  const OutputFile writable((fs::path(folder) / "index.html").string());
}

/// Draws a figure into the folder and adds it to the page.
///
/// @return whether its files allowed that; the reason is said
bool drawInto(const FigureCommandOptions& options, FigureContext& context, const CatalogueFigure& figure,
              FigureGallery& gallery) {
  const std::string file = figure.id + "." + options.format;
  FigureDrawing drawing;
  try {
    requireWidth(options, figure);
  } catch (const ValueFailure& failure) {
    std::cerr << "mien: " << failure.what() << "\n";
    return false;
  }
  try {
    drawing = write(options, context, figure, (fs::path(options.output) / file).string());
  } catch (const FileFailure& failure) {
    std::cerr << "mien: " << figure.id << ": " << failure.what() << "\n";
    return false;
  }
  gallery.add({&figure, file, commandFor(options, figure) + " -o " + file, drawing.caption, drawing.note});
  return true;
}

/// @return how many could not be drawn
int drawEach(const FigureCommandOptions& options, FigureContext& context, FigureGallery& gallery) {
  const int count = static_cast<int>(figureCatalogue().size());
  const bool onTerminal = isatty(STDERR_FILENO) != 0;
  ProgressLine progress(count, "figure");
  int done = 0, failed = 0;
  for (const CatalogueFigure& figure : figureCatalogue()) {
    if (wasInterrupted()) throw Stopped("stopped after " + std::to_string(done) + " figures");
    progress.show(done++);
    if (!drawInto(options, context, figure, gallery))
      ++failed;
    else if (!onTerminal)  // a log has a line for each
      std::cerr << figure.id << " (" << done << " of " << count << ")\n";
  }
  return failed;
}

void drawAll(const FigureCommandOptions& options) {
  makeFolder(options.output);
  const FigureApplication application;
  FigureContext context(options.face.state(), settingsOf(options));
  if (!options.frames.empty()) animationStates(context, 1, 0.0, 1.0);  // refused before anything is drawn
  FigureGallery gallery;
  noteInterruptions();
  const int failed = drawEach(options, context, gallery), count = static_cast<int>(figureCatalogue().size());
  const std::string page = (fs::path(options.output) / "index.html").string();
  OutputFile::write(page, gallery.html());
  std::cout << count - failed << " figures in " << page << "\n";
  if (failed > 0) throw FileFailure(std::to_string(failed) + " of " + std::to_string(count) + " figures are missing");
}

void listFigures() {
  for (const CatalogueFigure& figure : figureCatalogue())
    std::cout << figure.id << "\t" << figure.title << (figure.source.empty() ? "" : " (" + figure.source + ")") << "\n";
}

/// The option that a word names, or nullptr: "--width", "-N".
const CLI::Option* optionNamed(const CLI::App& command, const std::string& word) {
  return word.size() > 1 && word[0] == '-' ? command.get_option_no_throw(word) : nullptr;
}

/// Without the options that were given anew, and with these behind.
std::vector<std::string> withNewOptions(const std::vector<std::string>& words, const CLI::App& command) {
  std::vector<std::string> kept;
  bool replaced = false;
  for (const std::string& word : words) {
    const CLI::Option* const option = optionNamed(command, word);
    if (option) replaced = option->count() > 0;
    if (!replaced) kept.push_back(word);
    if (option && option->get_expected_max() == 0) replaced = false;  // a flag has no value
  }
  const std::vector<std::string> given = commandWords(commandText(command, {}, {"--output", "--from"}));
  kept.insert(kept.end(), given.begin() + 2, given.end());  // behind "mien figure"
  return kept;
}

/// How to draw a figure again that is not one of this command.
std::string otherOrigin(const FigureMetadata& metadata) {
  if (!metadata.command().empty())
    return "was not drawn by mien figure; run its own command again: " + metadata.command();
  return "carries no command of mien figure, but its face: mien COMMAND --state FIGURE takes it, as in mien spectrum "
         "--state FIGURE";
}

/// Runs the command that a figure carries, with another output and the options that were given beside --from.
void drawAgain(const FigureCommandOptions& options) {
  FigureMetadata metadata;
  const std::string fault = metadata.read(options.from);
  if (!fault.empty()) throw FileFailure(fault);
  std::vector<std::string> words = commandWords(metadata.command());
  if (words.size() < 3 || words[1] != "figure") throw FileFailure(options.from + ": " + otherOrigin(metadata));
  words = withNewOptions(words, *options.command);
  words.insert(words.end(), {"-o", options.output});
  CLI::App program;
  addFigureCommand(program);
  std::reverse(words.begin(), words.end());
  words.pop_back();
  try {
    program.parse(words);
  } catch (const FileFailure& failure) {
    const std::string sentence = failure.what();
    if (sentence.rfind(options.output, 0) == 0) throw;
    throw FileFailure(sentence + " (files in the command that " + options.from +
                      " carries are named as they were where it was drawn)");
  }
}

/// Before anything is drawn: an image that is there, and its mesh.
void requireTexture(const std::string& texture) {
  FaceState state;
  setTexture(texture, state);
  if (!fs::exists(state.texture)) throw FileFailure(state.texture + ": there is no such picture");
  const std::string mesh = state.textureMesh.empty() ? meshBeside(state.texture) : state.textureMesh;
  if (!fs::exists(mesh))
    throw FileFailure(mesh + ": there is no such warp mesh; mien texture makes one, to be named as IMAGE:MESH.csv");
}

void run(const FigureCommandOptions& options) {
  options.figure.check();
  if (options.format != "svg" && options.format != "pdf" && options.format != "png")
    throw ValueFailure("--format '" + options.format + "' is none of svg, pdf, png");
  if (options.command->count("--format") > 0 && !options.all)
    throw ValueFailure("--format is for the files of --all; without it the ending of -o tells");
  if (options.list) return listFigures();
  if (options.all + !options.from.empty() + !options.id.empty() > 1)
    throw ValueFailure("give one of an ID, --all and --from FILE");
  for (const std::string& texture : options.textures) requireTexture(texture);
  if (options.all) return drawAll(options);
  if (options.from.empty() && options.id.empty())
    throw ValueFailure("no figure is named; give an ID, --all or --from FILE (--list shows the IDs)");
  if (options.output.empty()) throw ValueFailure("there is nothing to write; give a file with -o");
  if (!options.from.empty()) return drawAgain(options);
  drawOne(options);
}

}  // namespace

void addFigureCommand(CLI::App& program) {
  const auto options = std::make_shared<FigureCommandOptions>();
  CLI::App* command = program.add_subcommand("figure", "Draw a figure of the papers, or all");
  options->command = command;
  command->add_option("figure", options->id, "Which one: pde-1 .., fdt-2 .., mien-sweep ..; --list shows all");
  command->add_flag("--all", options->all, "All of them, with index.html");
  command->add_flag("--list", options->list, "The figures and what they show");
  command->add_option(
      "--from", options->from,
      "Draws the figure of this .svg, .pdf or .png again, with its parameters; options given beside replace its own");
  command->add_option("-o,--output", options->output, "File to write: .svg .pdf .png; a folder for --all");
  command->add_option("--format", options->format, "Of the files of --all: svg, pdf or png; else -o tells it")
      ->capture_default_str();
  options->figure.addTo(*command, "Figure");
  command->add_flag("--no-labels", options->noLabels, "No (a), (b) .. before panels")->group("Figure");
  command
      ->add_flag("--no-caption", options->noCaption,
                 "No title, caption and parameters in the picture; they stay in its metadata")
      ->group("Figure");
  command
      ->add_option("--frames", options->frames,
                   "Frame numbers of figures of an animation, such as 100,120,125 or 100:104")
      ->group("Figure");
  command
      ->add_option("--texture", options->textures,
                   "Image of textured panels, IMAGE or IMAGE:MESH.csv with its warp mesh (else the .csv beside it); "
                   "once for each")
      ->group("Figure");
  options->face.addSurfaceOptions(*command);
  options->face.addAnimationOptions(*command);
  command->footer(
      "Examples:\n"
      "  mien figure pde-1 --width 85 -o curves.pdf\n"
      "  mien figure pde-9 --fap talk.fap --frames 10,20,30,40,50 -o talk.svg\n"
      "  mien figure --all -o figures/\n"
      "  mien figure --from curves.pdf -o curves.png\n"
      "Every file carries its command and the state of its face.");
  command->callback([options] { run(*options); });
}

}  // namespace mien
