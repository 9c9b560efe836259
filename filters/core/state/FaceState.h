#pragma once

#include <map>
#include <string>
#include <vector>

#include "CurveEdit.h"
#include "FaceSurface.h"
#include "GridResolution.h"

namespace mien {

/// Which facial deformation table bends the surface, and how much [O].
struct FaceDeformation {
  std::string table;      ///< name of a table compiled in, a .csv file, or the text of one; empty: none
  double strength = 1.0;  ///< factor on its displacements, -2 .. 2
  bool smooth = true;     ///< regions blend into each other; else every point belongs to one, as in the paper

  bool operator==(const FaceDeformation& other) const;
};

/// The one serialisable description of a face: what is drawn follows from it alone.
///
/// Command-line options, sessions of the application and the metadata of figures read and write it; FaceStateText
/// gives its text form and FacePipeline the VTK pipeline that shows it.
struct FaceState {
  static constexpr int smallestColumns = mien::smallestColumns;
  static constexpr double largestFAPValue = 1e6;  ///< in FAP units, either sign
  static constexpr int mostVisemes = 2;           ///< mixed at a time
  static constexpr double largestStrength = 2.0;  ///< of a deformation, either sign

  /// Which frame of an animation file.
  enum class FrameChoice {
    Number,  ///< the frame number as written in the file
    Index,   ///< counted from 0
    Time     ///< seconds from the first frame
  };

  std::string curvesFile;        ///< .vtp of boundary curves; empty: the generic face
  std::vector<CurveEdit> edits;  ///< of the neutral curves, one after the other
  FaceSurfaceOptions surface;    ///< scheme, a per patch, N, remainder, derivative strength

  int rows = 56;     ///< of the uv mesh, both lip rows counted
  int columns = 40;  ///< without the closing one
  bool uniformRows = false;
  bool doublePrecision = false;  ///< of the surface's points and arrays

  std::string fapFile;  ///< .fap; empty: none
  FrameChoice frameChoice = FrameChoice::Index;
  double frame = 0.0;              ///< a frame number, an index or a time in s
  bool interpolateFrames = false;  ///< whether a time between two frames gives their linear mixture, not the one before

  std::string animationTable;                 ///< .json of what each FAP moves; empty: the table compiled in
  std::map<int, double> fapValues;            ///< FAP 3 .. 68 to FAP units; they add to those of the file
  std::map<std::string, double> expressions;  ///< "joy" .. to 0 .. 1; several mix
  std::map<std::string, double> visemes;      ///< "p b m" .. to 0 .. 1; at most two, as in FAP 1

  FaceDeformation deformation;

  std::string texture;  ///< photograph, .png .jpg .tif; empty: none

  /// .csv of the photograph's warp mesh, or its text (InlineText.h); empty: beside the photograph under its name.
  std::string textureMesh;

  bool operator==(const FaceState& other) const;
  bool operator!=(const FaceState& other) const { return !(*this == other); }
};

/// One sentence that says which property is out of range for curves of K points and what is allowed, or nothing.
std::string describeFault(const FaceState& state, int pointsPerCurve);

}  // namespace mien
