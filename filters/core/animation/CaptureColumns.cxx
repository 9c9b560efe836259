#include "CaptureColumns.h"

#include <algorithm>

#include "ActionUnitName.h"
#include "NumberText.h"
#include "SmallLetters.h"

namespace mien {

namespace {

std::string nameOf(const std::vector<std::string_view>& header, std::size_t column) {
  return "column " + std::to_string(column + 1) + " (" + inQuotes(header[column]) + ")";
}

/// The columns found so far, by what they mean: two of one meaning would count twice.
class Binding {
 public:
  explicit Binding(const std::vector<std::string_view>& header) : header_(header) {}

  /// @param side "" for both sides, which neither "left" nor "right" may join
  void claim(const std::string& action, const std::string& side, std::size_t column) {
    for (const Claim& other : claims_)
      if (columns.fault.empty() && other.action == action && (other.side == side || other.side.empty() || side.empty()))
        columns.fault =
            nameOf(header_, column) + " moves what " + nameOf(header_, other.column) + " moves; remove one of them";
    claims_.push_back({action, side, column});
  }

  void set(std::optional<std::size_t>& place, std::size_t column) {
    if (place && columns.fault.empty())
      columns.fault =
          nameOf(header_, column) + " says again what " + nameOf(header_, *place) + " says; remove one of them";
    place = column;
  }

  CaptureColumns columns;

 private:
  struct Claim {
    std::string action, side;
    std::size_t column;
  };
  const std::vector<std::string_view>& header_;
  std::vector<Claim> claims_;
};

/// What is beside the face: time, quality. @return whether the column is of that sort
bool bindFrame(std::string_view name, std::size_t column, Binding& binding) {
  CaptureColumns& columns = binding.columns;
  const std::string small = inSmallLetters(name);
  if (small == "frame")
    binding.set(columns.frame, column);
  else if (small == "time" || small == "timestamp" || small == "seconds")
    binding.set(columns.time, column);
  else if (small == "timecode")
    binding.set(columns.timeCode, column);
  else if (small == "success")
    binding.set(columns.success, column);
  else if (small == "face_id" || small == "face")
    binding.set(columns.face, column);
  else if (small == "blendshapecount")
    binding.set(columns.shapeCount, column);
  else
    return small == "confidence";
  return true;
}

bool bindRotation(std::string_view name, std::size_t column, const FacialActionMap& map, Binding& binding) {
  const CaptureAction* rotation = findAction(map.rotations, name);
  if (!rotation) return false;
  binding.claim(rotation->name, "", column);
  if (!rotation->writtenOnly)
    binding.columns.effects.push_back({column, rotation->faps, 1.0, true, rotation->standsIn});
  return true;
}

bool bindBlendshape(std::string_view name, std::size_t column, const FacialActionMap& map, Binding& binding) {
  const std::size_t dot = name.rfind('.');
  const CaptureAction* shape = findAction(map.blendshapes, dot == name.npos ? name : name.substr(dot + 1));
  if (!shape) return false;
  binding.claim(shape->name, "", column);
  binding.columns.effects.push_back({column, shape->faps, 0.0, false, false});
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

  bool bind(std::size_t column, Binding& binding) const {
    const auto name = parseActionUnitName(header_[column], sidesAreSmall_);
    if (!name) return false;
    if (name->kind == ActionUnitName::Kind::Presence && hasIntensity(name->unit)) return true;
    const CaptureAction* action = findAction(map_.actionUnits, "AU" + std::to_string(name->unit));
    if (!action) return false;
    using Side = ActionUnitName::Side;
    const bool whole = name->side == Side::Both, left = name->side == Side::Left;
    binding.claim(action->name, whole ? "" : left ? "left" : "right", column);
    const auto faps = whole ? action->faps : sideOf(*action, left).faps;
    binding.columns.effects.push_back({column, faps, fullStrength(name->kind), false, false});
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
  Binding binding(header);
  for (std::size_t column = 0; column < header.size(); ++column) {
    const bool isAction = bindAction(column, binding);
    binding.columns.actions += isAction;
    if (!isAction && !bindFrame(header[column], column, binding) && !bindRotation(header[column], column, map, binding))
      binding.columns.unused.emplace_back(header[column]);
  }
  return binding.columns;
}

}  // namespace

CaptureColumns CaptureColumns::ofActionUnits(const std::vector<std::string_view>& header, const FacialActionMap& map) {
  const ActionUnitBinder binder(header, map);
  return bindAll(header, map, [&](std::size_t column, Binding& binding) { return binder.bind(column, binding); });
}

CaptureColumns CaptureColumns::ofBlendshapes(const std::vector<std::string_view>& header, const FacialActionMap& map) {
  return bindAll(header, map, [&](std::size_t column, Binding& binding) {
    return bindBlendshape(header[column], column, map, binding);
  });
}

}  // namespace mien
