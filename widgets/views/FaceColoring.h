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
class Comparison;
class FaceModel;
class FaceView;

/// What the face, and the one that it is compared with, is coloured by: its skin, a photograph, its patches, numbers of
/// the surface, or how far the two lie apart. Both sides have one scale.
///
/// Numbers keep the meaning of their colours: an automatic range grows when 4 % of the surface would lie beyond it, and
/// never shrinks while the same array is chosen, but by fit(); a fixed one stays. When a dock shows numbers of its own
/// on the face, this gives way and tells what they are and their scale, until something is chosen here.
class FaceColoring : public QObject {
  Q_OBJECT
 public:
  FaceColoring(FaceModel* model, FaceView* view, Comparison* comparison, QObject* parent);
  ~FaceColoring() override;

  QStringList choices() const;  ///< in words: "Skin", "Photograph", "Patches", then arrays with their unit
  void choose(const QString& choice);
  QString chosen() const;
  QString ofDock() const { return dock_; }  ///< what a dock shows on the face, chosen while it does; empty: none does

  void setOther(FaceView* view);  ///< in which B is shown

  ColorKey* key() const { return sides_.back()->key; }  ///< of the last view, to be put at its foot
  std::vector<ColorKey*> keys() const;                  ///< of all views

  /// Of the surface as the pipeline makes it, that it is coloured by; empty for its skin, a part of an array, and what
  /// comes from elsewhere.
  std::string arrayName() const;

  bool isNumbers() const { return kind_ == Kind::Numbers || kind_ == Kind::Difference; }
  void setAutomatic(bool automatic);
  void fit();      ///< chooses an automatic range for the present face
  void fitNext();  ///< the same once it has changed
  bool isAutomatic() const { return automatic_; }
  void setRange(double begin, double end);  ///< of a fixed range, in the array's unit; begin < end
  double begin() const { return begin_; }
  double end() const { return end_; }

 signals:
  void choicesChanged();
  void changed();  ///< another choice, or another range

 private:
  enum class Kind { Skin, Patches, Numbers, Difference, OfDock };
  struct Side {
    explicit Side(FaceView* shown);
    FaceView* view;
    ColorKey* key;
    ColorLegend legend;
  };

  vtkPolyData* surface() const;
  vtkPolyData* other() const;
  std::vector<vtkPolyData*> colored() const;
  void take(Kind kind, const FaceArray& array);
  void choosePhotograph(bool on);
  void produce(const FaceArray& array);
  void follow();
  void followOverlay(const QObject* overlay);
  void keySkins();
  void setDock(const QString& words);
  void followComparison();
  void growRange();
  void paint();
  ColorLegend::Scale scale() const;
  void paintSide(size_t side);
  void clearColors();

  FaceModel* model_;
  FaceView* view_;
  Comparison* comparison_;
  std::vector<std::unique_ptr<Side>> sides_;  ///< A, and B once there was one
  std::vector<FaceArray> arrays_;
  Kind kind_ = Kind::Skin;
  FaceArray array_;
  QString dock_;
  std::string photograph_, photographMesh_;  ///< the last one
  bool automatic_ = true, compares_ = false, fitsNext_ = false;
  double begin_ = 0.0, end_ = 1.0;
};

}  // namespace mien
