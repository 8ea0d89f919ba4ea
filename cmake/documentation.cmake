# The target `doc`: the user and reference manual, as HTML in <build>/doc/html.

set(doxyfile_template "${PROJECT_SOURCE_DIR}/doc/Delaunay_from_surface_3/Doxyfile.in")
find_package(Doxygen QUIET)
if(DOXYGEN_FOUND AND EXISTS "${doxyfile_template}")
  set(DOC_OUTPUT_DIR "${PROJECT_BINARY_DIR}/doc")
  file(MAKE_DIRECTORY "${DOC_OUTPUT_DIR}")
  configure_file("${doxyfile_template}" "${DOC_OUTPUT_DIR}/Doxyfile" @ONLY)
  add_custom_target(doc
    COMMAND Doxygen::doxygen "${DOC_OUTPUT_DIR}/Doxyfile"
    WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}/doc/Delaunay_from_surface_3"
    COMMENT "Writing the manual to ${DOC_OUTPUT_DIR}"
    VERBATIM)
endif()
