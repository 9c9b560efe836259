#pragma once

#include <string>
#include <vector>

#include "FigureCatalogue.h"

namespace mien {

/// The page that shows all figures of a folder: pictures, captions, parameters and the exact command of each.
class FigureGallery {
 public:
  struct Entry {
    const CatalogueFigure* figure;
    std::string file;     ///< beside the page
    std::string command;  ///< that draws this file again
    std::string caption;  ///< as drawn
    std::string note;     ///< its parameters in words
  };

  void add(const Entry& entry) { entries_.push_back(entry); }

  /// One page of HTML that needs nothing but the pictures beside it.
  std::string html() const;

 private:
  std::vector<Entry> entries_;
};

}  // namespace mien
