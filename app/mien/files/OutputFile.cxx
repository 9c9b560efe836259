#include "OutputFile.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "Failure.h"
#include "WholeFile.h"

namespace mien {

namespace {

namespace fs = std::filesystem;

std::string listOfEndings(const std::vector<std::string>& endings) {
  std::string list;
  for (const std::string& ending : endings) list += (list.empty() ? "." : ", .") + ending;
  return list;
}

fs::path folderOf(const std::string& name) {
  const fs::path folder = fs::path(name).parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

void requireWritableFolder(const std::string& name) {
  const fs::path folder = folderOf(name);
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw FileFailure(name + ": there is no folder " + folder.string() + "; make it first");
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw FileFailure(name + ": cannot write to folder " + folder.string() + " (" + std::strerror(errno) + ")");
}

}  // namespace

std::string fileEnding(const std::string& name) {
  std::string ending = fs::path(name).extension().string();
  if (!ending.empty()) ending.erase(0, 1);
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

void requireEnding(const std::string& name, const std::vector<std::string>& known) {
  const std::string ending = fileEnding(name);
  if (std::find(known.begin(), known.end(), ending) != known.end()) return;
  const std::string what = ending.empty() ? "has no ending" : "has the unknown ending ." + ending;
  throw ValueFailure("output '" + name + "' " + what + "; the known ones are " + listOfEndings(known));
}

OutputFile::OutputFile(const std::string& name) : name_(WholeFile::targetOf(name)) {
  requireWritableFolder(name_);
  std::error_code error;
  if (fs::is_directory(name, error)) throw FileFailure(name + ": this is a folder; give the name of a file");
  temporaryName_ = WholeFile::temporaryNameOf(name_);
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  fs::remove(temporaryName_, ignored);
}

void OutputFile::commit() {
  std::error_code error;
  if (fs::file_size(temporaryName_, error) == 0 || error)
    throw FileFailure(name_ + ": nothing could be written; is there space left on the disk?");
  error = WholeFile::replace(name_, temporaryName_);
  if (error) throw FileFailure(name_ + ": cannot be written (" + error.message() + ")");
}

void OutputFile::write(const std::string& name, const std::string& text) {
  OutputFile file(name);
  std::ofstream stream(file.temporaryName(), std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw FileFailure(name + ": cannot be written (" + std::strerror(errno) + ")");
  file.commit();
}

}  // namespace mien
