#include "FaceStateText.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "FaceLayout.h"

namespace mien {

namespace {

using json = nlohmann::json;
using Choice = FaceState::FrameChoice;

constexpr const char* versionKey = "mien_face_state";
constexpr std::array<std::pair<Choice, const char*>, 3> frameKeys = {
    {{Choice::Number, "frame"}, {Choice::Index, "index"}, {Choice::Time, "time"}}};

/// Reads the members of one JSON object by name, each of the type wanted, and tells which were never asked for.
class Members {
 public:
  Members(const json& object, std::string path, std::string& fault)
      : object_(object), path_(std::move(path)), fault_(fault) {
    if (!object.is_object()) fail("", "is no object");
  }

  const json* find(const char* key) {
    known_.insert(key);
    return object_.is_object() && object_.contains(key) ? &object_[key] : nullptr;
  }

  void read(const char* key, std::string& value) {
    if (const json* found = find(key)) found->is_string() ? void(value = *found) : fail(key, "is no text");
  }
  void read(const char* key, bool& value) {
    if (const json* found = find(key))
      found->is_boolean() ? void(value = *found) : fail(key, "is neither true nor false");
  }
  void read(const char* key, double& value) {
    if (const json* found = find(key))
      found->is_number() ? void(value = found->get<double>()) : fail(key, "is no number");
  }
  void read(const char* key, int& value) {
    const json* found = find(key);
    if (!found) return;
    const bool fits = found->is_number_integer() && found->get<double>() >= std::numeric_limits<int>::min() &&
                      found->get<double>() <= std::numeric_limits<int>::max();
    fits ? void(value = found->get<int>()) : fail(key, "is no whole number of usual size");
  }

  /// Call when all members were read.
  void refuseOthers() {
    if (!object_.is_object()) return;
    for (const auto& item : object_.items())
      if (known_.count(item.key()) == 0) fail(item.key(), "is not known to this version");
  }

  void fail(const std::string& key, const std::string& what) {
    const std::string dot = path_.empty() || key.empty() ? "" : ".";
    if (fault_.empty()) fault_ = "face state: '" + path_ + dot + key + "' " + what;
  }

