/**
 * @class vtkPDEFaceAlgorithm
 * @brief what all filters that solve a PDE face have in common: its curves and its surface parameters
 *
 * Input: vtkPolyData, the boundary curves of BoundaryCurveData.h (29 curves of K points, mm). Whatever part of
 * an output is wanted, it takes whole curves.
 * Errors: curves that are no face, parameters out of range, a(N + 1) past what the scheme bears.
 */
#ifndef vtkPDEFaceAlgorithm_h
#define vtkPDEFaceAlgorithm_h

#include <memory>
#include <string>
#include <vector>

#include "MienSurfaceModule.h"
#include "vtkAlgorithm.h"

namespace mien {
struct FaceCurves;
struct FaceSurfaceOptions;
}  // namespace mien

class MIENSURFACE_EXPORT vtkPDEFaceAlgorithm : public vtkAlgorithm {
 public:
  vtkTypeMacro(vtkPDEFaceAlgorithm, vtkAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The curves as data; SetInputConnection() takes them from a pipeline. */
  void SetInputData(vtkDataObject* curves) { this->SetInputDataInternal(0, curves); }

  ///@{
  /** Takes all the parameters below from another filter, or from a face as the mathematics describes it. */
  void CopyParameters(vtkPDEFaceAlgorithm* other);
  void SetParameters(const mien::FaceSurfaceOptions& options);
  ///@}

  ///@{
  /** How patches meet their curves: "spline" (default), "four-curve" (the paper's), "derivative", "sixth-order",
   *  "tangent", "curvature"; GetSchemeNames() lists them. */
  void SetScheme(const std::string& name);
  std::string GetScheme() const;
  static std::vector<std::string> GetSchemeNames();
  ///@}

  ///@{
  /** The smoothing parameter a, for all patches or for one (0 .. 8). No unit; default 1, 0 < a <= 1000. */
  void SetSmoothing(double a);
  void SetSmoothing(int patch, double a);
  double GetSmoothing(int patch) const;
  ///@}

  ///@{
  /** N: how many Fourier modes are solved exactly. Default 5; 0 .. K / 2. */
  void SetNumberOfModes(int modes);
  int GetNumberOfModes() const;
  ///@}

  ///@{
  /** Whether all harmonics above N follow as one remainder, so that curves are met. Default on. */
  void SetRemainder(bool on);
  bool GetRemainder() const;
  void RemainderOn() { this->SetRemainder(true); }
  void RemainderOff() { this->SetRemainder(false); }
  ///@}

  ///@{
  /** Factor on the derivative conditions of schemes that have them [S 3.3]. No unit; default 1, -1000 .. 1000. */
  void SetDerivativeStrength(double strength);
  double GetDerivativeStrength() const;
  ///@}

 protected:
  vtkPDEFaceAlgorithm();
  ~vtkPDEFaceAlgorithm() override;

  vtkTypeBool ProcessRequest(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  virtual int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*);
  virtual int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*);
  virtual int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) = 0;

  /// The parameters as the mathematics takes them.
  const mien::FaceSurfaceOptions& GetOptions() const { return *this->Options; }

  /// The curves on input port 0, whatever the parameters are; false, after an error, when they are unusable.
  bool ReadCurves(vtkInformationVector** inputs, mien::FaceCurves& face);

  /// The curves on input port 0; false, after an error, when they or the parameters are unusable.
  bool ReadInput(vtkInformationVector** inputs, mien::FaceCurves& face);

 private:
  vtkPDEFaceAlgorithm(const vtkPDEFaceAlgorithm&) = delete;
  void operator=(const vtkPDEFaceAlgorithm&) = delete;

  template <class T>
  void Change(T& property, const T& value);

  std::unique_ptr<mien::FaceSurfaceOptions> Options;
};

#endif
