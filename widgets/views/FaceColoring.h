#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>
#include <vector>

#include "ColorLegend.h"
#include "FaceArray.h"

class vtkPolyData;

namespace mien {

class ColorKey;
class FaceModel;
class FaceView;

/// What the face is coloured by: its skin, a photograph, its patches, or numbers of the surface.
///
/// Numbers keep the meaning of their colours: an automatic range grows when 4 % of the surface would lie beyond it, and
/// never shrinks while the same array is chosen; a fixed one stays. When a dock shows numbers of its own on the face,
/// this hides itself and nothing is chosen.
class FaceColoring : public QObject {
  Q_OBJECT
 public:
  FaceColoring(FaceModel* model, FaceView* view, QObject* parent);
  ~FaceColoring() override;

  QStringList choices() const;  ///< in words: "Skin", "Photograph", "Patches", then arrays with their unit
  void choose(const QString& choice);
  QString chosen() const;  ///< empty while a dock shows numbers

  ColorKey* key() const { return key_; }  ///< to be put below the view

  bool isNumbers() const { return kind_ == Kind::Numbers; }
  void setAutomatic(bool automatic);
  void fit();  ///< chooses an automatic range for the present face
  bool isAutomatic() const { return automatic_; }
  void setRange(double begin, double end);  ///< of a fixed range, in the array's unit; begin < end
  double begin() const { return begin_; }
  double end() const { return end_; }

 signals:
  void choicesChanged();
  void changed();  ///< another choice, or another range

 private:
  enum class Kind { Skin, Patches, Numbers, OfDock };

  vtkPolyData* surface() const;
  void choosePhotograph(bool on);
  void produce(const FaceArray& array);
  void follow();
  void followOverlay(const QObject* overlay);
  void growRange();
  void paint();

  FaceModel* model_;
  FaceView* view_;
  ColorKey* key_;
  ColorLegend legend_;
  std::vector<FaceArray> arrays_;
  Kind kind_ = Kind::Skin;
  FaceArray array_;
  std::string photograph_, photographMesh_;  ///< the last one
  bool automatic_ = true;
  double begin_ = 0.0, end_ = 1.0;
};

}  // namespace mien
