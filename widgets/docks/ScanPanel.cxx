#include "ScanPanel.h"

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QLabel>
#include <QMimeData>
#include <QProgressBar>
#include <QSignalBlocker>
#include <QTimer>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>
#include <nlohmann/json.hpp>
#include <utility>

#include "Acquire.h"
#include "BackgroundTask.h"
#include "BoundaryCurveData.h"
#include "CurveFile.h"
#include "FaceModel.h"
#include "FaceView.h"
#include "FileDialog.h"
#include "FramedButton.h"
#include "LengthUnit.h"
#include "OverflowRow.h"
#include "RangeBox.h"
#include "SameCurves.h"
#include "ScanReportView.h"
#include "vtkBoundaryCurveReader.h"

namespace mien {

namespace {

constexpr double translucent = 0.45;
constexpr int longestName = 150;        // pixels
constexpr double longestRange = 100.0;  // mm
const QColor scanColor("#5b8fc7");
const char* const endings[] = {".ply", ".obj", ".stl", ".off", ".csv"};

bool isTable(const QString& fileName) {
  return fileName.endsWith(".csv", Qt::CaseInsensitive);
}

}  // namespace

struct ScanPanel::Found {
  MeasuredScan scan;
  std::string fault;
};

ScanPanel::ScanPanel(FaceModel* model, FaceView* view, QWidget* parent)
    : QWidget(parent),
      model_(model),
      view_(view),
      task_(new BackgroundTask(this)),
      map_(new DistanceMap(model, view, this)),
      open_(new QToolButton(this)),
      landmarks_(new QToolButton(this)),
      adopt_(new QToolButton(this)),
      cancel_(new QToolButton(this)),
      unit_(new QComboBox(this)),
      subject_(new QComboBox(this)),
      visible_(new QCheckBox(tr("Show scan"), this)),
      frontal_(new QCheckBox(tr("Front only"), this)),
      largest_(new RangeBox("scanLargest", longestRange, this)),
      progress_(new QProgressBar(this)),
      report_(new ScanReportView(this)) {
  setObjectName("scanPanel");
  describeButtons();
  describeMap();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 4, 0, 0);
  column->setSpacing(4);
  column->addWidget(row("scanControls", {open_, landmarks_, unit_, adopt_, visible_}));
  column->addWidget(
      row("scanMeasures", {new QLabel(tr("Distances"), this), subject_, largest_, frontal_, progress_, cancel_}));
  column->addWidget(report_, 1);
  actor_->GetProperty()->SetColor(scanColor.redF(), scanColor.greenF(), scanColor.blueF());
  actor_->GetProperty()->SetOpacity(translucent);
  actor_->GetProperty()->BackfaceCullingOn();  // seen through, it is one skin and not two
  connectButtons();
  connectMap();
  showReport();
}

/// The work ends before what it is delivered to.
ScanPanel::~ScanPanel() {
  delete task_;
}

void ScanPanel::describeButtons() {
  makeFramed(open_, "scanOpen", tr("Scan..."),
             tr("Measures the curves of a scan of a head: .ply .obj .stl .off, in any unit and pose"));
  makeFramed(landmarks_, "scanLandmarks", tr("Landmarks..."),
             tr("Landmarks of the scan from a .csv; without one they are found by fitting the generic face"));
  landmarks_->setCheckable(true);
  landmarks_->setProperty(notInSession, true);  // asks for a file
  makeFramed(adopt_, "scanAdopt", tr("Save and adopt curves..."),
             tr("Asks where to write the scan's curves (.vtp), and makes that file the face"));
  makeFramed(cancel_, "scanCancel", tr("Cancel"), tr("Stops measuring the scan"));
  unit_->setObjectName("scanUnit");
  unit_->setAccessibleName(tr("Unit of the scan"));
  unit_->addItem(tr("Unit: automatic"), QString());
  for (const char* unit : {"mm", "cm", "m", "inch"}) unit_->addItem(unit, unit);
  unit_->setToolTip(tr("What the scan's lengths are in, where that is not recognised"));
  visible_->setObjectName("scanVisible");
  visible_->setChecked(true);
  tellVisible();
  progress_->setObjectName("scanProgress");
  progress_->setFixedWidth(120);
}

