#include "vtkBoundaryCurveReader.h"

#include "BoundaryCurveData.h"
#include "GenericFaceFile.h"

#include "vtkCallbackCommand.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataReader.h"

#include <vtksys/SystemTools.hxx>

vtkStandardNewMacro(vtkBoundaryCurveReader);

namespace
{

/// The XML reader reports to the console without naming the file; its word is kept for our own message.
void keepMessage(vtkObject*, unsigned long, void* kept, void* message)
{
  *static_cast<std::string*>(kept) = message ? static_cast<const char*>(message) : "it cannot be parsed";
}

void readXML(vtkXMLPolyDataReader* reader, const std::string& name, std::string& fault)
{
  if (name.empty())
  {
    reader->ReadFromInputStringOn();
    reader->SetInputString(mien::GenericFaceFile());
  }
  reader->SetFileName(name.c_str());
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(keepMessage);
  observer->SetClientData(&fault);
  reader->AddObserver(vtkCommand::ErrorEvent, observer);
  reader->Update();
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
  if (!name.empty() && !vtksys::SystemTools::FileExists(name, true))
  {
    vtkErrorMacro(<< name << ": there is no such file; give a .vtp file of boundary curves");
    return 0;
  }
  vtkNew<vtkXMLPolyDataReader> reader;
  std::string xmlFault;
  readXML(reader, name, xmlFault);
  mien::FaceCurves face;
  std::string fault = mien::readFaceCurves(reader->GetOutput(), face);
  if (!xmlFault.empty())
    fault = "this is no readable VTK XML polydata file";
  if (!fault.empty())
  {
    vtkErrorMacro(<< (name.empty() ? "the generic face" : name) << ": " << fault);
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
