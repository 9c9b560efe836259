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
  if (!vtksys::SystemTools::FileExists(name, true)) return "there is no such file; give a VTK XML file";
  vtksys::ifstream file(name.c_str(), std::ios::binary);
  return describeCountFault(file, vtksys::SystemTools::FileLength(name));
}

}  // namespace

std::string readXMLDataFile(const std::string& name, vtkXMLReader* reader) {
  const std::string fault = describeFileFault(name);
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
