#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <QObject>
#include <QString>
#include <array>
#include <functional>
#include <memory>
#include <string>

#include "FaceState.h"
#include "SessionPart.h"

namespace mien {

class BackgroundTask;
class FaceModel;

/// Face B beside face A, which is the model's: a state that was pinned, A in another scheme, or a mesh from a file; and
/// how far they lie apart, measured again whenever one of them has changed.
///
/// Each side's surface carries the point arrays `Distance` (mm, double) and `DistanceVector` (3 components, mm, double)
/// to the other: where both have the same points and cells, from each point to its counterpart (vtkMotionVectorFilter);
/// else to the nearest point of the other surface (vtkSurfaceDistanceFilter), off the GUI thread.
class Comparison : public QObject, public SessionPart {
  Q_OBJECT
 public:
  enum class Kind { None, State, Scheme, Mesh };
  enum class Side { A, B };

  Comparison(FaceModel* model, QObject* parent);
  ~Comparison() override;

  void pin();                                 ///< B is A as it is now, with its scheme and mesh
  void pin(const FaceState& state);           ///< B is this state
  void compareScheme(const QString& scheme);  ///< B moves as A does, in this scheme
  bool openMesh(const QString& fileName);     ///< .vts .vtp .ply .obj .stl .off, mm. @return whether it could be read
  void swap();                                ///< A becomes B and B becomes A, but a mesh cannot be A
  void clear();

  Kind kind() const { return kind_; }
  QString name() const;     ///< of B, in words: a scheme with what moves it
  QString nameOfA() const;  ///< what moves A; and its scheme, where B has another
  QString scheme() const { return scheme_; }
  bool canSwap() const { return kind_ == Kind::State || kind_ == Kind::Scheme; }

  FaceModel* other();                     ///< that moves B; of a mesh it only tells how large a face is
  vtkPolyData* mesh() const;              ///< of a file, with normals; nullptr: B is a face
  vtkPolyData* surface(Side side) const;  ///< a side's surface with the arrays; nullptr until it is measured
  vtkPolyData* drawn(Side side) const;    ///< the same, but what its summary leaves out has no number
  bool corresponds() const;               ///< whether it was measured from each point to its counterpart
  bool leavesOut() const;                 ///< whether it is of what lies opposite the other alone
  QString summary(Side side) const;       ///< "A to B, 98 % of A: RMS .., 95 % .., max .. mm": from that side to
                                          ///< the other; to a mesh of what lies opposite, and how much that is

  /// {"kind": "none" | "state" | "scheme" | "mesh", "state": {..}, "scheme": "..", "file": ".."}, with the FaceState as
  /// FaceStateText writes it.
  nlohmann::json sessionState() const override;
  QString changeName() const override { return tr("comparison"); }
  void restoreSession(const nlohmann::json& state) override;  ///< failed() of the model tells what cannot be shown

 signals:
  void changed();   ///< another B, or none
  void measured();  ///< the surfaces with their arrays are new

 private:
  struct Distances;
  using Surfaces = std::array<vtkSmartPointer<vtkPolyData>, 2>;

  QString inScheme(const QString& scheme) const;
  void take(Kind kind);
  void follow();
  void measure();
  bool measureCounterparts(const Surfaces& surfaces);
  static Distances nearest(const Surfaces& surfaces, bool covered, const std::function<bool(double)>& goOn);
  void measureNearest(const Surfaces& surfaces);
  void deliver(const Distances& distances);
  Surfaces present() const;

  FaceModel* model_;
  FaceModel* other_ = nullptr;
  BackgroundTask* task_;
  Kind kind_ = Kind::None;
  QString scheme_, file_, words_;
  vtkSmartPointer<vtkPolyData> mesh_;
  Surfaces measured_;
  std::unique_ptr<Distances> distances_;
};

}  // namespace mien
