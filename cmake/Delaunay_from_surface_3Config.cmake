# find_package(Delaunay_from_surface_3) finds CGAL and defines
#   Delaunay_from_surface_3::Delaunay_from_surface_3   header-only
#   Delaunay_from_surface_3::compiled                  the same with the core compiled, where that was installed;
#                                                      find_package(… COMPONENTS compiled) insists on it

foreach(component IN LISTS Delaunay_from_surface_3_FIND_COMPONENTS)
  if(Delaunay_from_surface_3_FIND_REQUIRED_${component} AND NOT component STREQUAL "compiled")
    set(Delaunay_from_surface_3_FOUND FALSE)
    set(Delaunay_from_surface_3_NOT_FOUND_MESSAGE "the only component is `compiled`, none is called ${component}")
    return()
  endif()
endforeach()

include(CMakeFindDependencyMacro)
find_dependency(CGAL)
include("${CMAKE_CURRENT_LIST_DIR}/Delaunay_from_surface_3Targets.cmake")

# Here and not in the exported target: there CMake would write what CGAL::CGAL is an alias of.
set_property(TARGET Delaunay_from_surface_3::Delaunay_from_surface_3
  APPEND PROPERTY INTERFACE_LINK_LIBRARIES CGAL::CGAL)

if(TARGET Delaunay_from_surface_3::compiled)
  set(Delaunay_from_surface_3_compiled_FOUND TRUE)
elseif(Delaunay_from_surface_3_FIND_REQUIRED_compiled)
  set(Delaunay_from_surface_3_FOUND FALSE)
  set(Delaunay_from_surface_3_NOT_FOUND_MESSAGE "the compiled core was not installed")
endif()
