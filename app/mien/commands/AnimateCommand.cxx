#include <CLI/CLI.hpp>
#include <memory>

#include "Animation.h"
#include "Arguments.h"
#include "Command.h"

namespace mien {

void addAnimateCommand(CLI::App& program) {
  const auto options = std::make_shared<AnimationOptions>();
  CLI::App* command = program.add_subcommand("animate", "Play an animation into pictures, surfaces or a film");
  command->add_option("file", options->file,
                      "FILE.fap or .csv; - is a .fap stream on standard input [the bundled animation]");
  command->add_option("-o,--output", options->output,
                      "Folder of .png frames, or a file: .pvd .ogv, with ffmpeg .mp4 .webm .gif ..; {frame} in the "
                      "name of a .png .vts .vtp .ply .obj .stl makes one of each frame, by its number in the file");
  command->add_option("--contact-sheet", options->sheet, "Evenly chosen frames side by side, FILE.png");
  command->add_option("--series", options->series,
                      "Surfaces of a .pvd: vts, grids, or vtp, polygons without the slit of the mouth [vts]");
  options->frames.addTo(*command);
  options->picture.addTo(*command);
  options->face.addSurfaceOptions(*command);
  options->face.addMovementOptions(*command);
  options->face.addTextureOptions(*command);
  command->footer(
      "Example: mien animate speech.fap -o frames/ --contact-sheet sheet.png\n"
      "         mien animate speech.fap --scheme tangent --view 45 -o speech.ogv\n"
      "         mien animate speech.fap --start 1.5 --end 4 --fps 60 --loop 3 -o speech.mp4\n"
      "         mien animate speech.fap --fat mine.json --expression joy:0.3 -o speech.pvd\n"
      "         mien animate speech.fap --frames 10,20,30 -o 'speech-{frame}.png'\n"
      "         capture | mien animate - -o frames/\n"
      "Files in a folder are counted from 0000 whatever the numbers of the frames. Ctrl-C stops between two frames and "
      "leaves finished files only; a live film is closed with what has come, unless a second Ctrl-C leaves out\n"
      "what is not drawn yet.");
  command->callback([options] {
    options->check();
    Animation(*options).run();
  });
}

}  // namespace mien
