#pragma once

#include <QVariantAnimation>
#include <array>

namespace mien {

class RenderView;

/// Takes the camera of a view to another place within a third of a second, so that one sees where it goes.
class CameraFlight : public QVariantAnimation {
  Q_OBJECT
 public:
  CameraFlight(RenderView* view, QObject* parent);

  /// @param focus      what comes to the middle of the view, mm
  /// @param direction  from there to the camera; need not have unit length
  /// @param extent     what the height of the view shows, mm
  void flyTo(const std::array<double, 3>& focus, const std::array<double, 3>& direction, double extent);

 private:
  struct Place {
    std::array<double, 3> focus, direction;
    double distance;
  };

  Place current() const;
  void show(double share);

  RenderView* view_;
  Place from_{}, to_{};
};

}  // namespace mien
