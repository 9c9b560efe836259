#include "LibraryVersions.h"

#include <lzma.h>
#include <png.h>
#include <tiffio.h>
#include <vtkVersion.h>

#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <QObject>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSysInfo>
#include <nlohmann/json.hpp>

#include "MeshLibrary.h"

namespace mien {

namespace {

QString dotted(int major, int minor, int patch) {
  return QString("%1.%2.%3").arg(major).arg(minor).arg(patch);
}

/// Of what draws the views, be it a graphics card or a program.
QString graphics() {
  QOffscreenSurface surface;
  surface.create();
  QOpenGLContext context;
  if (!context.create() || !context.makeCurrent(&surface)) return QObject::tr("none");
  const auto text = [&](GLenum name) {
    return QString::fromLatin1(reinterpret_cast<const char*>(context.functions()->glGetString(name)));
  };
  const QString both = QString("%1, %2").arg(text(GL_RENDERER), text(GL_VERSION));
  context.doneCurrent();
  return both;
}

}  // namespace

std::vector<std::pair<QString, QString>> libraryVersions() {
  return {
      {"Mien", MIEN_VERSION},
      {"VTK", vtkVersion::GetVTKVersion()},
      {"Qt", qVersion()},
      {"Eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"OpenMesh", QString::fromStdString(meshLibraryVersion())},
      {"CLI11", dotted(CLI11_VERSION_MAJOR, CLI11_VERSION_MINOR, CLI11_VERSION_PATCH)},
      {"nlohmann-json", dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
      {"libpng", png_get_libpng_ver(nullptr)},
      {"LibTIFF", QString(TIFFGetVersion()).section('\n', 0, 0).section(' ', -1)},
      {"liblzma", lzma_version_string()},
      {"OpenGL", graphics()},
      {QObject::tr("System"), QSysInfo::prettyProductName() + ", " + QSysInfo::currentCpuArchitecture()}};
}

}  // namespace mien
