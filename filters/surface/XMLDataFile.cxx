#include "XMLDataFile.h"

#include <exception>
#include <vtksys/FStream.hxx>
#include <vtksys/SystemTools.hxx>

#include "PipelineErrors.h"
#include "XMLCounts.h"
#include "vtkXMLReader.h"

namespace mien {

namespace {

std::string describeFileFault(const std::string& name) {
  if (vtksys::SystemTools::FileIsDirectory(name)) return "it is a folder; give a file in it";
  if (!vtksys::SystemTools::FileExists(name, true)) return "there is no such file; give a VTK XML file";
  vtksys::ifstream file(name.c_str(), std::ios::binary);
  return describeCountFault(file, vtksys::SystemTools::FileLength(name));
}

/// What the file says that it holds, such as "PolyData"; nothing where it says nothing.
std::string typeIn(const std::string& name) {
  constexpr std::size_t longestStart = 4096;
  std::string start(longestStart, '\0');
  vtksys::ifstream file(name.c_str(), std::ios::binary);
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(file.gcount()));
  const std::size_t element = start.find("<VTKFile"), key = start.find("type=", element);
  if (element == std::string::npos || key == std::string::npos || key + 6 >= start.size()) return {};
  const std::size_t begin = key + 6, end = start.find(start[begin - 1], begin);
  return end == std::string::npos ? std::string() : start.substr(begin, end - begin);
}

/// @param reader  the name of a class such as vtkXMLPolyDataReader
std::string describeTypeFault(const std::string& type, const std::string& reader) {
  const bool known =
      type == "PolyData" || type == "StructuredGrid" || type == "UnstructuredGrid" || type == "ImageData";
  if (!known || reader == "vtkXML" + type + "Reader") return {};
  if (type == "StructuredGrid")
    return "it holds a surface (StructuredGrid), and curves or polygons (PolyData) are asked for";
  return "it holds " + type + ", which is not what is asked for";
}

}  // namespace

std::string readXMLDataFile(const std::string& name, vtkXMLReader* reader) {
  std::string fault = describeFileFault(name);
  if (fault.empty()) fault = describeTypeFault(typeIn(name), reader->GetClassName());
  if (!fault.empty()) return name + ": " + fault;
  PipelineErrors errors;
  errors.observe(reader);
  reader->SetParserErrorObserver(errors.observer());
  reader->SetFileName(name.c_str());
  bool enough = true;
  try {
    reader->Update();
  } catch (const std::exception&)  // bad_alloc and length_error, from counts within the data
  {
    enough = false;
  }
  reader->SetParserErrorObserver(nullptr);
  if (!enough) return name + ": the file asks for more memory than there is; it is damaged or too large";
  return errors.first().empty() ? std::string() : name + ": this is no readable VTK XML file; write it again";
}

}  // namespace mien
