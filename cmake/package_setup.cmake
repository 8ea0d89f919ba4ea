# Defines the target Delaunay_from_surface_3::Delaunay_from_surface_3 once: for the top project, and for
# the folders test/, examples/, demo/, generator/ and benchmark/ when one of them is configured alone, as
# CGAL's habit is.

if(TARGET Delaunay_from_surface_3::Delaunay_from_surface_3)
  return()
endif()

# CGAL's macros define their own testing switches and default them to OFF: BUILD_TESTING before CGAL 6.0,
# CGAL_ENABLE_TESTING since. Both must be set before CGAL is looked for.
if(PROJECT_IS_TOP_LEVEL)
  option(BUILD_TESTING "Build the tests" ON)
endif()
if(NOT DEFINED CGAL_ENABLE_TESTING AND DEFINED BUILD_TESTING)
  set(CGAL_ENABLE_TESTING ${BUILD_TESTING} CACHE BOOL "Let CGAL's macros define tests")
endif()

# The CGAL of an unpacked tree must never be replaced silently by the system's.
set(DELAUNAY_FROM_SURFACE_3_CGAL_TREE "" CACHE PATH
  "Folder with an unpacked libcgal-dev (it contains usr/); empty: CGAL is looked for as usual")
if(DELAUNAY_FROM_SURFACE_3_CGAL_TREE)
  find_package(CGAL REQUIRED PATHS "${DELAUNAY_FROM_SURFACE_3_CGAL_TREE}/usr" NO_DEFAULT_PATH)
else()
  find_package(CGAL REQUIRED)
endif()

find_package(Threads REQUIRED) # of the compiled library

# Tests are made for the top project only, not for one that this package is a part of.
set(DELAUNAY_FROM_SURFACE_3_TESTING OFF)
if(PROJECT_IS_TOP_LEVEL AND BUILD_TESTING)
  set(DELAUNAY_FROM_SURFACE_3_TESTING ON)
endif()

set(DELAUNAY_FROM_SURFACE_3_DATA_DIR "" CACHE PATH
  "Folder of the meshes (bunny00.off …) of Debian's package libcgal-demo; empty: tests that need one skip")

get_filename_component(DELAUNAY_FROM_SURFACE_3_ROOT "${CMAKE_CURRENT_LIST_DIR}" DIRECTORY)

# A folder of the package is configured alone in a tree of CGAL. There CGAL's own calls make programs and
# tests, as of all its packages.
set(DELAUNAY_FROM_SURFACE_3_IN_CGAL_TREE OFF)
if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_SOURCE_DIR STREQUAL DELAUNAY_FROM_SURFACE_3_ROOT)
  set(DELAUNAY_FROM_SURFACE_3_IN_CGAL_TREE ON)
endif()

add_library(Delaunay_from_surface_3 INTERFACE)
add_library(Delaunay_from_surface_3::Delaunay_from_surface_3 ALIAS Delaunay_from_surface_3)
target_compile_features(Delaunay_from_surface_3 INTERFACE cxx_std_17)
target_link_libraries(Delaunay_from_surface_3 INTERFACE "$<BUILD_INTERFACE:CGAL::CGAL>")
target_include_directories(Delaunay_from_surface_3 INTERFACE
  "$<BUILD_INTERFACE:${DELAUNAY_FROM_SURFACE_3_ROOT}/include>")

# The same with the core compiled once, in a static library: less to compile in every file that uses the package. It
# also has the file side of tiles, which is only there. Neither needs CGAL, so that one library serves every version. What
# is said of arithmetic is added to the project's own options; products may be fused into sums, as the proofs of the
# filters allow.
add_library(Delaunay_from_surface_3_compiled STATIC EXCLUDE_FROM_ALL
  "${DELAUNAY_FROM_SURFACE_3_ROOT}/src/core.cpp"
  "${DELAUNAY_FROM_SURFACE_3_ROOT}/src/core_regular.cpp"
  "${DELAUNAY_FROM_SURFACE_3_ROOT}/src/core_periodic.cpp"
  "${DELAUNAY_FROM_SURFACE_3_ROOT}/src/tiles/Point_files_3.cpp"
  "${DELAUNAY_FROM_SURFACE_3_ROOT}/src/tiles/Tiles_to_files.cpp")
add_library(Delaunay_from_surface_3::compiled ALIAS Delaunay_from_surface_3_compiled)
set_target_properties(Delaunay_from_surface_3_compiled PROPERTIES
  EXPORT_NAME compiled OUTPUT_NAME delaunay_from_surface_3
  POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
target_compile_features(Delaunay_from_surface_3_compiled PRIVATE cxx_std_17)
target_compile_options(Delaunay_from_surface_3_compiled PRIVATE
  "$<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-O3;-fno-fast-math;-ffp-contract=fast>")
target_include_directories(Delaunay_from_surface_3_compiled PRIVATE "${DELAUNAY_FROM_SURFACE_3_ROOT}/include")
target_compile_definitions(Delaunay_from_surface_3_compiled INTERFACE CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED)
target_link_libraries(Delaunay_from_surface_3_compiled INTERFACE Delaunay_from_surface_3 PUBLIC Threads::Threads)

# The generator of surfaces, readers and writers of files, and meters: headers that tests, benchmark, program and
# figures share.
add_library(Delaunay_from_surface_3_generator INTERFACE)
target_link_libraries(Delaunay_from_surface_3_generator INTERFACE
  Delaunay_from_surface_3::Delaunay_from_surface_3)
target_include_directories(Delaunay_from_surface_3_generator INTERFACE
  "${DELAUNAY_FROM_SURFACE_3_ROOT}/generator/Delaunay_from_surface_3/include")
