# Installs the headers and the config package that find_package(Delaunay_from_surface_3) reads.

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_config_dir "${CMAKE_INSTALL_DATADIR}/cmake/Delaunay_from_surface_3")
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/Delaunay_from_surface_3ConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)

install(TARGETS Delaunay_from_surface_3 EXPORT Delaunay_from_surface_3Targets
  FILE_SET HEADERS DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
  INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(EXPORT Delaunay_from_surface_3Targets
  NAMESPACE Delaunay_from_surface_3:: DESTINATION "${package_config_dir}")
install(FILES
  "${PROJECT_SOURCE_DIR}/cmake/Delaunay_from_surface_3Config.cmake"
  "${PROJECT_BINARY_DIR}/Delaunay_from_surface_3ConfigVersion.cmake"
  DESTINATION "${package_config_dir}")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")

include("${CMAKE_CURRENT_LIST_DIR}/pkg_config.cmake")
