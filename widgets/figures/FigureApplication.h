#pragma once

#include <memory>

class QGuiApplication;

namespace mien {

/// What Qt needs to draw text: an application object. One that is there already is used; otherwise one without
/// windows is made, which needs no display.
class FigureApplication {
 public:
  FigureApplication();
  ~FigureApplication();

 private:
  std::unique_ptr<QGuiApplication> own_;
};

}  // namespace mien
