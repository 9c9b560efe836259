#include "FAPText.h"

#include <QCoreApplication>
#include <QHash>
#include <QStringList>

namespace mien {

namespace {

QString text(const char* source) { return QCoreApplication::translate("FAPText", source); }

const QHash<QString, QString>& words() {
  static const QHash<QString, QString> table = {
      {"l", "left"},          {"r", "right"},           {"t", "upper"},        {"b", "lower"},
      {"i", "inner"},         {"m", "middle"},          {"lm", "left middle"}, {"rm", "right middle"},
      {"midlip", "mid-lip"},  {"cornerlip", "lip corner"}};
  return table;
}

QString unitName(FAPUnit unit) {
  switch (unit) {
    case FAPUnit::IrisDiameter:
      return text("IRISD, the iris diameter");
    case FAPUnit::EyeSeparation:
      return text("ES, from pupil to pupil");
    case FAPUnit::EyeNoseSeparation:
      return text("ENS, from the eyes to the nose");
    case FAPUnit::MouthNoseSeparation:
      return text("MNS, from the nose to the mouth");
    case FAPUnit::MouthWidth:
      return text("MW, the width of the mouth");
    case FAPUnit::Angle:
      return text("AU, 0.00001 rad");
    case FAPUnit::None:
      break;
  }
  return {};
}

QString motion(FAPDirection direction) {
  switch (direction) {
    case FAPDirection::Left:
      return text("to the subject's left");
    case FAPDirection::Right:
      return text("to the subject's right");
    case FAPDirection::Up:
      return text("upwards");
    case FAPDirection::Down:
      return text("downwards");
    case FAPDirection::Forward:
      return text("forwards");
    case FAPDirection::Growing:
      return text("growing");
    case FAPDirection::ConcaveUpward:
      return text("rolling, concave upwards");
    case FAPDirection::None:
      break;
  }
  return text("none");
}

}  // namespace

QString fapLabel(const FAPDefinition& fap) {
  QStringList parts = QString::fromUtf8(fap.name.data(), static_cast<int>(fap.name.size())).split('_');
  const bool brow = fap.group == 4, outerLip = fap.group == 8;
  if (outerLip) parts.removeLast();  // the o of the outer lip contour
  for (QString& part : parts) part = brow && part == "o" ? QString("outer") : words().value(part, part);
  QString label = parts.join(' ');
  label[0] = label[0].toUpper();
  return label;
}

QString fapToolTip(const FAPDefinition& fap, double millimetresPerUnit) {
  const QString name = QString::fromUtf8(fap.name.data(), static_cast<int>(fap.name.size()));
  QString tip = text("<b>FAP %1</b> %2<br>Positive values move %3%4.<br>Unit: %5")
                    .arg(fap.number)
                    .arg(name, motion(fap.positiveMotion),
                         fap.bidirectional ? QString() : text("; negative values have no meaning in the standard"),
                         unitName(fap.unit));
  if (millimetresPerUnit > 0.0)
    tip += text(" / 1024.<br>1024 units are %1 mm on this face.").arg(1024.0 * millimetresPerUnit, 0, 'f', 1);
  return tip;
}

}  // namespace mien
