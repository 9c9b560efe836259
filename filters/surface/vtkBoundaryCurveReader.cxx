#include "vtkBoundaryCurveReader.h"

#include "BoundaryCurveData.h"
#include "GenericFaceFile.h"
#include "XMLDataFile.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataReader.h"

vtkStandardNewMacro(vtkBoundaryCurveReader);

namespace
{

/// @return nothing, or the file's name and what is wrong with it
std::string readXML(const std::string& name, vtkXMLPolyDataReader* reader)
{
  if (!name.empty())
    return mien::readXMLDataFile(name, reader);
  reader->ReadFromInputStringOn();
  reader->SetInputString(mien::GenericFaceFile());
  reader->Update();
  return {};
}

} // namespace

vtkBoundaryCurveReader::vtkBoundaryCurveReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkBoundaryCurveReader::~vtkBoundaryCurveReader()
{
  this->SetFileName(nullptr);
}

int vtkBoundaryCurveReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  const std::string name = this->FileName ? this->FileName : "";
  vtkNew<vtkXMLPolyDataReader> reader;
  std::string fault = readXML(name, reader);
  mien::FaceCurves face;
  if (fault.empty())
  {
    fault = mien::readFaceCurves(reader->GetOutput(), face);
    if (!fault.empty())
      fault = (name.empty() ? "the generic face" : name) + ": " + fault;
  }
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault);
    return 0;
  }
  mien::writeFaceCurves(face, vtkPolyData::GetData(outputs));
  return 1;
}

void vtkBoundaryCurveReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(the generic face)") << "\n";
}
