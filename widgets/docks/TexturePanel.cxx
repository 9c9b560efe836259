#include "TexturePanel.h"

#include <QCheckBox>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMimeData>
#include <QProgressBar>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

#include "BundledFile.h"
#include "EmptyState.h"
#include "FaceModel.h"
#include "FacePhotograph.h"
#include "FaceView.h"
#include "FileDialog.h"
#include "FlipBox.h"
#include "FramedButton.h"
#include "OverflowRow.h"
#include "PictureLabel.h"
#include "WarpMeshView.h"

namespace mien {

namespace {

QString droppedFile(const QMimeData* data) {
  for (const QUrl& url : data->urls())
    for (const char* ending : {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".csv"})
      if (url.isLocalFile() && url.toLocalFile().endsWith(ending, Qt::CaseInsensitive)) return url.toLocalFile();
  return {};
}

/// A picture below its name.
QWidget* named(const QString& name, QWidget* picture, QWidget* parent) {
  auto* box = new QWidget(parent);
  auto* label = new QLabel(name, box);
  label->setObjectName(picture->objectName() + "Name");
  label->setProperty("faint", true);
  label->setMinimumWidth(1);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addWidget(label);
  column->addWidget(picture, 1);
  return box;
}

}  // namespace

TexturePanel::TexturePanel(FaceModel* model, FaceView* view, QWidget* parent)
    : QWidget(parent),
      model_(model),
      photograph_(new FacePhotograph(model, view, this)),
      mesh_(new WarpMeshView(this)),
      warped_(new PictureLabel(this)),
      pages_(new QStackedWidget(this)),
      status_(new QLabel(this)),
      open_(new QToolButton(this)),
      painted_(new QToolButton(this)),
      openMesh_(new QToolButton(this)),
      undo_(new QToolButton(this)),
      reset_(new QToolButton(this)),
      save_(new QToolButton(this)),
      cancel_(new QToolButton(this)),
      on_(new QCheckBox(tr("On the face"), this)),
      fine_(new QCheckBox(tr("Fine"), this)),
      mirror_(new QCheckBox(tr("Mirror"), this)),
      progress_(new QProgressBar(this)) {
  setObjectName("texturePanel");
  setAcceptDrops(true);
  describeButtons();
  describeChoices();
  describeViews();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 4, 8, 6);
  column->setSpacing(4);
  controls_ = controls();
  column->addWidget(controls_);
  pages_->addWidget(emptyState());
  pages_->addWidget(new FlipBox(named(tr("Photograph"), mesh_, pages_),
                                named(tr("Texture, as the face wears it"), warped_, pages_), 3, 2, pages_));
  column->addWidget(pages_, 1);
  column->addWidget(statusRow());
  connectControls();
  showPhotograph();
}

TexturePanel::~TexturePanel() {
  delete photograph_;
}

void TexturePanel::describeButtons() {
  makeFramed(open_, "textureOpen", tr("Photograph..."),
             tr("A photograph of a face from the front (.png, .jpg, .tif), with the mesh that lies beside it "
                "(.csv); it can be dropped on this dock as well"));
  makeFramed(painted_, "texturePainted", tr("Painted"), tr("The painted face that comes with Mien"));
  makeFramed(openMesh_, "textureOpenMesh", tr("Mesh..."),
             tr("Where the features lie on the photograph: a mesh, or a list of its landmarks (68 by number or 25 by "
                "name), .csv"));
  makeFramed(undo_, "textureUndo", tr("Undo"), tr("The mesh before its last move"));
  makeFramed(reset_, "textureReset", tr("Reset"), tr("The mesh as it was opened"));
  makeFramed(save_, "textureSave", tr("Save mesh..."),
             tr("Writes the mesh as .csv; beside the photograph under its name it is found by itself"));
  makeFramed(cancel_, "textureCancel", tr("Cancel"), tr("Ends the work; what was shown stays"));
}

void TexturePanel::describeChoices() {
  on_->setObjectName("textureOn");
  on_->setToolTip(tr("Whether the face shows the photograph"));
  fine_->setObjectName("textureFine");
  fine_->setToolTip(tr("Landmarks give 19 x 21 points instead of 7 x 7: lids and lips lie better"));
  mirror_->setObjectName("textureMirror");
  mirror_->setChecked(true);
  mirror_->setToolTip(tr("The point on the other side of the middle moves as the mirror image"));
}

