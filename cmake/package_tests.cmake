# add_package_test(name [LABELS fast|long] [VERSIONS fast|long] [SANITIZE fast|long] [GROUP group] [SOURCES file…]
#                  [LIBRARIES target…] [COMPILED] [CHECKED] [OPTIMIZED])
#
# Builds name.cpp, one Boost.Test program with its own main, and makes it a ctest test of that name.
#   LABELS     fast: part of the everyday run, a few seconds; long: only in scripts/test --long, and not part of the
#              build of everything; by default none: a part of scripts/test alone.
#   VERSIONS   the label with another compiler and other CGAL versions, else it is no test there.
#   SANITIZE   the label with the sanitizers, the same; hence with Epick only.
#   GROUP      Where tests are built in groups, those of one group are one unit: they instantiate the same
#              templates, which makes up most of the time that a unit takes.
#   SOURCES    further units.
#   LIBRARIES  further targets to link.
#   COMPILED   with the core compiled; else the core is tested as it is without a library.
#   CHECKED    CGAL's checks are compiled in, the expensive ones included, whatever the build type.
#   OPTIMIZED  at -O3, whatever the build type; what is right with less optimization may be wrong with it.
#
# DELAUNAY_FROM_SURFACE_3_CONFIGURATION, which presets set, is VERSIONS or SANITIZE there. The targets tests_fast and
# tests_long build the programs with that label and nothing else. The programs find the
# meshes of Debian's package libcgal-demo in DELAUNAY_FROM_SURFACE_3_DATA_DIR, defined as a string; a
# test that does not find one there says so and goes on.

option(DELAUNAY_FROM_SURFACE_3_GROUP_TESTS "Build the tests of a group as one unit" OFF)

find_package(Boost REQUIRED)
foreach(label fast long)
  if(NOT TARGET tests_${label})
    add_custom_target(tests_${label})
  endif()
endforeach()

# One header that includes every header of the package, for the units that want them all.
function(write_all_headers_file include_dir file)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE "${include_dir}" "${include_dir}/CGAL/*.h")
  set(text "")
  foreach(header IN LISTS headers)
    string(APPEND text "#include <${header}>\n")
  endforeach()
  file(CONFIGURE OUTPUT "${file}" CONTENT "${text}" @ONLY)
endfunction()

# add_test_program(name sources LIBRARIES… COMPILED CHECKED OPTIMIZED): the program alone.
function(add_test_program name sources)
  cmake_parse_arguments(arg "COMPILED;CHECKED;OPTIMIZED" "" "LIBRARIES" ${ARGN})
  if(DELAUNAY_FROM_SURFACE_3_IN_CGAL_TREE)
    create_single_source_cgal_program(${sources})
  else()
    add_executable(${name} ${sources})
  endif()
  target_link_libraries(${name} PRIVATE
    Delaunay_from_surface_3_generator Boost::headers ${arg_LIBRARIES})
  if(arg_COMPILED)
    target_link_libraries(${name} PRIVATE Delaunay_from_surface_3::compiled)
  endif()
  target_include_directories(${name} PRIVATE
    "${CMAKE_CURRENT_SOURCE_DIR}/include"
    "${CMAKE_CURRENT_BINARY_DIR}/include")
  target_compile_definitions(${name} PRIVATE
    "DELAUNAY_FROM_SURFACE_3_DATA_DIR=\"${DELAUNAY_FROM_SURFACE_3_DATA_DIR}\"")
  if(arg_CHECKED)
    target_compile_options(${name} PRIVATE -UNDEBUG)
    target_compile_definitions(${name} PRIVATE CGAL_CHECK_EXPENSIVE)
  endif()
  if(arg_OPTIMIZED AND CMAKE_BUILD_TYPE STREQUAL "Release" AND NOT CMAKE_CXX_FLAGS_RELEASE MATCHES "sanitize")
    target_compile_options(${name} PRIVATE -O3)
  endif()
endfunction()

# allow_a_day(name): a long test takes as long as it takes; one that is long in this configuration alone does not.
function(allow_a_day name)
  if(NOT DELAUNAY_FROM_SURFACE_3_CONFIGURATION OR name MATCHES "^fuzz_")
    set_tests_properties(${name} PROPERTIES TIMEOUT 86400)
  endif()
endfunction()

# register_test(name label program [argument…])
function(register_test name label program)
  add_test(NAME ${name} COMMAND ${program} ${ARGN})
  set_tests_properties(${name} PROPERTIES LABELS "${label}" TIMEOUT 900)
  if(label STREQUAL "long") # FUZZ_MINUTES says how long; the fuzzer has a limit for each case
    set_target_properties(${program} PROPERTIES EXCLUDE_FROM_ALL ON)
    allow_a_day(${name})
  endif()
  if(label)
    add_dependencies(tests_${label} ${program})
  endif()
endfunction()

# set_label_here(): arg_LABELS is that of this configuration. Where there is none the caller returns.
macro(set_label_here)
  if(DELAUNAY_FROM_SURFACE_3_CONFIGURATION)
    set(arg_LABELS "${arg_${DELAUNAY_FROM_SURFACE_3_CONFIGURATION}}")
    if(NOT arg_LABELS)
      return()
    endif()
  endif()
endmacro()

