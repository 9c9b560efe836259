#include "ColoringBar.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

#include "FaceColoring.h"
#include "SessionPart.h"
#include "WrappingRow.h"

namespace mien {

namespace {

constexpr double largestValue = 1e6;
constexpr int decimals = 4, fieldWidth = 78;  // digits, pixels

}  // namespace

ColoringBar::ColoringBar(FaceColoring* coloring, QWidget* parent)
    : QWidget(parent),
      coloring_(coloring),
      choice_(new QComboBox(this)),
      automatic_(toggle("colorAutomatic", tr("Auto"),
                        tr("The range follows the face: it grows with the values and never shrinks; press twice to fit "
                           "it to the present face"))),
      begin_(new QDoubleSpinBox(this)),
      end_(new QDoubleSpinBox(this)) {
  setObjectName("coloringBar");
  describe();
  auto* row = new WrappingRow(this);
  row->setSpacing(4);
  auto* label = new QLabel(tr("Co&lour by"), this);
  label->setBuddy(choice_);
  for (QWidget* widget : std::initializer_list<QWidget*>{label, choice_, automatic_, begin_, end_})
    row->addWidget(widget);
  QToolButton* curves = toggle("faceCurves", tr("Curves"), tr("The 29 boundary curves on the face"));
  QToolButton* names =
      toggle("faceCurveNames", tr("Names"),
             tr("The names of the curves beside the face: C1 .. C28, and C22', the lower lip's inner contour"));
  row->addWidget(curves);
  row->addWidget(names);
  connect(curves, &QToolButton::toggled, this, &ColoringBar::curvesToggled);
  connect(names, &QToolButton::toggled, this, &ColoringBar::namesToggled);
  connect(choice_, &QComboBox::currentTextChanged, coloring_, &FaceColoring::choose);
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

void ColoringBar::describe() {
  choice_->setObjectName("colorBy");
  choice_->setToolTip(
      tr("What the face is coloured by: its skin, a photograph (dock Texture), its nine patches, or an "
         "array of the surface with its unit"));
  choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  choice_->setMinimumContentsLength(17);
  automatic_->setChecked(true);
  begin_->setObjectName("colorBegin");
  begin_->setToolTip(tr("The value that has the first colour, in the unit of the colour bar"));
  end_->setObjectName("colorEnd");
  end_->setToolTip(tr("The value that has the last colour, in the unit of the colour bar"));
  for (QDoubleSpinBox* box : {begin_, end_}) {
    box->setRange(-largestValue, largestValue);
    box->setDecimals(decimals);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setKeyboardTracking(false);
    box->setFixedWidth(fieldWidth);
  }
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
  follow();
}

void ColoringBar::follow() {
  const QSignalBlocker quiet[] = {QSignalBlocker(choice_), QSignalBlocker(begin_), QSignalBlocker(end_),
                                  QSignalBlocker(automatic_)};
  const QString chosen = coloring_->chosen();  // a separator has no text either
  choice_->setCurrentIndex(chosen.isEmpty() ? -1 : choice_->findText(chosen));
  automatic_->setChecked(coloring_->isAutomatic());
  for (QWidget* widget : std::initializer_list<QWidget*>{automatic_, begin_, end_})
    widget->setVisible(coloring_->isNumbers());
  for (QWidget* widget : {begin_, end_}) {
    widget->setEnabled(!coloring_->isAutomatic());
    widget->setProperty(notInSession, coloring_->isAutomatic());  // as it follows the face
  }
  begin_->setValue(coloring_->begin());
  end_->setValue(coloring_->end());
}

}  // namespace mien
