#pragma once

class QString;
class QToolButton;

namespace mien {

/// A tool button with words and a frame, as the docks have them: named for tests, reached by Tab.
void makeFramed(QToolButton* button, const QString& name, const QString& text, const QString& tip);

}  // namespace mien
