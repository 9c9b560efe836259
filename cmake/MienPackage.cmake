# cpack makes a .deb for Debian 12 from the release build; what it needs is read from the programs themselves.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME mien)
set(CPACK_PACKAGE_VENDOR "Mien")
set(CPACK_PACKAGE_CONTACT "The Mien authors <mien@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "visualisation of PDE face surfaces, their animation and deformation")
set(CPACK_PACKAGE_DESCRIPTION
  "A face of nine PDE surface patches between 29 boundary curves, animated by MPEG-4 facial animation parameters and\ndeformed by facial deformation tables: VTK filters, a command line, the desktop application Mien Studio, and a\nPython package.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_BINARY_DIR}/lib")
# Found at run time only: the private display, OpenGL in software, a font, and what Python imports.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "xvfb, libgl1-mesa-dri, fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-vtk9, python3-numpy")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "ffmpeg")
include(CPack)
