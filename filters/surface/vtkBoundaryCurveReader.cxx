#include "vtkBoundaryCurveReader.h"

#include <vtksys/SystemTools.hxx>

#include "BoundaryCurveData.h"
#include "CompactFaceFile.h"
#include "GenericFaceFile.h"
#include "SurfaceMesh.h"
#include "XMLDataFile.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkXMLPolyDataReader.h"

vtkStandardNewMacro(vtkBoundaryCurveReader);

namespace {

/// 29 curves of 4096 points as text are 9 MB; what is much larger is another surface and not worth reading.
constexpr unsigned long largestFaceFile = 64UL << 20;

/// @return nothing, or the file's name and what is wrong with it
std::string readXML(const std::string& name, vtkXMLPolyDataReader* reader) {
  if (!name.empty()) return mien::readXMLDataFile(name, reader);
  reader->ReadFromInputStringOn();
  reader->SetInputString(mien::GenericFaceFile());
  reader->Update();
  return {};
}

/// Whether a file's name says that it holds a surface, not curves.
bool isMeshName(const std::string& name) {
  const std::string ending = vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(name));
  return ending == ".ply" || ending == ".obj" || ending == ".stl" || ending == ".off" || ending == ".vts";
}

/// @return nothing, or one sentence that names the file
std::string readFace(const std::string& name, vtkPolyData* output) {
  if (isMeshName(name))
    return name +
           ": this is a mesh; a face is boundary curves in a .vtp or .mienz file, which of a scan mien acquire " +
           name + " -o FACE.vtp makes";
  vtkNew<vtkXMLPolyDataReader> reader;
  std::string fault = readXML(name, reader);
  if (!fault.empty()) return fault;
  mien::FaceCurves face;
  fault = mien::readFaceCurves(reader->GetOutput(), face);
  if (!fault.empty()) return (name.empty() ? "the generic face" : name) + ": " + fault;
  mien::writeFaceCurves(face, output);
  return {};
}

void addStatement(const mien::CompactFace& compact, vtkFieldData* fields) {
  vtkNew<vtkDoubleArray> error;
  error->SetName("StoredError");
  error->SetNumberOfComponents(2);
  error->InsertNextTuple2(compact.rmsError, compact.maximumError);
  fields->AddArray(error);
  if (compact.name.empty()) return;
  vtkNew<vtkStringArray> name;
  name->SetName("FaceName");
  name->InsertNextValue(compact.name);
  fields->AddArray(name);
}

/// @return nothing, or one sentence that names the file
std::string readCompact(const std::string& name, vtkPolyData* output) {
  mien::CompactFace compact;
  const std::string fault = mien::readCompactFaceFile(name, compact);
  if (!fault.empty()) return fault;
  mien::writeFaceCurves(compact.face, output);
  addStatement(compact, output->GetFieldData());
  return {};
}

/// @return nothing, or one sentence that names the file
std::string readAnyFace(const std::string& name, vtkPolyData* output) {
  return mien::isCompactFaceFile(name) ? readCompact(name, output) : readFace(name, output);
}

}  // namespace

vtkBoundaryCurveReader::vtkBoundaryCurveReader() {
  this->SetNumberOfInputPorts(0);
}

vtkBoundaryCurveReader::~vtkBoundaryCurveReader() {
  this->SetFileName(nullptr);
}

int vtkBoundaryCurveReader::CanReadFile(const char* fileName) {
  if (!fileName || !*fileName || vtksys::SystemTools::FileLength(fileName) > largestFaceFile) return 0;
  vtkNew<vtkPolyData> curves;
  return readAnyFace(fileName, curves).empty() ? 1 : 0;
}

int vtkBoundaryCurveReader::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) {
  outputs->GetInformationObject(0)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

int vtkBoundaryCurveReader::RequestData(vtkInformation* request, vtkInformationVector**,
                                        vtkInformationVector* outputs) {
  if (mien::isLaterPiece(request, outputs)) return 1;
  const std::string fault = readAnyFace(this->FileName ? this->FileName : "", vtkPolyData::GetData(outputs));
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  return 1;
}

void vtkBoundaryCurveReader::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(the generic face)") << "\n";
}
