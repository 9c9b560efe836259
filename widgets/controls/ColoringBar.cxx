#include "ColoringBar.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <iterator>

#include "FaceColoring.h"
#include "SessionPart.h"
#include "SignedBox.h"

namespace mien {

namespace {

constexpr double largestValue = 1e6;
constexpr int mostDecimals = 6, fieldWidth = 58;  // digits, pixels
constexpr int usualLetters = 20, mostLetters = 31;
constexpr int leastList = 130;  // pixels, with which "Skin" and the first words of a quantity can be read

/// A number with the digits that say something: "0.05", not "0.050000".
class NumberBox : public SignedNumberBox {
 public:
  using SignedNumberBox::SignedNumberBox;

  QString textFromValue(double value) const override {
    QString text = locale().toString(value, 'f', decimals());
    text.remove(locale().groupSeparator());
    while (text.endsWith('0')) text.chop(1);
    if (text.endsWith(locale().decimalPoint())) text.chop(1);
    return text == "-0" ? QString("0") : withRealMinus(text);
  }
};

}  // namespace

ColoringBar::ColoringBar(FaceColoring* coloring, QWidget* parent)
    : OverflowRow("coloringBar", parent),
      coloring_(coloring),
      range_(new QWidget(this)),
      choice_(new QComboBox(this)),
      automatic_(toggle("colorAutomatic", tr("Auto"),
                        tr("The range follows the face: it grows with the values and does not shrink; press twice to "
                           "fit it to the present face, as undo and redo do"))),
      begin_(new NumberBox(this)),
      to_(new QLabel(tr("\u2013"), this)),
      end_(new NumberBox(this)),
      unit_(new QLabel(this)) {
  describe();
  fillRow();
  connect(choice_, &QComboBox::currentTextChanged, coloring_, &FaceColoring::choose);
  connect(choice_, &QComboBox::currentTextChanged, this, &ColoringBar::colorChosen);
  connect(automatic_, &QToolButton::toggled, this, [this](bool on) {
    coloring_->setAutomatic(on);
    follow();
  });
  for (QDoubleSpinBox* box : {begin_, end_})
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this] {
      if (!coloring_->isAutomatic()) coloring_->setRange(begin_->value(), end_->value());
    });
  connect(coloring_, &FaceColoring::choicesChanged, this, &ColoringBar::list);
  connect(coloring_, &FaceColoring::changed, this, &ColoringBar::follow);
  list();
}

/// Where there is little room the range of the colours leaves first; what they mean stays.
void ColoringBar::fillRow() {
  setSpacing(3);
  auto* label = new QLabel(tr("Co&lour by"), this);
  label->setBuddy(choice_);
  label->setToolTip(choice_->toolTip());
  QToolButton* curves = toggle("faceCurves", tr("Curves"), tr("The 29 boundary curves as lines on the face"));
  QToolButton* names =
      toggle("faceCurveNames", tr("Names"),
             tr("The names of the curves beside the face: C1 .. C28, and C22', the lower lip's inner contour"));
  auto* numbers = new QHBoxLayout(range_);
  numbers->setContentsMargins(0, 0, 0, 0);
  numbers->setSpacing(3);
  for (QWidget* widget : std::initializer_list<QWidget*>{automatic_, begin_, to_, end_, unit_})
    numbers->addWidget(widget);
  addWidget(curves, 1);
  addWidget(names, 2);
  addWidget(label);
  addWidget(choice_);
  addWidget(range_, 3);
  addStretch();
  QWidget* const inputs[] = {curves, names, choice_, automatic_, begin_, end_};
  for (size_t i = 1; i < std::size(inputs); ++i) setTabOrder(inputs[i - 1], inputs[i]);
  connect(curves, &QToolButton::toggled, this, &ColoringBar::curvesToggled);
  connect(names, &QToolButton::toggled, this, &ColoringBar::namesToggled);
}

void ColoringBar::describe() {
  choice_->setObjectName("colorBy");
  choice_->setToolTip(
      tr("What the face is coloured by: its skin, a photograph (dock Texture), its nine patches, or an "
         "array of the surface with its unit; or what a dock shows on it, until another is chosen here. Displacement "
         "is there while a deformation table moves the face"));
  choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  choice_->setMinimumContentsLength(usualLetters);
  choice_->setMinimumWidth(leastList);
  choice_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  automatic_->setChecked(true);
  begin_->setObjectName("colorBegin");
  begin_->setAccessibleName(tr("First colour"));
  end_->setObjectName("colorEnd");
  end_->setAccessibleName(tr("Last colour"));
  unit_->setObjectName("colorUnit");
  unit_->setMinimumWidth(fontMetrics().horizontalAdvance(tr("1/mm\u00b2")));  // the longest: the row does not move
  for (QDoubleSpinBox* box : {begin_, end_}) {
    box->setRange(-largestValue, largestValue);
    box->setDecimals(mostDecimals);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setKeyboardTracking(false);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    box->setFixedWidth(fieldWidth);
  }
}

/// Views that move when a colour is chosen cannot be compared by eye.
void ColoringBar::keepPlace(QWidget* widget, bool keep) {
  QSizePolicy policy = widget->sizePolicy();
  policy.setRetainSizeWhenHidden(keep);
  widget->setSizePolicy(policy);
}

QToolButton* ColoringBar::toggle(const QString& name, const QString& text, const QString& toolTip) {
  auto* button = new QToolButton(this);
  button->setObjectName(name);
  button->setText(text);
  button->setToolTip(toolTip);
  button->setCheckable(true);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

void ColoringBar::list() {
  const QSignalBlocker quiet(choice_);
  choice_->clear();
  choice_->addItems(coloring_->choices());
  choice_->insertSeparator(3);
  if (!coloring_->ofDock().isEmpty()) {
    choice_->insertSeparator(choice_->count());
    choice_->addItem(coloring_->ofDock());
  }
  const int letters = coloring_->ofDock().size() + 1;  // the range, which takes room else, is hidden then
  choice_->setMinimumContentsLength(std::clamp(letters, usualLetters, mostLetters));
  choice_->setMaximumWidth(choice_->sizeHint().width());
  follow();
}

void ColoringBar::follow() {
  const QSignalBlocker quiet[] = {QSignalBlocker(choice_), QSignalBlocker(begin_), QSignalBlocker(end_),
                                  QSignalBlocker(automatic_)};
  choice_->setCurrentIndex(choice_->findText(coloring_->chosen()));
  choice_->setProperty(notInSession, !coloring_->ofDock().isEmpty());  // the dock's own settings show it again
  automatic_->setChecked(coloring_->isAutomatic());
  for (QWidget* widget : std::initializer_list<QWidget*>{automatic_, begin_, to_, end_, unit_}) {
    keepPlace(widget, coloring_->ofDock().isEmpty());
    widget->setVisible(coloring_->isNumbers());
  }
  for (QWidget* widget : {begin_, end_}) {
    widget->setEnabled(!coloring_->isAutomatic());
    widget->setProperty(notInSession, coloring_->isAutomatic());  // as it follows the face
  }
  showRange();
}

void ColoringBar::showRange() {
  begin_->setValue(coloring_->begin());
  end_->setValue(coloring_->end());
  unit_->setText(coloring_->chosen().section(" (", 1).section(')', 0, 0));
  begin_->setToolTip(tr("The value that has the first colour, in the unit of %1").arg(coloring_->chosen()));
  end_->setToolTip(tr("The value that has the last colour, in the unit of %1").arg(coloring_->chosen()));
}

}  // namespace mien
