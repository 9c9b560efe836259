#include "AnimationInfo.h"

#include <iostream>

#include "CsvText.h"
#include "FAPSequence.h"
#include "FAPTable.h"
#include "Failure.h"
#include "InfoText.h"
#include "PipelineErrors.h"
#include "vtkFAPReader.h"
#include "vtkNew.h"

namespace mien {

using json = nlohmann::ordered_json;

json describeAnimation(const std::string& file) {
  vtkNew<vtkFAPReader> reader;
  PipelineErrors errors;
  errors.observe(reader);
  reader->SetFileName(file.c_str());
  reader->UpdateInformation();
  if (!errors.first().empty()) throw FileFailure(errors.first());
  const FAPSequence& sequence = reader->GetSequence();
  json description;
  description["file"] = file;
  description["format"] = reader->GetFormat();
  description["version"] = sequence.version;
  description["name"] = sequence.name;
  description["fps"] = sequence.framesPerSecond;
  description["frames"] = sequence.frames.size();
  description["duration"] = sequence.duration();
  if (!sequence.frames.empty()) {
    description["first_frame"] = sequence.frames.front().number;
    description["last_frame"] = sequence.frames.back().number;
  }
  description["faps_used"] = sequence.fapsUsed();
  description["faps_without_surface"] = fapsWithoutSurface(sequence.fapsMoved());
  description["warnings"] = reader->GetWarnings();
  return description;
}

namespace {

std::string textOf(const json& value) {
  if (value.is_string()) return value;
  return value.is_number_float() ? shortestText(value) : value.dump();
}

}  // namespace

void printAnimation(const json& animation) {
  const auto text = [&](const char* key) { return textOf(animation[key]); };
  printLine("animation", text("file"));
  printLine("format", text("format"));
  printLine("version", text("version").empty() ? "none given" : text("version"));
  printLine("name", text("name").empty() ? "none given" : text("name"));
  printLine("frames", text("frames") + " at " + text("fps") + " per second, the last at " +
                          twoDigits(animation["duration"]) + " s");
  if (animation.contains("first_frame")) printLine("frame numbers", text("first_frame") + " .. " + text("last_frame"));
  printLine("FAPs used", joined(animation["faps_used"]));
  printLine("without surface", joined(animation["faps_without_surface"]));
  for (const auto& warning : animation["warnings"]) printLine("warning", warning);
}

}  // namespace mien
