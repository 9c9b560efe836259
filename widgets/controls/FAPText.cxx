#include "FAPText.h"

#include <QCoreApplication>
#include <QHash>
#include <QStringList>

namespace mien {

namespace {

QString text(const char* source) {
  return QCoreApplication::translate("FAPText", source);
}

const QHash<QString, QString>& words() {
  static const QHash<QString, QString> table = {{"l", "left"},         {"r", "right"},
                                                {"t", "upper"},        {"b", "lower"},
                                                {"i", "inner"},        {"m", "middle"},
                                                {"lm", "left middle"}, {"rm", "right middle"},
                                                {"midlip", "mid-lip"}, {"cornerlip", "lip corner"}};
  return table;
}

QString latin(std::string_view text) {
  return QString::fromLatin1(text.data(), static_cast<int>(text.size()));
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
  QStringList parts = latin(fap.name).split('_');
  const bool brow = fap.group == 4, outerLip = fap.group == 8;
  if (outerLip) parts.removeLast();  // the o of the outer lip contour
  for (QString& part : parts) part = brow && part == "o" ? QString("outer") : words().value(part, part);
  QString label = parts.join(' ');
  label[0] = label[0].toUpper();
  return label;
}

const std::vector<int>& fapGroups() {
  static const std::vector<int> groups = {7, 4, 3, 5, 9, 8, 2, 6, 10};
  return groups;
}

QString fapGroupTitle(int group) {
  static const char* const titles[] = {"",
                                       "Visemes and expressions",
                                       "Jaw and inner lips",
                                       "Eyes",
                                       "Brows",
                                       "Cheeks",
                                       "Tongue",
                                       "Head",
                                       "Outer lips",
                                       "Nose",
                                       "Ears"};
  return text(titles[group]);
}

bool fapMatches(const FAPDefinition& fap, const QString& words) {
  const QString number = QString::number(fap.number), name = latin(fap.name), point = latin(fap.featurePoint),
                label = fapLabel(fap);
  for (const QString& word : words.split(' ', Qt::SkipEmptyParts)) {
    if (word == number || word == point) continue;
    const bool isNumber = word[0].isDigit();
    if (isNumber || !(name.contains(word, Qt::CaseInsensitive) || label.contains(word, Qt::CaseInsensitive)))
      return false;
  }
  return true;
}

QString fapToolTip(const FAPDefinition& fap, double millimetresPerUnit) {
  const QString name = latin(fap.name);
  QString tip = text("<b>FAP %1</b> %2<br>Feature point %3 moves %4 for positive values%5.<br>Unit: %6")
                    .arg(fap.number)
                    .arg(name, latin(fap.featurePoint), motion(fap.positiveMotion),
                         fap.bidirectional ? QString() : text("; negative values have no meaning in the standard"),
                         unitName(fap.unit));
  if (millimetresPerUnit > 0.0)
    tip += text(" / 1024.<br>1024 units are %1 mm on this face.").arg(1024.0 * millimetresPerUnit, 0, 'f', 1);
  if (fap.inPaperSubset) tip += text("<br>One of the 22 of Sheng et al. 2011.");
  return tip;
}

}  // namespace mien