function(add_package_test name)
  cmake_parse_arguments(arg "COMPILED;CHECKED;OPTIMIZED" "LABELS;VERSIONS;SANITIZE;GROUP" "SOURCES;LIBRARIES" ${ARGN})
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "add_package_test(${name}): unknown: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  set_label_here()

  if(arg_GROUP AND DELAUNAY_FROM_SURFACE_3_GROUP_TESTS)
    if(arg_LABELS STREQUAL "long") # not built with the others
      string(APPEND arg_GROUP "_long")
    endif()
    set_property(GLOBAL APPEND PROPERTY test_groups "${arg_GROUP}")
    set_property(GLOBAL APPEND PROPERTY test_group_${arg_GROUP} "${name}")
    set_property(GLOBAL PROPERTY test_labels_${name} "${arg_LABELS}")
    foreach(option COMPILED CHECKED OPTIMIZED)
      if(arg_${option})
        set_property(GLOBAL APPEND PROPERTY test_options_${arg_GROUP} ${option})
      endif()
    endforeach()
    set_property(GLOBAL APPEND PROPERTY test_libraries_${arg_GROUP} ${arg_LIBRARIES})
    return()
  endif()

  set(options LIBRARIES ${arg_LIBRARIES})
  foreach(option COMPILED CHECKED OPTIMIZED)
    if(arg_${option})
      list(APPEND options ${option})
    endif()
  endforeach()
  add_test_program(${name} "${name}.cpp;${arg_SOURCES}" ${options})
  if(NOT DELAUNAY_FROM_SURFACE_3_IN_CGAL_TREE) # where CGAL's call has made a test of it
    register_test(${name} "${arg_LABELS}" ${name})
  endif()
endfunction()

# finish_test_groups(): to be called after the last test of a group. The unit of a group includes all that
# its tests include, and then each test inside a Boost.Test suite, which is a namespace too, of its name.
function(finish_test_groups)
  get_property(groups GLOBAL PROPERTY test_groups)
  list(REMOVE_DUPLICATES groups)
  foreach(group IN LISTS groups)
    get_property(tests GLOBAL PROPERTY test_group_${group})
    set(includes "")
    set(suites "")
    foreach(test IN LISTS tests)
      set(source "${CMAKE_CURRENT_SOURCE_DIR}/${test}.cpp")
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source}")
      file(STRINGS "${source}" lines REGEX "^#include ")
      list(APPEND includes ${lines})
      string(APPEND suites "#undef BOOST_TEST_MODULE\n"
        "BOOST_AUTO_TEST_SUITE(${test})\n#include \"${source}\"\nBOOST_AUTO_TEST_SUITE_END()\n")
    endforeach()
    list(REMOVE_DUPLICATES includes)
    list(REMOVE_ITEM includes "#include <boost/test/included/unit_test.hpp>")
    list(JOIN includes "\n" includes)
    file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/${group}.cpp" @ONLY CONTENT
      "#define BOOST_TEST_MODULE ${group}\n#include <boost/test/included/unit_test.hpp>\n${includes}\n${suites}")

    get_property(options GLOBAL PROPERTY test_options_${group})
    list(REMOVE_DUPLICATES options)
    get_property(libraries GLOBAL PROPERTY test_libraries_${group})
    add_test_program(${group} "${CMAKE_CURRENT_BINARY_DIR}/${group}.cpp" ${options} LIBRARIES ${libraries})
    target_include_directories(${group} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
    foreach(test IN LISTS tests)
      get_property(labels GLOBAL PROPERTY test_labels_${test})
      register_test(${test} "${labels}" ${group} --run_test=${test})
    endforeach()
  endforeach()
endfunction()

# add_python_test(name [LABELS fast|long] [SANITIZE fast|long] [TIMEOUT seconds] [PROGRAMS VARIABLE=target…])
#
# Makes name.py, tests of Python's unittest, a test of ctest. It finds the programs of the targets by the
# environment, and what tests of programs share in scripts/lib.
function(add_python_test name)
  cmake_parse_arguments(arg "" "LABELS;VERSIONS;SANITIZE;TIMEOUT" "PROGRAMS" ${ARGN})
  set_label_here()
  find_package(Python3 COMPONENTS Interpreter QUIET)
  if(NOT Python3_FOUND)
    message(STATUS "skipped: ${name}, as Python was not found")
    return()
  endif()

  set(environment "PYTHONPATH=${DELAUNAY_FROM_SURFACE_3_ROOT}/scripts/lib")
  foreach(program IN LISTS arg_PROGRAMS)
    string(REGEX MATCH "^([^=]*)=(.*)$" ignored "${program}")
    list(APPEND environment "${CMAKE_MATCH_1}=$<TARGET_FILE:${CMAKE_MATCH_2}>")
    if(arg_LABELS)
      add_dependencies(tests_${arg_LABELS} ${CMAKE_MATCH_2})
    endif()
  endforeach()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 300)
  endif()
  add_test(NAME ${name} COMMAND Python3::Interpreter -B "${CMAKE_CURRENT_SOURCE_DIR}/${name}.py")
  set_tests_properties(${name} PROPERTIES
    LABELS "${arg_LABELS}" TIMEOUT ${arg_TIMEOUT} ENVIRONMENT "${environment}")
  if(arg_LABELS STREQUAL "long")
    allow_a_day(${name})
  endif()
endfunction()
