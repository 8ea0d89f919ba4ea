# Fakes the git tree of CGAL's developers around the package:
#   <root>/Installation/…             an installed CGAL in the layout of the branch
#   <root>/Delaunay_from_surface_3    this package, beside it
# CGAL's CMake files then find the package by itself, since it has include/ and package_info/.
# Input: BRANCH_ROOT, CGAL_DIR, CGAL_INCLUDE_DIRS, PACKAGE_FOLDER.

set(installation "${BRANCH_ROOT}/Installation")
foreach(dir IN LISTS CGAL_INCLUDE_DIRS)
  if(EXISTS "${dir}/CGAL/config.h")
    set(cgal_headers "${dir}/CGAL")
  endif()
endforeach()
if(NOT cgal_headers)
  message(FATAL_ERROR "No CGAL/config.h in ${CGAL_INCLUDE_DIRS}")
endif()

# A link to the folder CGAL alone: the include folder around it may be the compiler's own.
file(MAKE_DIRECTORY "${installation}/include" "${installation}/package_info/Installation"
  "${installation}/cmake" "${installation}/lib/cmake")
file(CREATE_LINK "${cgal_headers}" "${installation}/include/CGAL" SYMBOLIC)
file(CREATE_LINK "${PACKAGE_FOLDER}" "${BRANCH_ROOT}/Delaunay_from_surface_3" SYMBOLIC)

# Copies, since CGAL's CMake files find the tree from where they lie themselves. They keep their time
# stamps, so that a second run builds nothing again.
file(COPY "${CGAL_DIR}/" DESTINATION "${installation}/lib/cmake/CGAL")
file(COPY "${CGAL_DIR}/" DESTINATION "${installation}/cmake/modules")
