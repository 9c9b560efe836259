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
  if (hasColumns(header, {"landmark", "z"}) || hasColumns(header, {"vertex"})) return FileKind::Landmarks;
  if (hasColumns(header, {"landmark", "x", "y"})) return FileKind::PhotographMesh;
  if (hasColumns(header, {"landmark"})) return FileKind::Landmarks;
  return FileKind::Animation;
}

/// Of files with a beginning of their own.
struct Beginning {
  const char* bytes;
  int length;
  FileKind kind;
};

constexpr Beginning beginnings[] = {{"MIENZ", 5, FileKind::Curves},
                                    {"ply", 3, FileKind::Scan},
                                    {"solid", 5, FileKind::Scan},
                                    {"OFF", 3, FileKind::Scan},
                                    {"\x89PNG", 4, FileKind::Photograph},
                                    {"\xFF\xD8\xFF", 3, FileKind::Photograph},
                                    {"II*\0", 4, FileKind::Photograph},
                                    {"MM\0*", 4, FileKind::Photograph},
                                    {"mien_warp_mesh", 14, FileKind::PhotographMesh},
                                    {"# vtk DataFile", 14, FileKind::Other},
                                    {"%PDF", 4, FileKind::Other}};

/// Boundary curves are lines without polygons.
FileKind kindOfXML(const QByteArray& head) {
  if (head.contains("type=\"StructuredGrid\"")) return FileKind::Mesh;
  if (!head.contains("type=\"PolyData\"")) return FileKind::Other;
  return head.contains("NumberOfPolys=\"0\"") ? FileKind::Curves : FileKind::Mesh;
}

/// Two kinds of scans begin with anything: .obj with remarks, .stl with a title. No table has their endings.
bool hasScanEnding(const QString& fileName) {
  return fileName.endsWith(".obj", Qt::CaseInsensitive) || fileName.endsWith(".stl", Qt::CaseInsensitive);
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
  for (const Beginning& beginning : beginnings)
    if (head.startsWith(QByteArray(beginning.bytes, beginning.length))) return beginning.kind;
  if (head.startsWith("<?xml") || head.startsWith("<VTKFile")) return kindOfXML(head);
  if (hasScanEnding(fileName) || head.startsWith("v ")) return FileKind::Scan;
  if (head.contains('\0')) return FileKind::Other;
  if (isSession(head)) return FileKind::Session;
  if (const QByteArray begin = head.trimmed(); begin.startsWith('{') || begin.startsWith('['))
    return head.contains("\"mien animation table\"") ? FileKind::AnimationTable : FileKind::Json;
  return kindOfTable(text);
}

}  // namespace mien
