# Installs the files that pkg-config reads. CGAL has none of its own: what its target asks for is written here.

set(pc_cflags -frounding-math) # interval arithmetic needs it
set(pc_libs "")
if(CGAL_DISABLE_GMP)
  list(APPEND pc_cflags -DCGAL_DISABLE_GMP=1)
elseif(CGAL_USE_GMP)
  list(APPEND pc_libs -lmpfr -lgmp)
endif()
foreach(dir IN LISTS CGAL_INCLUDE_DIRS)
  if(EXISTS "${dir}/CGAL/version.h" AND NOT dir IN_LIST CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES)
    list(APPEND pc_cflags "-I${dir}")
  endif()
endforeach()
list(JOIN pc_cflags " " pc_cflags)
list(JOIN pc_libs " " pc_libs)

# pc_place(DATA_DIR): from the file itself, so that an installed copy can be moved; unless a folder is absolute.
macro(pc_place data_dir)
  if(IS_ABSOLUTE "${CMAKE_INSTALL_INCLUDEDIR}" OR IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}" OR IS_ABSOLUTE "${data_dir}")
    set(pc_prefix "${CMAKE_INSTALL_PREFIX}")
    set(pc_includedir "${CMAKE_INSTALL_FULL_INCLUDEDIR}")
    set(pc_libdir "${CMAKE_INSTALL_FULL_LIBDIR}")
  else()
    file(RELATIVE_PATH pc_prefix "/prefix/${data_dir}/pkgconfig" "/prefix")
    string(REGEX REPLACE "/$" "" pc_prefix "\${pcfiledir}/${pc_prefix}")
    set(pc_includedir "\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}")
    set(pc_libdir "\${prefix}/${CMAKE_INSTALL_LIBDIR}")
  endif()
endmacro()

pc_place("${CMAKE_INSTALL_DATADIR}")
configure_file("${CMAKE_CURRENT_LIST_DIR}/delaunay_from_surface_3.pc.in"
  "${PROJECT_BINARY_DIR}/delaunay_from_surface_3.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/delaunay_from_surface_3.pc"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/pkgconfig")

if(DELAUNAY_FROM_SURFACE_3_INSTALL_COMPILED)
  pc_place("${CMAKE_INSTALL_LIBDIR}")
  configure_file("${CMAKE_CURRENT_LIST_DIR}/delaunay_from_surface_3_compiled.pc.in"
    "${PROJECT_BINARY_DIR}/delaunay_from_surface_3_compiled.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/delaunay_from_surface_3_compiled.pc"
    DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
endif()