void ScanPanel::describeMap() {
  subject_->setObjectName("scanDistances");
  subject_->setAccessibleName(tr("Distances"));
  subject_->addItems({tr("Not shown"), tr("On the face"), tr("On the scan")});
  subject_->setToolTip(tr("Colours the face, or the scan, by the distance to the other"));
  largest_->setAccessibleName(tr("Largest distance"));
  largest_->setToolTip(
      tr("The distance in mm that has the last colour; what is further away has it too. 0, automatic: a round number "
         "that 95 % of the distances lie below"));
  frontal_->setObjectName("scanFrontal");
  frontal_->setChecked(true);
  frontal_->setToolTip(
      tr("RMS, median, 95th percentile and largest of what lies in front of z = 50 mm, the face without its head"));
}

/// The last ones give way where there is no room for all, but for what is only there while a scan is measured.
QWidget* ScanPanel::row(const QString& name, const std::vector<QWidget*>& controls) {
  auto* made = new OverflowRow(name, this);
  int place = 0;
  for (QWidget* control : controls) made->addWidget(control, control == progress_ || control == cancel_ ? 0 : place++);
  made->addStretch();
  return made;
}

void ScanPanel::connectButtons() {
  connect(open_, &QToolButton::clicked, this, &ScanPanel::choose);
  connect(landmarks_, &QToolButton::clicked, this, &ScanPanel::chooseLandmarks);
  connect(adopt_, &QToolButton::clicked, this, &ScanPanel::chooseAdopted);
  connect(unit_, qOverload<int>(&QComboBox::activated), this, &ScanPanel::measure);
  connect(visible_, &QCheckBox::toggled, this, &ScanPanel::showScan);
  connect(view_, &FaceView::overlayChanged, this, &ScanPanel::followOverlay);
  connect(cancel_, &QToolButton::clicked, task_, &BackgroundTask::cancel);
  connect(task_, &BackgroundTask::progressed, progress_, &QProgressBar::setValue);
  connect(task_, &BackgroundTask::runningChanged, this, &ScanPanel::showReport);
  connect(model_, &FaceModel::updated, this, &ScanPanel::followCurves);
}

void ScanPanel::connectMap() {
  connect(subject_, qOverload<int>(&QComboBox::currentIndexChanged), this,
          [this](int index) { map_->setSubject(static_cast<DistanceMap::Subject>(index)); });
  connect(largest_, qOverload<double>(&QDoubleSpinBox::valueChanged), map_, &DistanceMap::setLargest);
  connect(frontal_, &QCheckBox::toggled, map_, &DistanceMap::setFrontalOnly);
  connect(map_, &DistanceMap::changed, this, [this] {
    const QSignalBlocker silent(subject_);
    subject_->setCurrentIndex(static_cast<int>(map_->subject()));
    largest_->showAutomatic(map_->automaticLargest());
    showReport();
    showScan();
  });
}

void ScanPanel::choose() {
  const QString name = FileDialog::open(window(), tr("Open a scan of a head"),
                                        tr("Scans (*.ply *.obj *.stl *.off *.PLY *.OBJ *.STL *.OFF);;All files (*)"));
  if (!name.isEmpty()) open(name);
}

void ScanPanel::chooseLandmarks(bool on) {
  const QString name =
      on ? FileDialog::open(window(), tr("Open landmarks"), tr("Landmarks (*.csv *.CSV);;All files (*)")) : QString();
  openLandmarks(name);
}

void ScanPanel::chooseAdopted() {
  const QString name =
      FileDialog::save(window(), tr("Save the scan's curves and make them the face"),
                       QFileInfo(file_).completeBaseName() + ".vtp", tr("Boundary curves (*.vtp)"), ".vtp");
  if (!name.isEmpty()) adopt(name);
}

