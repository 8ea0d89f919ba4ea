# add_package_program(name [LIBRARIES target…])
#
# Builds name.cpp, linked with the package and its compiled core. A folder's own headers lie in its include/.
function(add_package_program name)
  cmake_parse_arguments(arg "" "" "LIBRARIES" ${ARGN})
  if(DELAUNAY_FROM_SURFACE_3_IN_CGAL_TREE)
    create_single_source_cgal_program(${name}.cpp NO_TESTING)
  else()
    add_executable(${name} ${name}.cpp)
  endif()
  target_link_libraries(${name} PRIVATE Delaunay_from_surface_3::compiled ${arg_LIBRARIES})
  target_include_directories(${name} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/include")
endfunction()

# add_package_example(name [ARGUMENTS argument…])
#
# As everywhere in CGAL, an example runs without arguments and is its own test. One with arguments is no
# test in a tree of CGAL.
function(add_package_example name)
  cmake_parse_arguments(arg "" "" "ARGUMENTS" ${ARGN})
  if(DELAUNAY_FROM_SURFACE_3_IN_CGAL_TREE AND NOT arg_ARGUMENTS)
    create_single_source_cgal_program(${name}.cpp)
    target_link_libraries(${name} PRIVATE Delaunay_from_surface_3::compiled)
    return()
  endif()
  add_package_program(${name})
  if(NOT DELAUNAY_FROM_SURFACE_3_IN_CGAL_TREE)
    add_test(NAME example_${name} COMMAND ${name} ${arg_ARGUMENTS}
      WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}")
    set_tests_properties(example_${name} PROPERTIES TIMEOUT 300)
  endif()
endfunction()
