#pragma once

#include <string>

class vtkImageData;

namespace mien {

class OutputFile;

/// Writes a picture as .png, .jpg or .tif, by its ending; values that are neither 8 nor 16 bits fit into .tif only.
/// Throws a ValueFailure for another ending, a FileFailure when it cannot be written.
void writePicture(vtkImageData* image, const std::string& name);

/// The same without the commit, where several files appear together.
void writePicture(vtkImageData* image, const OutputFile& file);

}  // namespace mien
