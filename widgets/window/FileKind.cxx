#include "FileKind.h"

#include <QFile>
#include <algorithm>
#include <string>

#include "CommaReader.h"
#include "PackedTable.h"
#include "SessionFile.h"

namespace mien {

namespace {

constexpr qint64 headOfFile = 64 * 1024;  // bytes in which comments and header must lie

bool hasColumns(const std::vector<std::string_view>& header, std::initializer_list<std::string_view> names) {
  return std::all_of(names.begin(), names.end(), [&](std::string_view name) {
    return std::find(header.begin(), header.end(), name) != header.end();
  });
}

FileKind kindOfTable(const std::string& text) {
  CommaReader reader(text);
  if (!reader.readHeader().empty()) return FileKind::Animation;
  const auto& header = reader.header();
  if (hasColumns(header, {"region", "a1", "b1"})) return FileKind::DeformationTable;
  if (hasColumns(header, {"marker"})) return FileKind::Markers;
  if (hasColumns(header, {"landmark"}) || hasColumns(header, {"vertex"})) return FileKind::Landmarks;
  return FileKind::Animation;
}

/// Meshes, curves and pictures of the usual kinds, none of which is a table.
bool isOther(const QByteArray& head) {
  if (head.left(headOfFile).contains('\0')) return true;
  for (const char* begin : {"<?xml", "<VTKFile", "ply", "solid", "v ", "# vtk DataFile", "%PDF"})
    if (head.startsWith(begin)) return true;
  return false;
}

/// Or the state of a face, as figures carry it.
bool isSession(const QByteArray& head) {
  return head.trimmed().startsWith('{') && (head.contains("\"mien session\"") || head.contains("\"mien_face_state\""));
}

}  // namespace

FileKind fileKind(const QString& fileName) {
  if (fileName.endsWith(SessionFile::ending, Qt::CaseInsensitive)) return FileKind::Session;  // be it damaged
  QFile file(fileName);
  if (!file.open(QIODevice::ReadOnly)) return FileKind::Animation;
  const QByteArray head = file.read(headOfFile);
  const std::string text = head.toStdString();
  if (isPackedTable(text)) return FileKind::DeformationTable;
  if (isOther(head)) return FileKind::Other;
  if (isSession(head)) return FileKind::Session;
  if (head.trimmed().startsWith('{')) return FileKind::AnimationTable;
  return kindOfTable(text);
}

}  // namespace mien
