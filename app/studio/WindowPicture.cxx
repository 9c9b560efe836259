#include "WindowPicture.h"

#include <QApplication>
#include <QImage>
#include <QPixmap>
#include <QTimer>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "FaceModel.h"
#include "FaceState.h"
#include "FaceStateJson.h"
#include "SessionFile.h"
#include "StudioWindow.h"

namespace mien {

namespace {

constexpr int drawn = 1500;  // ms after which views, docks and thumbnails have settled with software rendering

}  // namespace

WindowPicture::WindowPicture(StudioWindow& window, const QString& file) : window_(window), file_(file) {
  QTimer::singleShot(drawn, this, [this] { take(); });
}

QString WindowPicture::describeEnding(const QString& file) {
  return file.endsWith(".png", Qt::CaseInsensitive) ? QString()
                                                    : file + ": pictures of the window are .png; give such a name";
}

QString WindowPicture::show(StudioWindow& window, const QString& stateFile) {
  nlohmann::json session;
  const QString unread = SessionFile::read(stateFile, session);
  if (!unread.isEmpty()) return unread;
  FaceState state;
  const std::string fault = readFaceState(session.value("face", nlohmann::json()), state);
  if (!fault.empty()) return stateFile + ": " + QString::fromStdString(fault);
  window.model().change([&](FaceState& shown) { shown = state; });
  return {};
}

void WindowPicture::take() {
  const bool written = window_.grab().toImage().convertToFormat(QImage::Format_RGB888).save(file_, "PNG");
  if (!written) std::fprintf(stderr, "mien-studio: %s: cannot be written\n", qPrintable(file_));
  QApplication::exit(written ? EXIT_SUCCESS : EXIT_FAILURE);
}

}  // namespace mien
