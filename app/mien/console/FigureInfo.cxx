#include "FigureInfo.h"

#include "Failure.h"
#include "FigureMetadata.h"
#include "FigureOptions.h"
#include "InfoText.h"
#include "OutputFile.h"

namespace mien {

using json = nlohmann::ordered_json;

json describeFigureFile(const std::string& file) {
  if (!FigureOptions::isFigure(file)) return nullptr;
  FigureMetadata figure;
  const std::string fault = figure.read(file);
  if (!fault.empty() && fileEnding(file) == "png") return nullptr;  // a photograph
  if (!fault.empty()) throw FileFailure(fault);
  json about = {{"file", file}, {"title", figure.title}, {"command", figure.command()}};
  about["state"] = json::parse(figure.state(), nullptr, false);
  if (about["state"].is_discarded()) about["state"] = nullptr;
  return about;
}

void printFigureFile(const json& about) {
  printLine("figure", about["file"]);
  if (about["title"] != "") printLine("title", about["title"]);
  if (about["command"] != "") printLine("drawn by", about["command"]);
  printLine("state", about["state"].is_null() ? "none" : "of its face; --state FILE in every command with a face");
}

}  // namespace mien