QString ScanPanel::droppedFile(const QMimeData* data) {
  for (const QUrl& url : data->urls())
    for (const char* ending : endings)
      if (url.isLocalFile() && url.toLocalFile().endsWith(ending, Qt::CaseInsensitive)) return url.toLocalFile();
  return {};
}

void ScanPanel::openDropped(const QString& fileName) {
  isTable(fileName) ? openLandmarks(fileName) : open(fileName);
}

void ScanPanel::open(const QString& fileName) {
  file_ = fileName;
  emit opened();
  measure();
}

void ScanPanel::openLandmarks(const QString& fileName) {
  landmarkFile_ = fileName;
  landmarks_->setChecked(!fileName.isEmpty());
  showLandmarkFile();
  emit opened();
  measure();
}

/// A long name would widen the window.
void ScanPanel::showLandmarkFile() {
  const QString name = QFileInfo(landmarkFile_).fileName();
  landmarks_->setText(name.isEmpty() ? tr("Landmarks...")
                                     : fontMetrics().elidedText(name, Qt::ElideMiddle, longestName));
}

bool ScanPanel::isMeasuring() const {
  return task_->isRunning();
}

nlohmann::json ScanPanel::sessionState() const {
  return {{"scan", file_.toStdString()}, {"landmarks", landmarkFile_.toStdString()}};
}

/// Measured when the unit has been chosen as well.
void ScanPanel::restoreSession(const nlohmann::json& state) {
  const auto name = [&](const char* member) {
    return state.is_object() && state.contains(member) && state[member].is_string()
               ? QString::fromStdString(state[member].get<std::string>())
               : QString();
  };
  file_ = name("scan");
  landmarkFile_ = name("landmarks");
  landmarks_->setChecked(!landmarkFile_.isEmpty());
  showLandmarkFile();
  if (file_.isEmpty()) return forget();
  framed_ = file_;  // the camera is kept as well
  QTimer::singleShot(0, this, &ScanPanel::measure);
}

void ScanPanel::close() {
  file_.clear();
  landmarkFile_.clear();
  landmarks_->setChecked(false);
  showLandmarkFile();
  forget();
}

/// The view is of the face alone again.
void ScanPanel::forget() {
  task_->cancel();
  const bool wasShown = scan_;
  curves_ = nullptr;
  scan_ = nullptr;
  found_.clear();
  framed_.clear();
  map_->setScan(nullptr);
  showScan();
  showReport();
  if (wasShown) view_->fit();
  emit scanChanged();
}

void ScanPanel::measure() {
  if (file_.isEmpty()) return;
  emit scanChanged();
  AcquireOptions options;
  options.landmarkFile = landmarkFile_.toStdString();
  options.report = true;
  if (const LengthUnit* unit = lengthUnit(unit_->currentData().toString().toStdString()))
    options.scan.millimetres = unit->millimetres;
  task_->start(
      [this, options, file = file_.toStdString()](const BackgroundTask::Progress& goOn) -> std::function<void()> {
        Found found;
        found.fault = measureScan(options, file, found.scan, goOn);
        return [this, found] { take(found); };
      });
}

void ScanPanel::take(const Found& found) {
  if (!found.fault.empty()) {
    emit model_->failed(
        QString::fromStdString(found.fault),
        tr("The boxes Unit and Landmarks of the dock Curves and scan stand for --units and --landmarks."));
    return;
  }
  curves_ = found.scan.curves;
  scan_ = found.scan.scan;
  found_ = scanReportLines(found.scan.result);
  map_->setScan(scan_);
  showScan();
  showReport();
  if (framed_ != file_ || !view_->isMoved()) view_->fit();  // once: the camera is the user's from then on
  framed_ = file_;
  emit scanChanged();
}

