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

# The target `figures`: draws the manual's figures anew, into the source tree where they are kept.
set(figures_dir "${PROJECT_SOURCE_DIR}/doc/Delaunay_from_surface_3/fig")
if(PROJECT_IS_TOP_LEVEL)
  foreach(program draw_steps draw_surface draw_subgraph)
    add_executable(${program} EXCLUDE_FROM_ALL "${figures_dir}/${program}.cpp")
    target_link_libraries(${program} PRIVATE Delaunay_from_surface_3_generator)
  endforeach()
  add_custom_target(figures
    COMMAND draw_steps "${figures_dir}"
    COMMAND draw_subgraph "${figures_dir}"
    COMMAND draw_surface
      "${DELAUNAY_FROM_SURFACE_3_DATA_DIR}/elephant.off" "${figures_dir}/teaser.svg"
    COMMENT "Drawing the figures of the manual"
    VERBATIM)
endif()
