#include "JsonInfo.h"

#include <algorithm>
#include <iterator>

#include "Failure.h"
#include "InfoText.h"
#include "OutputFile.h"
#include "TextFileReader.h"

namespace mien {

namespace {

using json = nlohmann::ordered_json;

constexpr std::size_t largestJson = 10'000'000;  // bytes

/// How a kind of file is told, and what takes it.
struct JsonKind {
  const char* member;   ///< that says so
  const char* format;   ///< what it holds, where the version has a member of its own
  const char* version;  ///< the member with the version
  const char* kind;
  const char* use;  ///< FILE stands for its name
};

constexpr JsonKind jsonKinds[] = {
    {"format", "mien session", "version", "session", "mien-studio FILE; --state FILE in every command with a face"},
    {"format", "mien animation table", "version", "animation table", "mien fat check FILE; --fat FILE"},
    {"format", "mien facial action map", "version", "map of facial actions", "mien convert --map FILE"},
    {"format", "mien expressions", "version", "expressions", ""},
    {"format", "mien visemes", "version", "visemes", ""},
    {"mien_face_state", nullptr, "mien_face_state", "state of a face", "--state FILE in every command with a face"},
    {"mien_study", nullptr, "mien_study", "study", "mien ensemble FILE -o table.csv"},
    {"regions", nullptr, "version", "map of facial regions", "mien fdt, --regions FILE"},
};

const JsonKind* kindOf(const json& root) {
  const auto found = std::find_if(std::begin(jsonKinds), std::end(jsonKinds), [&](const JsonKind& kind) {
    const bool isNamed = kind.format ? root.value("format", json()) == kind.format : !root.contains("format");
    return root.contains(kind.member) && isNamed;
  });
  return found == std::end(jsonKinds) ? nullptr : found;
}

json parse(const std::string& file) {
  std::string text;
  const std::string fault = readTextFile(file, largestJson, text, "file");
  if (!fault.empty()) throw FileFailure(file + ":" + fault);
  json root = json::parse(text, nullptr, false);
  if (root.is_discarded()) throw FileFailure(file + ": this is no JSON (cut off?); write it again");
  return root;
}

}  // namespace

json describeJsonFile(const std::string& file) {
  if (fileEnding(file) != "json") return nullptr;
  const json root = parse(file);
  const JsonKind* kind = root.is_object() ? kindOf(root) : nullptr;
  if (!kind)
    throw FileFailure(
        file +
        ": this JSON is no file of Mien's; it has no 'format', 'mien_study', 'mien_face_state' or 'regions' "
        "that is known");
  return {{"kind", kind->kind}, {"file", file}, {"version", root.value(kind->version, json())}, {"use", kind->use}};
}

void printJsonFile(const json& about) {
  printLine("file", about["file"]);
  printLine("kind", about["kind"]);
  printLine("version", about["version"].dump());
  if (about["use"] != "") printLine("for", about["use"]);
}

}  // namespace mien
