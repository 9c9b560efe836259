#pragma once

#include <string>
#include <vector>

namespace mien {

/// The numbered files of a series in a folder: STEM_0000.ENDING, STEM_0001.ENDING, ..
class FrameFiles {
 public:
  /// Makes the folder unless it is there; throws a FileFailure.
  /// @param earlierEndings  that a series of this name may also have had
  FrameFiles(const std::string& folder, const std::string& stem, const std::string& ending,
             const std::vector<std::string>& earlierEndings = {});

  const std::string& folder() const { return folder_; }
  std::string name(int index) const;  ///< without the folder
  std::string path(int index) const;

  /// Removes what an earlier run left: files named as those of this series are, but of which there are only so many.
  /// Files of any other name stay. A series without a file leaves all.
  void removeOthers(int count) const;

 private:
  bool isEarlier(const std::string& name, int count) const;

  std::string folder_, stem_, ending_;
  std::vector<std::string> earlierEndings_;
};

}  // namespace mien
