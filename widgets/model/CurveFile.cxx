#include "CurveFile.h"

#include "WholeFile.h"
#include "XMLPolyDataFile.h"

namespace mien {

std::string writeCurveFile(vtkPolyData* curves, const std::string& name) {
  WholeFile file(name);
  return fillPolyData(curves, file.temporaryName()) && file.commit() ? std::string()
                                                                     : name + ": " + WholeFile::unwritable;
}

}  // namespace mien
