#pragma once

class QSpinBox;
class QString;

namespace mien {

class ValueSlider;

/// A slider 0 .. 100 % with a box for the same number beside it: of expressions and visemes.
/// @param name  of the quantity, for accessibility
void makePercent(ValueSlider* slider, QSpinBox* box, const QString& name, const QString& tip);

/// Shows a value in both without a signal.
void showPercent(ValueSlider* slider, QSpinBox* box, int percent);

}  // namespace mien