 private:
  const json& object_;
  std::string path_;
  std::string& fault_;
  std::set<std::string> known_;
};

void readSmoothing(Members& members, FaceState& state) {
  const json* a = members.find("a");
  if (!a) return;
  auto& smoothing = state.surface.smoothing;
  if (!a->is_array() || a->size() != smoothing.size()) return members.fail("a", "is no list of nine numbers");
  for (size_t patch = 0; patch < smoothing.size(); ++patch)
    (*a)[patch].is_number() ? void(smoothing[patch] = (*a)[patch].get<double>())
                            : members.fail("a", "is no list of nine numbers");
}

void readSurface(const json& object, FaceState& state, std::string& fault) {
  Members members(object, "surface", fault);
  members.read("scheme", state.surface.scheme);
  readSmoothing(members, state);
  members.read("harmonics", state.surface.modes);
  members.read("remainder", state.surface.remainder);
  members.read("derivative_strength", state.surface.derivativeStrength);
  members.refuseOthers();
}

void readGrid(const json& object, FaceState& state, std::string& fault) {
  Members members(object, "grid", fault);
  std::string precision = state.doublePrecision ? "double" : "single";
  members.read("rows", state.rows);
  members.read("columns", state.columns);
  members.read("uniform_rows", state.uniformRows);
  members.read("precision", precision);
  if (precision != "single" && precision != "double") members.fail("precision", "is neither single nor double");
  state.doublePrecision = precision == "double";
  members.refuseOthers();
}

void readAnimation(const json& object, FaceState& state, std::string& fault) {
  Members members(object, "animation", fault);
  members.read("file", state.fapFile);
  members.read("interpolate", state.interpolateFrames);
  int choices = 0;
  for (const auto& [choice, key] : frameKeys)
    if (members.find(key)) {
      members.read(key, state.frame);
      state.frameChoice = choice;
      ++choices;
    }
  if (choices > 1) members.fail("", "has more than one of frame, index and time");
  members.refuseOthers();
}

void readShapes(const json& object, const char* section, std::map<std::string, double>& shapes, std::string& fault) {
  Members members(object, section, fault);
  if (!object.is_object()) return;
  for (const auto& item : object.items()) members.read(item.key().c_str(), shapes[item.key()]);
}

void readExpressions(const json& object, FaceState& state, std::string& fault) {
  readShapes(object, "expressions", state.expressions, fault);
}

void readVisemes(const json& object, FaceState& state, std::string& fault) {
  readShapes(object, "visemes", state.visemes, fault);
}

void readDeformation(const json& object, FaceState& state, std::string& fault) {
  Members members(object, "deformation", fault);
  members.read("table", state.deformation.table);
  members.read("strength", state.deformation.strength);
  members.read("smooth", state.deformation.smooth);
  members.refuseOthers();
}

void readTexture(const json& object, FaceState& state, std::string& fault) {
  Members members(object, "texture", fault);
  members.read("image", state.texture);
  members.read("mesh", state.textureMesh);
  members.refuseOthers();
}

void readMove(Members& members, CurveEdit& edit) {
  const json* move = members.find("move");
  if (!move) return;
  const auto isNumber = [](const json& value) { return value.is_number(); };
  if (!move->is_array() || move->size() != 3 || !std::all_of(move->begin(), move->end(), isNumber))
    return members.fail("move", "is no list of three numbers");
  for (int i = 0; i < 3; ++i) edit.move[i] = (*move)[i].get<double>();
}

CurveEdit readEdit(const json& object, const std::string& path, std::string& fault) {
  Members members(object, path, fault);
  CurveEdit edit;
  std::string curve;
  members.read("curve", curve);
  edit.curve = FaceLayout::curveIndex(curve);
  if (edit.curve < 0) members.fail("curve", "is no curve; they are C1 .. C28 and C22'");
  members.read("v", edit.v);
  readMove(members, edit);
  members.read("width", edit.width);
  members.read("spread", edit.spread);
  members.read("mirrored", edit.mirrored);
  members.refuseOthers();
  return edit;
}

void readEdits(const json& list, FaceState& state, std::string& fault) {
  if (!list.is_array()) {
    if (fault.empty()) fault = "face state: 'edits' is no list";
    return;
  }
  for (size_t i = 0; i < list.size() && fault.empty(); ++i)
    state.edits.push_back(readEdit(list[i], "edits[" + std::to_string(i) + "]", fault));
}

void readFAPValues(const json& object, FaceState& state, std::string& fault) {
  Members members(object, "fap_values", fault);
  if (!object.is_object()) return;
  for (const auto& item : object.items()) {
    const std::string& key = item.key();
    int fap = 0;
    const auto parsed = std::from_chars(key.data(), key.data() + key.size(), fap);
    if (parsed.ec != std::errc() || parsed.ptr != key.data() + key.size())
      members.fail(key, "is no FAP number");
    else
      members.read(key.c_str(), state.fapValues[fap]);
  }
}

void readVersion(Members& members) {
  const json* version = members.find(versionKey);
  if (!version) return members.fail(versionKey, "is missing; this is no face state");
  if (*version != faceStateVersion)
    members.fail(versionKey,
                 "is " + version->dump() + "; this program reads version " + std::to_string(faceStateVersion));
}

void readAll(const json& object, FaceState& state, std::string& fault) {
  Members members(object, "", fault);
  readVersion(members);
  if (!fault.empty()) return;
  members.read("curves", state.curvesFile);
  members.read("animation_table", state.animationTable);
  using Section = void (*)(const json&, FaceState&, std::string&);
  const std::pair<const char*, Section> sections[] = {
      {"edits", readEdits},          {"surface", readSurface},         {"grid", readGrid},
      {"animation", readAnimation},  {"expressions", readExpressions}, {"visemes", readVisemes},
      {"fap_values", readFAPValues}, {"deformation", readDeformation}, {"texture", readTexture}};
  for (const auto& [key, read] : sections)
    if (const json* section = members.find(key)) read(*section, state, fault);
  members.refuseOthers();
}

const char* keyOf(Choice choice) {
  for (const auto& [known, key] : frameKeys)
    if (known == choice) return key;
  return "index";
}

json fapValues(const FaceState& state) {
  json values = json::object();
  for (const auto& [fap, value] : state.fapValues) values[std::to_string(fap)] = value;
  return values;
}

json editsOf(const FaceState& state) {
  json list = json::array();
  for (const CurveEdit& edit : state.edits)
    list.push_back({{"curve", FaceLayout::curveName(edit.curve)},
                    {"v", edit.v},
                    {"move", {edit.move.x(), edit.move.y(), edit.move.z()}},
                    {"width", edit.width},
                    {"spread", edit.spread},
                    {"mirrored", edit.mirrored}});
  return list;
}

}  // namespace

std::string writeFaceState(const FaceState& state) {
  json object;
  object[versionKey] = faceStateVersion;
  if (!state.curvesFile.empty()) object["curves"] = state.curvesFile;
  if (!state.edits.empty()) object["edits"] = editsOf(state);
  object["surface"] = {{"scheme", state.surface.scheme},
                       {"a", state.surface.smoothing},
                       {"harmonics", state.surface.modes},
                       {"remainder", state.surface.remainder},
                       {"derivative_strength", state.surface.derivativeStrength}};
  object["grid"] = {{"rows", state.rows},
                    {"columns", state.columns},
                    {"uniform_rows", state.uniformRows},
                    {"precision", state.doublePrecision ? "double" : "single"}};
  if (!state.fapFile.empty())
    object["animation"] = {
        {"file", state.fapFile}, {keyOf(state.frameChoice), state.frame}, {"interpolate", state.interpolateFrames}};
  if (!state.fapValues.empty()) object["fap_values"] = fapValues(state);
  if (!state.animationTable.empty()) object["animation_table"] = state.animationTable;
  if (!state.expressions.empty()) object["expressions"] = state.expressions;
  if (!state.visemes.empty()) object["visemes"] = state.visemes;
  if (!(state.deformation == FaceDeformation()))
    object["deformation"] = {{"table", state.deformation.table},
                             {"strength", state.deformation.strength},
                             {"smooth", state.deformation.smooth}};
  if (!state.texture.empty()) object["texture"]["image"] = state.texture;
  if (!state.textureMesh.empty()) object["texture"]["mesh"] = state.textureMesh;
  // Names of files may hold any bytes; what is no UTF-8 is replaced rather than thrown at.
  return object.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

std::string readFaceState(const std::string& text, FaceState& state) {
  const json object = json::parse(text, nullptr, false);
  if (object.is_discarded()) return "face state: this is no valid JSON";
  FaceState read;
  std::string fault;
  readAll(object, read, fault);
  if (fault.empty()) state = std::move(read);
  return fault;
}

}  // namespace mien