bool ScanPanel::adopt(const QString& fileName) {
  if (!curves_) return false;
  const std::string fault = writeCurveFile(curves_, fileName.toStdString());
  if (!fault.empty()) {
    emit model_->failed(QString::fromStdString(fault), QString());
    return false;
  }
  if (!model_->openCurves(fileName)) return false;
  emit model_->remarked(tr("%1 was written and is the face now.").arg(QFileInfo(fileName).fileName()), fileName);
  return true;
}

/// Other ones may be the face now, but not with every frame.
void ScanPanel::followCurves() {
  const vtkMTimeType now = model_->pipeline().neutralCurves()->GetOutput()->GetMTime();
  if (now != std::exchange(curvesTime_, now)) showReport();
}

/// Told by the curves themselves: so it holds after a session is opened or a step undone, too.
bool ScanPanel::isAdopted() const {
  FaceCurves measured, shown;
  return readFaceCurves(curves_, measured).empty() &&
         readFaceCurves(model_->pipeline().neutralCurves()->GetOutput(), shown).empty() &&
         areSameCurves(measured.curves, shown.curves);
}

/// Distances of the shown face stand above it: whose these are has to be said.
void ScanPanel::addReport() {
  const QString heading = isAdopted() ? tr("Curves measured from %1, which are the shown face:")
                                      : tr("Curves measured from %1, not adopted yet:");
  report_->addLine(heading.arg(QFileInfo(file_).fileName()), file_);
  report_->addLines(found_);
}

void ScanPanel::showReport() {
  const bool running = task_->isRunning();
  progress_->setVisible(running);
  cancel_->setVisible(running);
  adopt_->setEnabled(curves_ && !running);
  visible_->setEnabled(scan_ && !isHiddenByColors());
  for (QWidget* control : std::initializer_list<QWidget*>{subject_, largest_, frontal_}) control->setEnabled(scan_);
  report_->begin();
  if (!map_->summary().isEmpty())
    report_->addLine(map_->summary(), tr("95 % of the area are no further away than the 95th percentile"));
  if (running)
    report_->addLine(tr("Measuring %1 ...").arg(QFileInfo(file_).fileName()));
  else if (found_.empty())
    report_->addLine(tr("A scan opened here or dropped onto the dock is measured and shown over the face."));
  else
    addReport();
  report_->end();
}

/// Seen through a scan, colours of the face would not be those of their scale; and a scan that is coloured by distances
/// itself would be covered by the plain one.
bool ScanPanel::isHiddenByColors() const {
  return colored_ || map_->subject() != DistanceMap::Subject::None;
}

void ScanPanel::tellVisible() {
  visible_->setToolTip(isHiddenByColors() ? tr("Not over a face whose colours have a meaning: it would tint them. It "
                                               "comes back with \"Skin\" and \"Photograph\"")
                                          : tr("The scan over the face, translucent; hidden while the face has colours "
                                               "with a meaning, which it would tint"));
}

/// A camera that nobody has placed takes in what is there.
void ScanPanel::followOverlay(const QObject* overlay) {
  const bool changes = colored_ != (overlay != nullptr);
  colored_ = overlay != nullptr;
  if (!changes) return;
  showScan();
  showReport();
  if (scan_ && visible_->isChecked() && !view_->isMoved()) view_->fit();
}

void ScanPanel::showScan() {
  view_->renderer()->RemoveActor(actor_);
  tellVisible();
  const bool isOpen = scan_ && visible_->isChecked(), isPlain = isOpen && !isHiddenByColors();
  const bool isColored = scan_ && map_->subject() == DistanceMap::Subject::Scan;
  QColor seen = scanColor;
  seen.setAlphaF(translucent);
  view_->tellScan(isPlain ? seen : QColor());
  view_->setCompany(isPlain || isColored ? scan_->GetBounds() : nullptr);
  if (isPlain) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(scan_);
    mapper->ScalarVisibilityOff();
    actor_->SetMapper(mapper);
    view_->renderer()->AddActor(actor_);
  }
  view_->redraw();
}

}  // namespace mien
