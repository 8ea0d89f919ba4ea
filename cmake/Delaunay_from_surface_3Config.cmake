# find_package(Delaunay_from_surface_3) defines Delaunay_from_surface_3::Delaunay_from_surface_3 and finds CGAL.

include(CMakeFindDependencyMacro)
find_dependency(CGAL)
include("${CMAKE_CURRENT_LIST_DIR}/Delaunay_from_surface_3Targets.cmake")

# Here and not in the exported target: there CMake would write what CGAL::CGAL is an alias of.
set_property(TARGET Delaunay_from_surface_3::Delaunay_from_surface_3
  APPEND PROPERTY INTERFACE_LINK_LIBRARIES CGAL::CGAL)
