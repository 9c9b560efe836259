#pragma once

#include "SignedBox.h"

namespace mien {

/// Where a range of colours ends, in mm: automatic, which is 0 and shows the end in effect ("auto 10 mm"), or fixed.
class RangeBox : public SignedNumberBox {
  Q_OBJECT
 public:
  /// @param most  the largest fixed end
  RangeBox(const QString& objectName, double most, QWidget* parent);

  bool isAutomatic() const { return value() == minimum(); }
  void showAutomatic(double end);  ///< the end in effect while it is automatic

  void stepBy(int steps) override;  ///< the first step up from automatic keeps the end in effect

 private:
  double automatic_ = 0.0;
};

}  // namespace mien