void TexturePanel::describeViews() {
  mesh_->setObjectName("textureMesh");
  mesh_->setAccessibleName(tr("Photograph with its mesh"));
  mesh_->setToolTip(
      tr("Drag points to where the features lie. Tab: next point, arrow keys: one pixel (Shift: ten); "
         "wheel: zoom, double click: all"));
  warped_->setObjectName("textureWarped");
  warped_->setToolTip(
      tr("The photograph warped onto (v, u) of the face: once around from left to right, C1 to C28 from "
         "top to bottom"));
  status_->setObjectName("textureStatus");
  status_->setMinimumWidth(1);
  status_->setProperty("faint", true);
  progress_->setObjectName("textureProgress");
  progress_->setMaximumWidth(90);
  progress_->setRange(0, 100);
  progress_->setToolTip(tr("How much of the present work is done"));
  for (QWidget* widget : std::initializer_list<QWidget*>{progress_, cancel_}) {
    QSizePolicy policy = widget->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    widget->setSizePolicy(policy);
    widget->hide();
  }
}

QWidget* TexturePanel::controls() {
  auto* row = new OverflowRow("textureControls", this);
  for (QWidget* widget : std::initializer_list<QWidget*>{open_, painted_, on_}) row->addWidget(widget);
  row->addSpacing(10);
  for (QWidget* widget : std::initializer_list<QWidget*>{openMesh_, fine_, mirror_, undo_, reset_, save_})
    row->addWidget(widget, 1);
  row->addStretch();
  return row;
}

QWidget* TexturePanel::emptyState() {
  auto* empty = new EmptyState("textureEmpty", tr("No photograph yet"),
                               tr("Open a photograph of a face from the front (.png, .jpg, .tif), or drop one here. A "
                                  "mesh of the same name beside "
                                  "it, or a list of landmarks, says where its features lie; without one you get a mesh "
                                  "to move. The painted face "
                                  "shows how it looks."),
                               pages_);
  connect(empty->addButton("textureEmptyOpen", tr("Open a photograph..."), open_->toolTip()), &QToolButton::clicked,
          this, &TexturePanel::chooseImage);
  connect(empty->addButton("textureEmptyPainted", tr("Take the painted face"), painted_->toolTip()),
          &QToolButton::clicked, this, &TexturePanel::openPainted);
  return empty;
}

QWidget* TexturePanel::statusRow() {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(status_, 1);
  row->addWidget(progress_);
  row->addWidget(cancel_);
  return box;
}

void TexturePanel::connectControls() {
  connect(open_, &QToolButton::clicked, this, &TexturePanel::chooseImage);
  connect(painted_, &QToolButton::clicked, this, &TexturePanel::openPainted);
  connect(openMesh_, &QToolButton::clicked, this, &TexturePanel::chooseMesh);
  connect(save_, &QToolButton::clicked, this, &TexturePanel::chooseSaved);
  connect(undo_, &QToolButton::clicked, photograph_, &FacePhotograph::undo);
  connect(reset_, &QToolButton::clicked, photograph_, &FacePhotograph::reset);
  connect(cancel_, &QToolButton::clicked, photograph_, &FacePhotograph::cancel);
  connect(on_, &QCheckBox::toggled, photograph_, &FacePhotograph::setOn);
  connect(fine_, &QCheckBox::toggled, photograph_, &FacePhotograph::setFine);
  connect(mesh_, &WarpMeshView::dragged, this, [this](MeshNode node, double x, double y) {
    fault_ = photograph_->move(node, x, y, mirror_->isChecked());
    mesh_->setFlagged(!fault_.isEmpty());
    showChosen();
  });
  connect(mesh_, &WarpMeshView::released, this, [this] {
    photograph_->finishMove();
    mesh_->setFlagged(false);
  });
  connect(mesh_, &WarpMeshView::chosenChanged, this, &TexturePanel::showChosen);
  connect(photograph_, &FacePhotograph::opened, this, &TexturePanel::showPhotograph);
  connect(photograph_, &FacePhotograph::opened, this, &TexturePanel::opened);
  connect(photograph_, &FacePhotograph::meshChanged, this, &TexturePanel::showPhotograph);
  connect(photograph_, &FacePhotograph::warpedChanged, this, [this] { warped_->setPicture(photograph_->warped()); });
  connect(photograph_, &FacePhotograph::refused, this, [this](const QString& sentence) {
    fault_ = sentence;
    mesh_->setFlagged(!sentence.isEmpty());
    showChosen();
  });
  connect(photograph_, &FacePhotograph::progressed, progress_, &QProgressBar::setValue);
  connect(photograph_, &FacePhotograph::runningChanged, this, [this](bool running) {
    progress_->setVisible(running);
    cancel_->setVisible(running);
  });
}

