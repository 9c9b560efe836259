#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "Arguments.h"
#include "Command.h"
#include "CommandText.h"
#include "FaceNote.h"
#include "FaceOptions.h"
#include "FaceStateText.h"
#include "FaceTexture.h"
#include "Failure.h"
#include "FigureApplication.h"
#include "FigureCatalogue.h"
#include "FigureContext.h"
#include "FigureGallery.h"
#include "FigureMetadata.h"
#include "FigureOptions.h"
#include "Interruption.h"
#include "OutputFile.h"
#include "ProgressLine.h"

namespace mien {

namespace {

namespace fs = std::filesystem;

struct Options {
  FaceOptions face;
  FigureOptions figure{"170"};
  std::string id, output, from, format = "svg", frames;
  std::vector<std::string> textures;
  bool all = false, noLabels = false, list = false;
  const CLI::App* command = nullptr;
};

FigureSettings settingsOf(const Options& options) {
  FigureSettings settings;
  settings.width = options.figure.width();
  settings.dotsPerInch = options.figure.dotsPerInch();
  settings.theme = *FigureTheme::find(options.figure.theme());
  settings.labelled = !options.noLabels;
  settings.textures = options.textures;
  settings.frames = options.frames;
  return settings;
}

/// The command that draws one figure, with the face and figure options of this run.
std::string commandFor(const Options& options, const std::string& id) {
  return commandText(*options.command, {id}, {"--output", "--all", "--from", "--format", "--list"});
}

void write(const Options& options, FigureContext& context, const CatalogueFigure& figure, const std::string& name,
           const std::string& command) {
  const FigureDrawing drawing = figure.draw(context);
  options.figure.write(name, drawing.size, drawing.paint, figure.id + ": " + figure.title,
                       command + "\n" + faceNote(context.state(), {context.state().surface.scheme}) + "\n" +
                           writeFaceState(context.state()));
}

void drawOne(const Options& options) {
  requireEnding(options.output, {"svg", "pdf", "png"});
  const OutputFile writable(options.output);
  const CatalogueFigure& figure = catalogueFigure(options.id);
  const FigureApplication application;
  FigureContext context(options.face.state(), settingsOf(options));
  write(options, context, figure, options.output, commandFor(options, options.id));
}

void drawAll(const Options& options) {
  if (options.output.empty()) throw ValueFailure("--all needs a folder; give one with -o");
  std::error_code error;
  fs::create_directories(options.output, error);
  if (!fs::is_directory(options.output, error)) throw FileFailure(options.output + ": the folder cannot be made");
  const FigureApplication application;
  FigureContext context(options.face.state(), settingsOf(options));
  FigureGallery gallery;
  noteInterruptions();
  {
    ProgressLine progress(static_cast<int>(figureCatalogue().size()), "figure");
    int done = 0;
    for (const CatalogueFigure& figure : figureCatalogue()) {
      if (wasInterrupted()) throw Stopped("stopped after " + std::to_string(done) + " figures");
      progress.show(done++);
      const std::string file = figure.id + "." + options.format;
      const std::string command = commandFor(options, figure.id);
      write(options, context, figure, (fs::path(options.output) / file).string(), command);
      gallery.add(
          {&figure, file, command + " -o " + file, faceNote(context.state(), {context.state().surface.scheme})});
    }
  }
  const std::string page = (fs::path(options.output) / "index.html").string();
  OutputFile::write(page, gallery.html());
  std::cout << figureCatalogue().size() << " figures in " << page << "\n";
}

void listFigures() {
  for (const CatalogueFigure& figure : figureCatalogue())
    std::cout << figure.id << "\t" << figure.title << (figure.source.empty() ? "" : " (" + figure.source + ")") << "\n";
}

/// Runs the command that a figure carries, with another output.
void drawAgain(const Options& options) {
  FigureMetadata metadata;
  const std::string fault = metadata.read(options.from);
  if (!fault.empty()) throw FileFailure(fault);
  std::vector<std::string> words = commandWords(metadata.description.substr(0, metadata.description.find('\n')));
  if (words.size() < 3 || words[0] != "mien" || words[1] != "figure")
    throw FileFailure(options.from + ": was not drawn by mien figure, but by: " + metadata.description);
  words.insert(words.end(), {"-o", options.output});
  CLI::App program;
  addFigureCommand(program);
  std::reverse(words.begin(), words.end());
  words.pop_back();
  program.parse(words);
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

void run(const Options& options) {
  options.figure.check();
  if (options.format != "svg" && options.format != "pdf" && options.format != "png")
    throw ValueFailure("--format '" + options.format + "' is none of svg, pdf, png");
  if (options.list) return listFigures();
  if (options.all + !options.from.empty() + !options.id.empty() > 1)
    throw ValueFailure("give one of an ID, --all and --from FILE");
  for (const std::string& texture : options.textures) requireTexture(texture);
  if (options.all) return drawAll(options);
  if (options.output.empty()) throw ValueFailure("there is nothing to write; give a file with -o");
  if (!options.from.empty()) return drawAgain(options);
  if (options.id.empty())
    throw ValueFailure("no figure is named; give an ID, --all or --from FILE (--list shows the IDs)");
  drawOne(options);
}

}  // namespace

void addFigureCommand(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("figure", "Draw a figure of the papers, or all");
  options->command = command;
  command->add_option("figure", options->id, "Which one: pde-1 .., fdt-2 .., mien-sweep ..; --list shows all");
  command->add_flag("--all", options->all, "All of them, with index.html");
  command->add_flag("--list", options->list, "The figures and what they show");
  command->add_option("--from", options->from,
                      "Draws the figure of this .svg, .pdf or .png again, with its parameters");
  command->add_option("-o,--output", options->output, "File to write: .svg .pdf .png; a folder for --all");
  command->add_option("--format", options->format, "Of --all: svg, pdf or png")->capture_default_str();
  options->figure.addTo(*command, "Figure");
  command->add_flag("--no-labels", options->noLabels, "No (a), (b) .. before panels")->group("Figure");
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
