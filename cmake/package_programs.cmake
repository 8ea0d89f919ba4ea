# add_package_program(name [LIBRARIES target…])
#
# Builds name.cpp, linked with the package. A folder's own headers lie in its include/.

function(add_package_program name)
  cmake_parse_arguments(arg "" "" "LIBRARIES" ${ARGN})
  add_executable(${name} ${name}.cpp)
  target_link_libraries(${name} PRIVATE
    Delaunay_from_surface_3::Delaunay_from_surface_3 ${arg_LIBRARIES})
  target_include_directories(${name} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/include")
endfunction()
