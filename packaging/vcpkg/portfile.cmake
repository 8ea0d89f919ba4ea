# A port for vcpkg: the headers and the compiled core, a static library. A release fills the places between @, all but
# that of the source's address; packaging/test_recipes runs this file without vcpkg.
vcpkg_check_linkage(ONLY_STATIC_LIBRARY)
vcpkg_download_distfile(ARCHIVE
  URLS "@SOURCE@"
  FILENAME "delaunay_from_surface_3-@VERSION@.tar.gz"
  SHA512 @SHA512@)
vcpkg_extract_source_archive(SOURCE_PATH ARCHIVE "${ARCHIVE}")

vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    -DBUILD_TESTING=OFF
    -DDELAUNAY_FROM_SURFACE_3_BUILD_EXAMPLES=OFF
    -DDELAUNAY_FROM_SURFACE_3_BUILD_PROGRAMS=OFF
    -DDELAUNAY_FROM_SURFACE_3_BUILD_BENCHMARK=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME delaunay_from_surface_3 CONFIG_PATH lib/cmake/Delaunay_from_surface_3)
vcpkg_fixup_pkgconfig()

file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/share/doc")
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE" "${SOURCE_PATH}/LICENSE.LGPL")
