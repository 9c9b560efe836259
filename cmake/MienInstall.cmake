# What is installed beside programs and modules: headers of the core, what find_package(Mien) reads, and what desktops know.
include(CMakePackageConfigHelpers)

install(DIRECTORY "${PROJECT_SOURCE_DIR}/filters/core/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/mien/core"
  FILES_MATCHING PATTERN "*.h")

set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/Mien")
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/MienConfig.cmake.in" "${CMAKE_BINARY_DIR}/MienConfig.cmake"
  INSTALL_DESTINATION "${package_folder}")
write_basic_package_version_file("${CMAKE_BINARY_DIR}/MienConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_BINARY_DIR}/MienConfig.cmake" "${CMAKE_BINARY_DIR}/MienConfigVersion.cmake"
  DESTINATION "${package_folder}")

install(FILES README.md CHANGELOG.md LICENSE CITATION.cff DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(DIRECTORY doc DESTINATION "${CMAKE_INSTALL_DOCDIR}" PATTERN Doxyfile EXCLUDE)
if(MIEN_BUILD_APPS)
  set(desktop "${PROJECT_SOURCE_DIR}/app/studio/desktop")
  install(FILES "${desktop}/mien-studio.desktop" DESTINATION "${CMAKE_INSTALL_DATADIR}/applications")
  install(FILES "${desktop}/mien.svg" DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps")
  install(FILES "${desktop}/mien.xml" DESTINATION "${CMAKE_INSTALL_DATADIR}/mime/packages")
endif()
