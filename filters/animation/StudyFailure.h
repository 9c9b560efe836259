#pragma once

#include <stdexcept>

namespace mien {

/// Why a study cannot be computed: a file, or what is in it, is wrong; one sentence that names it and what to do.
class StudyFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace mien
