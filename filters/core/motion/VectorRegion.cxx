#include "VectorRegion.h"

#include <algorithm>
#include <vector>

#include "FaceLayout.h"
#include "NumberText.h"

namespace mien {

namespace {

struct NamedRegion {
  const char* name;
  std::vector<const char*> features;  ///< MPEG-4 feature points around which it lies
  double margin;                      ///< mm around them
};

// The margins take in the skin that a feature's own FAPs move visibly.
const std::vector<NamedRegion>& namedRegions() {
  static const std::vector<NamedRegion> regions = {
      {"mouth", {"8.1", "8.2", "8.3", "8.4"}, 10.0},
      {"eyes", {"3.1", "3.2", "3.3", "3.4", "3.7", "3.8", "3.11", "3.12"}, 10.0},
      {"brows", {"4.1", "4.2", "4.3", "4.4", "4.5", "4.6"}, 12.0},
      {"nose", {"9.1", "9.2", "9.3", "9.15", "9.12"}, 8.0},
      {"cheeks", {"5.1", "5.2", "5.3", "5.4"}, 15.0},
      {"chin", {"2.1", "2.10"}, 18.0}};
  return regions;
}

std::string parsePatch(const std::string& text, std::optional<int>& patch) {
  const bool known = text.size() == 2 && text[1] >= '0' && text[1] < '0' + FaceLayout::patchCount;
  if (known) patch = text[1] - '0';
  return known ? "" : "region '" + text + "' is no patch; patches are P0 .. P8";
}

std::string parseRectangle(const std::string& text, std::optional<Eigen::AlignedBox2d>& rectangle) {
  std::vector<double> numbers;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = std::min(text.find(',', begin), text.size());
    const auto number = parseNumber(std::string_view(text).substr(begin, end - begin));
    if (!number) return "region '" + text + "' is no rectangle; write XMIN,YMIN,XMAX,YMAX in mm";
    numbers.push_back(*number);
    begin = end + 1;
  }
  if (numbers.size() != 4 || !(numbers[0] < numbers[2]) || !(numbers[1] < numbers[3]))
    return "region '" + text + "' is no rectangle; write XMIN,YMIN,XMAX,YMAX in mm, the smaller number first";
  rectangle.emplace(Eigen::Vector2d(numbers[0], numbers[1]), Eigen::Vector2d(numbers[2], numbers[3]));
  return {};
}

std::string findBox(const NamedRegion& region, const FaceCurves* face, std::optional<Eigen::AlignedBox3d>& box) {
  Eigen::AlignedBox3d found;
  for (const char* const id : region.features) {
    const FeaturePoint* const feature = face ? face->feature(id) : nullptr;
    if (feature) found.extend(face->curves.at(feature->curve, feature->v));
  }
  if (found.isEmpty())
    return std::string("the surface has no feature points that tell where the ") + region.name +
           " is; give a rectangle XMIN,YMIN,XMAX,YMAX in mm";
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(region.margin);
  box.emplace(found.min() - margin, found.max() + margin);
  return {};
}

}  // namespace

std::string VectorRegion::names() {
  std::string names;
  for (const NamedRegion& region : namedRegions()) names += (names.empty() ? "" : ", ") + std::string(region.name);
  return names;
}

std::string VectorRegion::parse(const std::string& text, const FaceCurves* face) {
  VectorRegion region;
  region.name = text;
  const auto& all = namedRegions();
  const auto named = std::find_if(all.begin(), all.end(), [&](const NamedRegion& known) { return known.name == text; });
  std::string fault;
  if (named != all.end())
    fault = findBox(*named, face, region.box);
  else if (!text.empty() && (text[0] == 'P' || text[0] == 'p'))
    fault = parsePatch(text, region.patch);
  else if (text.find(',') != std::string::npos)
    fault = parseRectangle(text, region.rectangle);
  else
    fault = "there is no region '" + text + "'; it is P0 .. P8, " + names() + ", or XMIN,YMIN,XMAX,YMAX in mm";
  if (fault.empty()) *this = region;
  return fault;
}

bool VectorRegion::contains(const MotionField& field, int index, const PicturePlane& plane) const {
  const Eigen::Vector3d origin = field.origins.row(index);
  if (box && !box->contains(origin)) return false;
  if (rectangle && !rectangle->contains(plane.project(origin))) return false;
  if (!patch) return true;
  return !field.patches.empty() && field.patches[index][0] <= *patch && *patch <= field.patches[index][1];
}

}  // namespace mien
