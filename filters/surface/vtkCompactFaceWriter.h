/**
 * @class vtkCompactFaceWriter
 * @brief writes the boundary curves of a face as a compact face file (.mienz) of about a kilobyte
 *
 * Input: vtkPolyData, boundary curves as described in BoundaryCurveData.h (29 curves of K points, mm); feature points
 * and pupils are kept. vtkBoundaryCurveReader reads the file.
 *
 * Fourier modes of the curves, cosine-transformed along the face, quantised with the largest step that meets the
 * tolerance and packed with LZMA [Sheng et al. 2011, 7]; the file states its RMS and largest error. The generic face
 * takes about 1,000 bytes at 0.1 mm. Limitations: a head that animation turned (`HeadRotation`) is written in its own
 * frame, with a warning. Other arrays are not kept. Errors: an input that is no face, more than 4096 points per curve,
 * a file that cannot be written.
 * @sa vtkBoundaryCurveReader
 */
#ifndef vtkCompactFaceWriter_h
#define vtkCompactFaceWriter_h

#include <string>

#include "MienSurfaceModule.h"
#include "vtkWriter.h"

class MIENSURFACE_EXPORT vtkCompactFaceWriter : public vtkWriter {
 public:
  static vtkCompactFaceWriter* New();
  vtkTypeMacro(vtkCompactFaceWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The .mienz file. Default: none, which is an error. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /** RMS distance of the stored points to the given ones, at most, mm. Default 0.1; 1e-6 .. 100. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** What the face is called, up to 255 bytes of UTF-8. Default: nothing. */
  vtkSetMacro(FaceName, std::string);
  vtkGetMacro(FaceName, std::string);
  ///@}

 protected:
  vtkCompactFaceWriter() = default;
  ~vtkCompactFaceWriter() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

 private:
  vtkCompactFaceWriter(const vtkCompactFaceWriter&) = delete;
  void operator=(const vtkCompactFaceWriter&) = delete;

  std::string Encode(std::string& bytes);

  char* FileName = nullptr;
  double Tolerance = 0.1;
  std::string FaceName;
};

#endif
