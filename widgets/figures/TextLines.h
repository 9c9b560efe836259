#pragma once

#include <QFont>
#include <QString>
#include <QStringList>

namespace mien {

double textWidth(const QFont& font, const QString& text);
double lineHeight(const QFont& font);

/// The text broken between words into lines that fit the width; a longer word has a line of its own.
QStringList textLines(const QFont& font, const QString& text, double width);

}  // namespace mien
