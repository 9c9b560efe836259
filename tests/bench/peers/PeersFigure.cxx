/// Prints what peers_bench measured as a table of ratios, and draws it.
///
/// usage: peers_figure PEERS.json [PICTURE.svg|pdf|png...]; exit code 1 when a file cannot be read or written.
#include <QPainter>
#include <cstdio>
#include <exception>

#include "BarPanel.h"
#include "FigureApplication.h"
#include "FigureFile.h"
#include "PlatePainter.h"

namespace {

constexpr double width = 170.0;        // mm
constexpr double dotsPerInch = 150.0;  // 1,004 pixels

/// A text in a column of so many characters; "×" is two bytes.
std::string padded(const std::string& text, int columns, bool right) {
  const std::string space(std::max(0, columns - QString::fromStdString(text).size()), ' ');
  return right ? space + text : text + space;
}

void print(const PeerGroup& group) {
  std::printf("\n%s\n", group.heading.c_str());
  const std::string ratio = group.reference.empty() ? "" : "times " + group.reference;
  std::printf("  %s%s  %s%s\n", padded("", 50, false).c_str(), padded("median ms", 10, true).c_str(),
              padded(ratio, 20, true).c_str(), padded("asked ms", 10, true).c_str());
  for (const PeerTime& time : group.times)
    std::printf("  %s%s  %s%s\n", padded(time.words, 50, false).c_str(),
                padded(timeText(time.milliseconds), 10, true).c_str(),
                padded(time.ratio > 0.0 ? timeText(time.ratio) : "", 20, true).c_str(),
                padded(time.target > 0.0 ? timeText(time.target) : "", 10, true).c_str());
}

mien::Plate plateOf(const std::vector<PeerGroup>& groups) {
  mien::Plate plate;
  plate.columns = 1;
  plate.title = "The same work by Mien and by others";
  plate.caption =
      "Blue: Mien. Yellow: others. Black marks: what was asked for. Processor time of one thread, that of the clock "
      "where threads are named; medians of five.";
  plate.note = "./dev bench --peers";
  for (const PeerGroup& group : groups)
    plate.panels.push_back(barPanel(group, mien::PlatePainter::panelWidth(width, 1, 1)));
  return plate;
}

std::string draw(const mien::Plate& plate, const char* name) {
  const mien::PlatePainter painter(plate, *mien::FigureTheme::find("light"), width);
  mien::FigureFile file(name);
  file.setTitle(plate.title);
  file.setDescription(plate.note);
  file.setDotsPerInch(dotsPerInch);
  return file.write(painter.size(), [&](QPainter& p) { painter.paint(p); });
}

}  // namespace

int main(int count, char** arguments) try {
  if (count < 2) return std::fprintf(stderr, "usage: peers_figure PEERS.json [PICTURE...]\n"), 2;
  const std::vector<PeerGroup> groups = readPeerTimes(arguments[1]);
  for (const PeerGroup& group : groups) print(group);
  const mien::FigureApplication application;
  for (int i = 2; i < count; ++i)
    if (const std::string fault = draw(plateOf(groups), arguments[i]); !fault.empty())
      return std::fprintf(stderr, "peers_figure: %s\n", fault.c_str()), 1;
  return 0;
} catch (const std::exception& fault) {
  return std::fprintf(stderr, "peers_figure: %s\n", fault.what()), 1;
}
