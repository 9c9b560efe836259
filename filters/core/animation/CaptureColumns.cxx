#include "CaptureColumns.h"

#include <algorithm>
#include <cctype>

#include "ActionUnitName.h"

namespace mien {

namespace {

std::string inSmallLetters(std::string_view text) {
  std::string small(text);
  for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return small;
}

/// What is beside the face: time, quality. @return whether the column is of that sort
bool bindFrame(std::string_view name, std::size_t column, CaptureColumns& columns) {
  const std::string small = inSmallLetters(name);
  if (small == "frame")
    columns.frame = column;
  else if (small == "time" || small == "timestamp" || small == "seconds")
    columns.time = column;
  else if (small == "timecode")
    columns.timeCode = column;
  else if (small == "success")
    columns.success = column;
  else if (small == "face_id" || small == "face")
    columns.face = column;
  else if (small == "blendshapecount")
    columns.shapeCount = column;
  else
    return small == "confidence";
  return true;
}

bool bindRotation(std::string_view name, std::size_t column, const FacialActionMap& map, CaptureColumns& columns) {
  const CaptureAction* rotation = findAction(map.rotations, name);
  if (!rotation) return false;
  if (!rotation->writtenOnly) columns.effects.push_back({column, rotation->faps, 1.0, true});
  return true;
}

bool bindBlendshape(std::string_view name, std::size_t column, const FacialActionMap& map, CaptureColumns& columns) {
  const std::size_t dot = name.rfind('.');
  const CaptureAction* shape = findAction(map.blendshapes, dot == name.npos ? name : name.substr(dot + 1));
  if (!shape) return false;
  columns.effects.push_back({column, shape->faps, 0.0, false});
  return true;
}

bool hasSmallLeft(const std::vector<std::string_view>& header) {
  return std::any_of(header.begin(), header.end(), [](std::string_view name) {
    return name.size() > 2 && name.substr(name.size() - 2) == "_l" && parseActionUnitName(name, true);
  });
}

class ActionUnitBinder {
 public:
  ActionUnitBinder(const std::vector<std::string_view>& header, const FacialActionMap& map)
      : header_(header), map_(map), sidesAreSmall_(hasSmallLeft(header)) {}

  bool bind(std::size_t column, CaptureColumns& columns) const {
    const auto name = parseActionUnitName(header_[column], sidesAreSmall_);
    if (!name) return false;
    if (name->kind == ActionUnitName::Kind::Presence && hasIntensity(name->unit)) return true;
    const CaptureAction* action = findAction(map_.actionUnits, "AU" + std::to_string(name->unit));
    if (!action) return false;
    using Side = ActionUnitName::Side;
    const auto faps = name->side == Side::Both ? action->faps : sideOf(*action, name->side == Side::Left).faps;
    columns.effects.push_back({column, faps, fullStrength(name->kind), false});
    return true;
  }

 private:
  static double fullStrength(ActionUnitName::Kind kind) {
    if (kind == ActionUnitName::Kind::Intensity) return 5.0;
    return kind == ActionUnitName::Kind::Presence ? 1.0 : 0.0;
  }

  bool hasIntensity(int unit) const {
    return std::any_of(header_.begin(), header_.end(), [&](std::string_view other) {
      const auto name = parseActionUnitName(other, sidesAreSmall_);
      return name && name->unit == unit && name->kind == ActionUnitName::Kind::Intensity;
    });
  }

  const std::vector<std::string_view>& header_;
  const FacialActionMap& map_;
  bool sidesAreSmall_;
};

template <typename Bind>
CaptureColumns bindAll(const std::vector<std::string_view>& header, const FacialActionMap& map, Bind&& bindAction) {
  CaptureColumns columns;
  for (std::size_t column = 0; column < header.size(); ++column) {
    const bool isAction = bindAction(column, columns);
    columns.actions += isAction;
    if (!isAction && !bindFrame(header[column], column, columns) && !bindRotation(header[column], column, map, columns))
      columns.unused.emplace_back(header[column]);
  }
  return columns;
}

}  // namespace

CaptureColumns CaptureColumns::ofActionUnits(const std::vector<std::string_view>& header, const FacialActionMap& map) {
  const ActionUnitBinder binder(header, map);
  return bindAll(header, map,
                 [&](std::size_t column, CaptureColumns& columns) { return binder.bind(column, columns); });
}

CaptureColumns CaptureColumns::ofBlendshapes(const std::vector<std::string_view>& header, const FacialActionMap& map) {
  return bindAll(header, map, [&](std::size_t column, CaptureColumns& columns) {
    return bindBlendshape(header[column], column, map, columns);
  });
}

}  // namespace mien
