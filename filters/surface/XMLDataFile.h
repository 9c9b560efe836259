#pragma once

#include <string>

#include "MienSurfaceModule.h"

class vtkXMLReader;

namespace mien {

/// Reads a VTK XML file (.vtp, .vts) without trusting the counts in it: one that no file of its length can hold is
/// refused before VTK allocates for it, and running out of memory is an error like any other. Nothing is printed to the
/// console.
/// @return nothing, or "FILE: " and one sentence that says what is wrong; the reader's output is then not to be used
MIENSURFACE_EXPORT std::string readXMLDataFile(const std::string& name, vtkXMLReader* reader);

}  // namespace mien
