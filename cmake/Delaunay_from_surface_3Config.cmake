# find_package(Delaunay_from_surface_3) defines Delaunay_from_surface_3::Delaunay_from_surface_3 and finds CGAL.

foreach(component IN LISTS Delaunay_from_surface_3_FIND_COMPONENTS)
  if(Delaunay_from_surface_3_FIND_REQUIRED_${component})
    set(Delaunay_from_surface_3_FOUND FALSE)
    set(Delaunay_from_surface_3_NOT_FOUND_MESSAGE "there are no components, and none is called ${component}")
    return()
  endif()
endforeach()

include(CMakeFindDependencyMacro)
find_dependency(CGAL)
include("${CMAKE_CURRENT_LIST_DIR}/Delaunay_from_surface_3Targets.cmake")

# Here and not in the exported target: there CMake would write what CGAL::CGAL is an alias of.
set_property(TARGET Delaunay_from_surface_3::Delaunay_from_surface_3
  APPEND PROPERTY INTERFACE_LINK_LIBRARIES CGAL::CGAL)
