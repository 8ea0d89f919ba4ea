# add_package_test(name LABELS label… [SOURCES file…] [LIBRARIES target…] [CHECKED])
#
# Builds name.cpp, one Boost.Test program with its own main, and makes it a ctest test of that name.
#   LABELS     fast:     part of the everyday run, a few seconds;
#              slow:     only in the whole run;
#              versions: also built and run with every other compiler and CGAL version;
#              sanitize: also built and run with the sanitizers, hence with Epick only;
#              long:     a fuzzer, minutes to build and to run: not part of the build of everything.
#   SOURCES    further units.
#   LIBRARIES  further targets to link.
#   CHECKED    CGAL's checks are compiled in, the expensive ones included, whatever the build type.
#
# Each label has a target tests_<label> that builds its programs and nothing else. The programs find the
# meshes of Debian's package libcgal-demo in DELAUNAY_FROM_SURFACE_3_DATA_DIR, defined as a string; a
# test that does not find one there says so and goes on.

find_package(Boost REQUIRED)
foreach(label fast slow versions sanitize long)
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

function(add_package_test name)
  cmake_parse_arguments(arg "CHECKED" "" "LABELS;SOURCES;LIBRARIES" ${ARGN})
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_LABELS)
    message(FATAL_ERROR "add_package_test(${name}): LABELS missing or unknown: ${arg_UNPARSED_ARGUMENTS}")
  endif()

  add_executable(${name} ${name}.cpp ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE
    Delaunay_from_surface_3_generator Boost::headers ${arg_LIBRARIES})
  target_include_directories(${name} PRIVATE
    "${CMAKE_CURRENT_SOURCE_DIR}/include"
    "${CMAKE_CURRENT_BINARY_DIR}/include")
  target_compile_definitions(${name} PRIVATE
    "DELAUNAY_FROM_SURFACE_3_DATA_DIR=\"${DELAUNAY_FROM_SURFACE_3_DATA_DIR}\"")
  if(arg_CHECKED)
    target_compile_options(${name} PRIVATE -UNDEBUG)
    target_compile_definitions(${name} PRIVATE CGAL_CHECK_EXPENSIVE)
  endif()

  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES LABELS "${arg_LABELS}" TIMEOUT 900)
  if("long" IN_LIST arg_LABELS) # FUZZ_MINUTES says how long; the fuzzer has a limit for each case
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
    set_tests_properties(${name} PROPERTIES TIMEOUT 86400)
  endif()
  foreach(label IN LISTS arg_LABELS)
    add_dependencies(tests_${label} ${name})
  endforeach()
endfunction()

# add_python_test(name LABELS label… [TIMEOUT seconds] [PROGRAMS VARIABLE=target…])
#
# Makes name.py, tests of Python's unittest, a test of ctest. It finds the programs of the targets by the
# environment, and what tests of programs share in scripts/lib.
function(add_python_test name)
  cmake_parse_arguments(arg "" "TIMEOUT" "LABELS;PROGRAMS" ${ARGN})
  find_package(Python3 COMPONENTS Interpreter QUIET)
  if(NOT Python3_FOUND)
    message(STATUS "skipped: ${name}, as Python was not found")
    return()
  endif()

  set(environment "PYTHONPATH=${DELAUNAY_FROM_SURFACE_3_ROOT}/scripts/lib")
  foreach(program IN LISTS arg_PROGRAMS)
    string(REGEX MATCH "^([^=]*)=(.*)$" ignored "${program}")
    list(APPEND environment "${CMAKE_MATCH_1}=$<TARGET_FILE:${CMAKE_MATCH_2}>")
    foreach(label IN LISTS arg_LABELS)
      add_dependencies(tests_${label} ${CMAKE_MATCH_2})
    endforeach()
  endforeach()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 300)
  endif()
  add_test(NAME ${name} COMMAND Python3::Interpreter -B "${CMAKE_CURRENT_SOURCE_DIR}/${name}.py")
  set_tests_properties(${name} PROPERTIES
    LABELS "${arg_LABELS}" TIMEOUT ${arg_TIMEOUT} ENVIRONMENT "${environment}")
endfunction()