void TexturePanel::open(const QString& fileName) {
  if (fileName.isEmpty()) return;
  fileName.endsWith(".csv", Qt::CaseInsensitive) ? photograph_->openMesh(fileName) : photograph_->open(fileName);
}

QString TexturePanel::fileName() const {
  return photograph_->isOpen() ? photograph_->fileName() : QString();
}

void TexturePanel::openPainted() {
  photograph_->open(bundledFile("textures/painted.png"), bundledFile("textures/painted_7x7.csv"));
}

void TexturePanel::chooseImage() {
  open(FileDialog::open(window(), tr("Open a photograph"), tr("Photographs (*.png *.jpg *.jpeg *.tif *.tiff)")));
}

void TexturePanel::chooseMesh() {
  open(FileDialog::open(window(), tr("Open a mesh or landmarks"), tr("Warp mesh or landmarks (*.csv)")));
}

void TexturePanel::chooseSaved() {
  const QFileInfo photograph(photograph_->fileName());
  const QString name = FileDialog::save(window(), tr("Save the mesh"), photograph.completeBaseName() + ".csv",
                                        tr("Warp mesh (*.csv)"), ".csv");
  if (!name.isEmpty()) save(name);
}

bool TexturePanel::save(const QString& fileName) {
  return photograph_->save(fileName);
}

void TexturePanel::showPhotograph() {
  const bool shown = photograph_->isOpen() && photograph_->isOn();
  pages_->setCurrentIndex(photograph_->isOpen() ? 1 : 0);
  controls_->setVisible(photograph_->isOpen());  // the page without a photograph has its own
  const QSignalBlocker quiet(on_);
  on_->setChecked(photograph_->isOn());
  on_->setEnabled(photograph_->isOpen());
  for (QWidget* widget : std::initializer_list<QWidget*>{openMesh_, fine_, mirror_, save_}) widget->setEnabled(shown);
  undo_->setEnabled(shown && photograph_->canUndo());
  reset_->setEnabled(shown && photograph_->canUndo());
  mesh_->setEnabled(shown || !photograph_->isOpen());
  mesh_->setPicture(photograph_->picture());
  mesh_->setMesh(photograph_->mesh());
  showChosen();
}

bool TexturePanel::isUnsaved() const {
  return photograph_->isOpen() && photograph_->isOn() && !photograph_->isSaved();
}

QString TexturePanel::unsavedText() const {
  return isUnsaved() ? tr("The mesh is in no file; the session keeps it.") : QString();
}

void TexturePanel::showChosen() {
  status_->setText(unsavedText());
  const WarpMesh& mesh = photograph_->mesh();
  const MeshNode node = mesh_->chosen();
  if (!photograph_->isOpen() || node.row < 0 || node.row >= mesh.rows() || node.column >= mesh.columns()) return;
  const QString name =
      mesh.names.empty() ? QString() : QString::fromStdString(mesh.names[node.row * mesh.columns() + node.column]);
  QString text = tr("Row %1, column %2%3: x %4, y %5 of %6 \u00d7 %7 pixels")
                     .arg(node.row + 1)
                     .arg(node.column + 1)
                     .arg(name.isEmpty() ? QString() : " (" + name + ")")
                     .arg(mesh.x(node.row, node.column), 0, 'f', 1)
                     .arg(mesh.y(node.row, node.column), 0, 'f', 1)
                     .arg(mesh.width)
                     .arg(mesh.height);
  if (!fault_.isEmpty()) text = tr("Refused: %1.   %2").arg(fault_, text);
  status_->setText(text + "   " + unsavedText());
}

void TexturePanel::dragEnterEvent(QDragEnterEvent* event) {
  if (!droppedFile(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void TexturePanel::dropEvent(QDropEvent* event) {
  open(droppedFile(event->mimeData()));
  event->acceptProposedAction();
}

}  // namespace mien
