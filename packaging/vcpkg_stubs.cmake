# Runs the port packaging/vcpkg as vcpkg would, without it: the helpers that the port calls are here, and do what vcpkg's
# documentation says of them. packaging/test_recipes calls it:
#
#   cmake -DPORT_FOLDER=… -DARCHIVE_FILE=… -DWORK=… -P vcpkg_stubs.cmake
#
# What vcpkg would install is then in WORK/packages.

set(PORT delaunay-from-surface-3)
set(CURRENT_PACKAGES_DIR "${WORK}/packages")
set(CURRENT_BUILDTREES_DIR "${WORK}/buildtrees")

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(code)
    message(FATAL_ERROR "${ARGV} failed:\n${out}")
  endif()
endfunction()

function(vcpkg_check_linkage)
  cmake_parse_arguments(arg "ONLY_STATIC_LIBRARY" "" "" ${ARGN})
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_ONLY_STATIC_LIBRARY)
    message(FATAL_ERROR "vcpkg_check_linkage(${ARGN})")
  endif()
endfunction()

# Nothing is downloaded: the file is here, and it must be the one that the port means.
function(vcpkg_download_distfile result)
  cmake_parse_arguments(arg "" "FILENAME;SHA512" "URLS" ${ARGN})
  file(SHA512 "${ARCHIVE_FILE}" sum)
  get_filename_component(name "${ARCHIVE_FILE}" NAME)
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_URLS OR NOT name STREQUAL arg_FILENAME OR NOT sum STREQUAL arg_SHA512)
    message(FATAL_ERROR "vcpkg_download_distfile(${ARGN}): ${name} has the sum ${sum}")
  endif()
  set(${result} "${ARCHIVE_FILE}" PARENT_SCOPE)
endfunction()

# The one folder at the top of an archive is left out.
function(vcpkg_extract_source_archive result)
  cmake_parse_arguments(arg "" "ARCHIVE" "" ${ARGN})
  file(ARCHIVE_EXTRACT INPUT "${arg_ARCHIVE}" DESTINATION "${CURRENT_BUILDTREES_DIR}/src")
  file(GLOB folder "${CURRENT_BUILDTREES_DIR}/src/*")
  set(${result} "${folder}" PARENT_SCOPE)
endfunction()

function(vcpkg_cmake_configure)
  cmake_parse_arguments(arg "" "SOURCE_PATH" "OPTIONS" ${ARGN})
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "vcpkg_cmake_configure(${ARGN})")
  endif()
  foreach(type rel dbg)
    set(prefix "${CURRENT_PACKAGES_DIR}")
    set(build_type Release)
    if(type STREQUAL "dbg")
      string(APPEND prefix "/debug")
      set(build_type Debug)
    endif()
    run("${CMAKE_COMMAND}" -G Ninja -S "${arg_SOURCE_PATH}" -B "${CURRENT_BUILDTREES_DIR}/${type}"
      "-DCMAKE_BUILD_TYPE=${build_type}" "-DCMAKE_INSTALL_PREFIX=${prefix}" -DCMAKE_INSTALL_LIBDIR=lib
      -DBUILD_SHARED_LIBS=OFF -DFETCHCONTENT_FULLY_DISCONNECTED=ON ${arg_OPTIONS})
  endforeach()
endfunction()

function(vcpkg_cmake_install)
  foreach(type rel dbg)
    run("${CMAKE_COMMAND}" --build "${CURRENT_BUILDTREES_DIR}/${type}" --target install)
  endforeach()
endfunction()

# Moves what find_package() reads to share/NAME, with the targets of both build types, whose paths start at the folder
# two above.
function(vcpkg_cmake_config_fixup)
  cmake_parse_arguments(arg "" "PACKAGE_NAME;CONFIG_PATH" "" ${ARGN})
  set(share "${CURRENT_PACKAGES_DIR}/share/${arg_PACKAGE_NAME}")
  file(GLOB files "${CURRENT_PACKAGES_DIR}/${arg_CONFIG_PATH}/*" "${CURRENT_PACKAGES_DIR}/debug/${arg_CONFIG_PATH}/*-debug.cmake")
  file(COPY ${files} DESTINATION "${share}")
  file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/lib/cmake" "${CURRENT_PACKAGES_DIR}/debug/lib/cmake")
  set(up "get_filename_component(_IMPORT_PREFIX \"\${_IMPORT_PREFIX}\" PATH)")
  foreach(file IN LISTS files)
    get_filename_component(name "${file}" NAME)
    file(READ "${share}/${name}" text)
    string(REPLACE "${up}\n${up}\n${up}\n" "${up}\n${up}\n" text "${text}")
    if(name MATCHES "-debug.cmake$")
      string(REPLACE "\${_IMPORT_PREFIX}/lib" "\${_IMPORT_PREFIX}/debug/lib" text "${text}")
    endif()
    if(text MATCHES "${CURRENT_PACKAGES_DIR}")
      message(FATAL_ERROR "${name} names the folder in which it was installed")
    endif()
    file(WRITE "${share}/${name}" "${text}")
  endforeach()
endfunction()

function(vcpkg_fixup_pkgconfig)
  file(GLOB files "${CURRENT_PACKAGES_DIR}/lib/pkgconfig/*.pc" "${CURRENT_PACKAGES_DIR}/share/pkgconfig/*.pc")
  if(NOT files)
    message(FATAL_ERROR "there is no file for pkg-config")
  endif()
endfunction()

function(vcpkg_install_copyright)
  cmake_parse_arguments(arg "" "" "FILE_LIST" ${ARGN})
  set(text "")
  foreach(file IN LISTS arg_FILE_LIST)
    file(READ "${file}" content)
    string(APPEND text "${content}\n")
  endforeach()
  file(WRITE "${CURRENT_PACKAGES_DIR}/share/${PORT}/copyright" "${text}")
endfunction()

include("${PORT_FOLDER}/portfile.cmake")

# What vcpkg complains of after a build.
foreach(name debug/include debug/share lib/cmake debug/lib/cmake share/doc)
  if(EXISTS "${CURRENT_PACKAGES_DIR}/${name}")
    message(FATAL_ERROR "${name} should not be in a package of vcpkg")
  endif()
endforeach()
