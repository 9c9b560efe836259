#include "CompactFaceOutput.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "Arguments.h"
#include "CompactFace.h"
#include "CsvText.h"
#include "Failure.h"
#include "OutputFile.h"
#include "PipelineErrors.h"
#include "vtkCompactFaceWriter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace mien {

void CompactFaceOutput::addTo(CLI::App& command) {
  command_ = &command;
  command.add_option("--tolerance", tolerance_, "Of .mienz: RMS distance of its points to these, at most")
      ->capture_default_str()
      ->group("Compact face");
  command.add_option("--name", faceName_, "Of .mienz: what the face is called")->group("Compact face");
}

double CompactFaceOutput::tolerance() const {
  return parseMillimetres("--tolerance", tolerance_);
}

void CompactFaceOutput::check(const std::string& fileName) const {
  for (const char* option : {"--tolerance", "--name"})
    if (command_->count(option) > 0 && fileEnding(fileName) != "mienz")
      throw ValueFailure(std::string(option) + " is for .mienz, which " + fileName + " is not");
  using Limits = CompactFaceLimits;
  if (!(tolerance() >= Limits::finest && tolerance() <= Limits::coarsest))
    throw ValueFailure("--tolerance '" + tolerance_ + "' is not allowed; give " + shortestText(Limits::finest) +
                       "mm to " + shortestText(Limits::coarsest) + "mm");
  if (faceName_.size() > Limits::longestName)
    throw ValueFailure("--name is longer than " + std::to_string(Limits::longestName) + " bytes; shorten it");
}

void CompactFaceOutput::write(vtkPolyData* curves, const std::string& fileName) const {
  OutputFile file(fileName);
  vtkNew<vtkCompactFaceWriter> writer;
  PipelineErrors errors;
  errors.observe(writer);
  writer->SetInputDataObject(curves);
  writer->SetFileName(file.temporaryName().c_str());
  writer->SetTolerance(tolerance());
  writer->SetFaceName(faceName_);
  writer->Write();
  if (!errors.first().empty()) throw FileFailure(fileName + ": " + errors.first());
  file.commit();
  for (const std::string& warning : errors.warnings()) std::cerr << "mien: " << fileName << ": " << warning << "\n";
}

}  // namespace mien
