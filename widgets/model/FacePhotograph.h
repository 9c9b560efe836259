#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <QImage>
#include <QObject>
#include <QString>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "BackgroundTask.h"
#include "WarpMeshEdit.h"

class vtkImageData;
class vtkPolyData;

namespace mien {

class FaceModel;
class FaceView;

/// The photograph on the face: follows FaceState's texture, textureMesh and curvesFile, reads and warps off the GUI
/// thread, first small, then whole, and dresses the face with the result. Its mesh can be moved by hand; what is moved
/// the state holds as text until it is saved as a file, so that it always says what is seen, wherever it goes.
class FacePhotograph : public QObject {
  Q_OBJECT
 public:
  FacePhotograph(FaceModel* model, FaceView* view, QObject* parent);
  ~FacePhotograph() override;

  /// Puts a photograph on the face; without a mesh the one beside it, else a starting mesh to be moved by hand. Colours
  /// on the face give way to it.
  void open(const QString& image, const QString& mesh = {});
  void openMesh(const QString& file);  ///< a warp mesh, or the photograph's landmarks
  void setFine(bool fine);             ///< whether landmarks give 19 x 21 points instead of 7 x 7
  void setOn(bool on);                 ///< takes the photograph off the face, and puts the last one back
  bool isOn() const;

  bool isOpen() const { return photograph_ != nullptr; }
  QString fileName() const { return QString::fromStdString(good_.image); }
  const QImage& picture() const;                    ///< of the photograph, reduced for the screen
  const QImage& warped() const { return warped_; }  ///< the texture
  const WarpMesh& mesh() const { return mesh_; }

  /// Moves a point of the mesh, in pixels of the photograph; the face follows in small.
  /// @return nothing, or which rows or columns would cross; the mesh is then as it was
  QString move(MeshNode node, double x, double y, bool mirrored);
  void finishMove();  ///< the moves since the last one are one step of undo(); the face is warped in full
  void undo();
  void reset();  ///< the mesh as it was opened
  bool canUndo() const { return steps_.size() > 1; }
  bool save(const QString& fileName);  ///< as .csv, which the state names from then on; the message bar says what is
                                       ///< wrong. @return whether it was written
  bool isSaved() const;                ///< whether the mesh lies in a file; else the state holds it
  void cancel();  ///< what is being read is read to its end and then forgotten; a warp ends at once

 signals:
  void opened();  ///< another photograph, or none
  void meshChanged();
  void warpedChanged();
  void refused(const QString& sentence);  ///< the mesh cannot be warped; empty: it can
  void progressed(int percent);
  void runningChanged(bool running);

 private:
  struct Photograph;
  struct Names {
    std::string image, mesh, curves;
    bool operator==(const Names& other) const {
      return image == other.image && mesh == other.mesh && curves == other.curves;
    }
  };
  using Step = std::pair<WarpMesh, std::string>;  ///< a mesh, and how the state names it

  Names named() const;
  vtkSmartPointer<vtkPolyData> curves() const;
  void follow();
  void uncover();
  void read();
  void accept(const Names& names, const std::shared_ptr<Photograph>& photograph, const WarpMesh& mesh);
  void refuse(const std::string& fault);
  void takeBack();
  void name(const std::string& mesh);
  void takeMesh(const WarpMesh& mesh, const std::string& named);
  void warp(bool whole);
  void dress(vtkImageData* texture, bool whole);
  void refuseMesh(const std::string& fault);
  bool isMoving() const;  ///< whether the mesh has moves that finishMove() waits for

  FaceModel* model_;
  FaceView* view_;
  BackgroundTask* task_;
  std::shared_ptr<Photograph> photograph_;
  Names asked_, good_, off_;
  WarpMesh mesh_;
  std::vector<Step> steps_;
  QImage warped_;
  QString landmarks_;
  QString waiting_;  ///< a mesh for the photograph that is being read
  bool fine_ = false, reading_ = false, warpsWhole_ = false;
  bool uncovers_ = false;  ///< whether what is being read is to be seen instead of colours
};

}  // namespace mien
