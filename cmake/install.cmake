# Installs the headers, the compiled core, and the config package that find_package(Delaunay_from_surface_3) reads.

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

# Headers alone serve every machine.
if(DELAUNAY_FROM_SURFACE_3_INSTALL_COMPILED)
  set(package_data_dir "${CMAKE_INSTALL_LIBDIR}")
  set(package_arch "")
else()
  set(package_data_dir "${CMAKE_INSTALL_DATADIR}")
  set(package_arch ARCH_INDEPENDENT)
endif()
set(package_config_dir "${package_data_dir}/cmake/Delaunay_from_surface_3")
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/Delaunay_from_surface_3ConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion ${package_arch})

install(TARGETS Delaunay_from_surface_3 EXPORT Delaunay_from_surface_3Targets
  FILE_SET HEADERS DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
  INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
if(DELAUNAY_FROM_SURFACE_3_INSTALL_COMPILED)
  set_target_properties(Delaunay_from_surface_3_compiled PROPERTIES EXCLUDE_FROM_ALL OFF)
  install(TARGETS Delaunay_from_surface_3_compiled EXPORT Delaunay_from_surface_3Targets
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
endif()
install(EXPORT Delaunay_from_surface_3Targets
  NAMESPACE Delaunay_from_surface_3:: DESTINATION "${package_config_dir}")
configure_file("${CMAKE_CURRENT_LIST_DIR}/Delaunay_from_surface_3Config.cmake.in"
  "${PROJECT_BINARY_DIR}/Delaunay_from_surface_3Config.cmake" @ONLY)
install(FILES
  "${PROJECT_BINARY_DIR}/Delaunay_from_surface_3Config.cmake"
  "${PROJECT_BINARY_DIR}/Delaunay_from_surface_3ConfigVersion.cmake"
  DESTINATION "${package_config_dir}")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/LICENSE.LGPL" DESTINATION "${CMAKE_INSTALL_DOCDIR}")

include("${CMAKE_CURRENT_LIST_DIR}/pkg_config.cmake")
