# The target `doc`: the user and reference manual, as HTML in <build>/doc/html.

set(DELAUNAY_FROM_SURFACE_3_DOC_TAGFILES "" CACHE STRING
  "Tag files of other manuals that this one links, as CGAL's: FILE=URL;FILE=URL…")
set(DELAUNAY_FROM_SURFACE_3_MATHJAX "/usr/share/javascript/mathjax" CACHE PATH
  "MathJax 2, which draws the manual's formulas: a folder with MathJax.js, as Debian's package libjs-mathjax has it")
set(DELAUNAY_FROM_SURFACE_3_LIVE_PAGE "" CACHE FILEPATH
  "The live page, as scripts/live makes it, for the front page of the manual; empty for none")

find_package(Doxygen QUIET)
find_package(Python3 COMPONENTS Interpreter QUIET)
if(DOXYGEN_FOUND AND Python3_FOUND)
  set(DOC_OUTPUT_DIR "${PROJECT_BINARY_DIR}/doc")
  set(CGAL_PACKAGE_DIR "${PROJECT_SOURCE_DIR}")
  if(DELAUNAY_FROM_SURFACE_3_LIVE_PAGE)
    set(DOC_SECTIONS ALL_PAGES)
    set(copy_live_page COMMAND "${CMAKE_COMMAND}" -E copy "${DELAUNAY_FROM_SURFACE_3_LIVE_PAGE}" "${DOC_OUTPUT_DIR}/html/live.html")
  endif()
  include("${CMAKE_CURRENT_LIST_DIR}/configure_manual.cmake")
  add_custom_target(doc
    COMMAND Doxygen::doxygen "${DOC_OUTPUT_DIR}/Doxyfile"
    COMMAND Python3::Interpreter -B "${CGAL_PACKAGE_DOC_DIR}/finish_pages.py" "${DOC_OUTPUT_DIR}/html"
      "${DELAUNAY_FROM_SURFACE_3_MATHJAX}"
    ${copy_live_page}
    WORKING_DIRECTORY "${CGAL_PACKAGE_DOC_DIR}"
    COMMENT "Writing the manual to ${DOC_OUTPUT_DIR}"
    VERBATIM)
else()
  message(STATUS "skipped: the manual, as Doxygen or Python was not found")
endif()

# The target `figures`: draws the manual's drawings anew, into the source tree where they are kept.
set(figures_dir "${PROJECT_SOURCE_DIR}/doc/Delaunay_from_surface_3/fig")
if(PROJECT_IS_TOP_LEVEL)
  foreach(program draw_steps draw_subgraph write_scenes)
    add_executable(${program} EXCLUDE_FROM_ALL "${figures_dir}/${program}.cpp")
    target_link_libraries(${program} PRIVATE Delaunay_from_surface_3_generator)
  endforeach()
  add_custom_target(figures
    COMMAND draw_steps "${figures_dir}"
    COMMAND draw_subgraph "${figures_dir}"
    COMMENT "Drawing the figures of the manual"
    VERBATIM)
endif()

# The target `renders`: the pictures of real meshes, from what the programs write. It needs Python with VTK 9, NumPy and
# Pillow, and xvfb-run; elsewhere there is no such target.
find_program(DELAUNAY_FROM_SURFACE_3_XVFB_RUN xvfb-run)
if(PROJECT_IS_TOP_LEVEL AND DELAUNAY_FROM_SURFACE_3_XVFB_RUN AND DELAUNAY_FROM_SURFACE_3_BUILD_PROGRAMS
    AND DELAUNAY_FROM_SURFACE_3_BUILD_EXAMPLES)
  set(scenes "${PROJECT_BINARY_DIR}/scenes")
  set(data "${DELAUNAY_FROM_SURFACE_3_DATA_DIR}")
  add_custom_target(renders
    COMMAND "${CMAKE_COMMAND}" -E make_directory "${scenes}"
    COMMAND delaunay_from_surface "${data}/elephant.off" --mark-inside --quiet --output "${scenes}/elephant.vtu"
    COMMAND delaunay_from_surface "${data}/refined_elephant.off" --mark-inside --quiet --output "${scenes}/fine.vtu"
    COMMAND "${CMAKE_COMMAND}" -E copy "${data}/elephant.off" "${scenes}/elephant.off"
    COMMAND write_scenes "${data}/elephant.off" "${scenes}"
    COMMAND generate_surface --shape genus --genus 3 --vertices 4000 --jitter 0.05 --output "${scenes}/genus_3.off"
    COMMAND write_cut_and_subgraph "${scenes}/genus_3.off" "${scenes}/cut.vtk"
    COMMAND reconstruct_surface "${data}/elephant.off" "${scenes}/elephant_surface.off"
    COMMAND "${DELAUNAY_FROM_SURFACE_3_XVFB_RUN}" -a /usr/bin/python3 -B "${figures_dir}/render.py"
      "${scenes}" "${figures_dir}"
    COMMENT "Rendering the pictures of the manual"
    VERBATIM)
endif()
