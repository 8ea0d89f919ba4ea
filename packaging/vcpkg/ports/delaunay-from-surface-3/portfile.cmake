# An overlay port: it takes the source around it, so nothing is downloaded.
#   vcpkg install delaunay-from-surface-3 --overlay-ports=packaging/vcpkg/ports

get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../../.." ABSOLUTE)

set(VCPKG_BUILD_TYPE release) # headers only
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    -DBUILD_TESTING=OFF
    -DDELAUNAY_FROM_SURFACE_3_INSTALL_COMPILED=OFF
    -DDELAUNAY_FROM_SURFACE_3_BUILD_PROGRAMS=OFF
    -DDELAUNAY_FROM_SURFACE_3_BUILD_EXAMPLES=OFF
    -DDELAUNAY_FROM_SURFACE_3_BUILD_BENCHMARK=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(
  PACKAGE_NAME Delaunay_from_surface_3 CONFIG_PATH share/cmake/Delaunay_from_surface_3)
vcpkg_fixup_pkgconfig()

file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/share/cmake" "${CURRENT_PACKAGES_DIR}/share/doc")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE" "${SOURCE_PATH}/LICENSE.LGPL")
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
