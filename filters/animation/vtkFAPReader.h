/**
 * @class vtkFAPReader
 * @brief reads an MPEG-4 facial animation (.fap, or a table) and gives its frames over time
 *
 * Output: vtkTable with one row; double columns `frame`, `FAP1_viseme_select1` .. `FAP2_expression_def` and
 * `FAP3` .. `FAP68` (FAP units) as described in FAPTableData.h. The reader publishes TIME_STEPS (s; frame i, from 0,
 * is at i / frames per second) and TIME_RANGE while its output follows the time, and answers UPDATE_TIME_STEP; a stream
 * publishes the range only, as it grows with every frame; the information of the output carries
 * DATA_TIME_STEP, the time of the frame given. Without a time request it gives the first frame.
 * Formats, and what is accepted with a warning: .fap (FAPParser.h); tables with a header (.csv) of FAPs
 * (FAPCsvParser.h), FACS action units or ARKit blendshapes (CaptureParser.h), which is seen from the header. Errors:
 * `FILE:LINE: what is wrong`. What was loaded before a refused file stays, with all that the getters say.
 * @sa vtkFAPAnimationFilter
 */
#ifndef vtkFAPReader_h
#define vtkFAPReader_h

#include <memory>
#include <string>
#include <vector>

#include "MienAnimationModule.h"
#include "vtkTableAlgorithm.h"

namespace mien {
class FAPFrame;
struct FAPSequence;
}  // namespace mien

class MIENANIMATION_EXPORT vtkFAPReader : public vtkTableAlgorithm {
 public:
  static vtkFAPReader* New();
  vtkTypeMacro(vtkFAPReader, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The .fap or .csv file, or "-" for standard input. It is read again when it has changed on disk and the reader is
   * updated after Modified(). Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /** The frame to give whatever time is asked for, from 0; -1: the frame of the time. Default: -1. */
  void SetFrameIndex(int index);
  vtkGetMacro(FrameIndex, int);
  ///@}

  ///@{
  /** Whether times between two frames give their linear mixture instead of the frame before. Default: off. */
  void SetInterpolate(bool on);
  vtkGetMacro(Interpolate, bool);
  vtkBooleanMacro(Interpolate, bool);
  ///@}

  ///@{
  /**
   * Frames that come from elsewhere, for a stream that is still being written. StartStream() takes the place of the
   * file: FileName "-" then stands for the frames appended since. Without it "-" is standard input, read to its end.
   */
  void StartStream(double framesPerSecond, const std::string& name);
  void AppendFrame(const mien::FAPFrame& frame);
  void ClearFrames();  ///< forgets those appended so far, where only the newest is wanted
  ///@}

  /** Whether a file is one for this reader: a .fap by its name, so that an update says what is wrong with it, any other
   * by what is in it. 1 or 0, in silence. */
  static int CanReadFile(const char* fileName);

  /** The file may have changed: the next update looks. */
  void Modified() override;

  ///@{
  /** What the file loaded last says; call UpdateInformation() first. */
  int GetNumberOfFrames() const;
  double GetFramesPerSecond() const;
  std::string GetFormat() const;  ///< "FAPs (.fap)", "FAPs (table)", "FACS action units", "ARKit blendshapes"
  std::string GetName() const;
  std::string GetVersion() const;                ///< "2.0" or "2.1"; empty when the file has no header
  std::vector<std::string> GetWarnings() const;  ///< each `FILE:LINE: what`, in the order of the lines
  std::vector<int> GetFAPsUsed() const;          ///< numbers of the FAPs that a frame sets, ascending
  int GetIndexOfFrameNumber(
      double number) const;  ///< of the first frame with this number in the file, from 0; -1: none
  const mien::FAPSequence& GetSequence() const;
  ///@}

 protected:
  vtkFAPReader();
  ~vtkFAPReader() override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkFAPReader(const vtkFAPReader&) = delete;
  void operator=(const vtkFAPReader&) = delete;

  /** Reads the file unless it is the one loaded. Returns nothing, or `FILE:LINE: what is wrong`. */
  std::string Load();

  char* FileName = nullptr;
  std::string Format;
  bool Streams = false;
  int FrameIndex = -1;
  bool Interpolate = false;

  std::unique_ptr<mien::FAPSequence> Sequence;
  std::vector<double> Times;   // of the frames, s
  bool MayHaveChanged = true;  // the file, since it was looked at
  int LoadNumber = 0;          // differs between any two files and streams of a program
  struct FileState {
    std::string Name;
    long long Modified = 0;
    unsigned long long Size = 0;
    bool operator==(const FileState& other) const {
      return Name == other.Name && Modified == other.Modified && Size == other.Size;
    }
  };
  FileState Loaded;
};

#endif
