#include "MotionWords.h"

#include <cctype>

namespace mien {

std::string MotionWords::title() const {
  std::string title = (moved.empty() ? "face at rest" : moved) + " against " + origin;
  const bool isFile = title.find('.') < title.find(' ');  // whose name is as it is
  if (!isFile) title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return title;
}

void describeMotion(const MotionWords& words, MotionVectorOptions& options) {
  options.title = words.title();
  options.caption = "Motion vectors from " + words.origin +
                    (words.headMotionRemoved ? ", without the motion of the head" : "") + "; view: " + words.view +
                    (options.picture.hidden ? "; vectors behind the face are drawn too." : ".");
  options.note = words.made;
  if (!options.picture.region.isWhole()) options.note += "; region " + options.picture.region.name;
}

}  // namespace mien
