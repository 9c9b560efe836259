#include "SessionFiles.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <array>

#include "InlineText.h"

namespace mien {

namespace {

using json = nlohmann::json;
using Pointer = json::json_pointer;

constexpr std::array<const char*, 8> members = {"animation_table", "curves", "file", "image",
                                                "landmarks",       "mesh",   "scan", "table"};
constexpr int faceLevels = 2, dockLevels = 3;  // of an owner: face/animation, docks/curvesDock/scanPanel

bool isPresent(const std::string& file) {
  return file == "-" || QFileInfo::exists(QString::fromStdString(file));
}

bool isWithin(const char* member, const Pointer& place) {
  return place.to_string().rfind(member, 0) == 0;
}

/// Tables that come with Mien have names that are no files, and a table or mesh that was never saved is there itself.
/// Elsewhere, as in the window's places, there are none, and what a hand has written there has no room in a session of
/// ours.
bool namesFile(const Pointer& place, const json& value) {
  if (!value.is_string() || value == "" || std::find(members.begin(), members.end(), place.back()) == members.end())
    return false;
  if (isInlineText(value.get_ref<const std::string&>())) return false;
  if (!isWithin("/face/", place) && !isWithin("/docks/", place)) return false;
  return place.back() != "table" || value.get<std::string>().find('/') != std::string::npos;
}

std::vector<Pointer> placesOfFiles(const json& session) {
  std::vector<Pointer> places;
  const json flat = session.flatten();
  for (const auto& item : flat.items())
    if (const Pointer place(item.key()); namesFile(place, item.value())) places.push_back(place);
  return places;
}

std::string& nameAt(json& session, const Pointer& place) {
  return session[place].get_ref<std::string&>();
}

Pointer ownerOf(Pointer place) {
  std::vector<std::string> path;
  for (; !place.empty(); place.pop_back()) path.insert(path.begin(), place.back());
  path.resize(std::min<size_t>(path.size(), path.front() == "face" ? faceLevels : dockLevels));
  Pointer owner;
  for (const std::string& name : path) owner /= name;
  return owner;
}

json valueAt(const json& session, const Pointer& place) {
  return session.contains(place) ? session[place] : json();
}

/// Where the file may lie now, the likeliest first.
QStringList candidates(const QString& name, const QString& before, const QString& now) {
  const QDir folder(now);
  QStringList places;
  if (QFileInfo(name).isRelative()) places << folder.absoluteFilePath(name);
  if (!before.isEmpty()) places << folder.absoluteFilePath(QDir(before).relativeFilePath(name));
  return places << folder.absoluteFilePath(QFileInfo(name).fileName());
}

}  // namespace

json SessionFiles::found(json session, const QString& folder) {
  const json before = session.value("folder", json(""));
  const QString from = before.is_string() ? QString::fromStdString(before.get<std::string>()) : QString();
  for (const Pointer& place : placesOfFiles(session)) {
    std::string& name = nameAt(session, place);
    if (folder.isEmpty() || name == "-") continue;
    const QString named = QString::fromStdString(name);
    if (isPresent(name) && QFileInfo(named).isAbsolute()) continue;
    for (const QString& candidate : candidates(named, from, folder)) {
      if (!QFileInfo::exists(candidate)) continue;
      name = QDir::cleanPath(candidate).toStdString();
      break;
    }
  }
  return session;
}

std::vector<SessionFiles::Absent> SessionFiles::absentIn(const json& session) {
  std::vector<Absent> absent;
  for (const Pointer& place : placesOfFiles(session))
    if (!isPresent(session[place].get<std::string>()))
      absent.push_back({place, ownerOf(place), session[ownerOf(place)], json()});
  return absent;
}

QStringList SessionFiles::names(const json& session, const std::vector<Absent>& absent) {
  QStringList all;
  for (const Absent& one : absent) all << QString::fromStdString(session[one.place].get<std::string>());
  all.removeDuplicates();
  return all;
}

json SessionFiles::without(json session, const std::vector<Absent>& absent) {
  for (const Absent& one : absent)
    if (isWithin("/docks/", one.owner)) session[one.owner] = json::object();
  return session;
}

void SessionFiles::setRest(const json& session, std::vector<Absent>& absent) {
  for (Absent& one : absent) one.rest = valueAt(session, one.owner);
}

void SessionFiles::keep(json& session, std::vector<Absent>& absent) {
  const auto isChanged = [&](const Absent& one) { return valueAt(session, one.owner) != one.rest; };
  absent.erase(std::remove_if(absent.begin(), absent.end(), isChanged), absent.end());
  for (const Absent& one : absent) session[one.owner] = one.value;
}

}  // namespace mien
