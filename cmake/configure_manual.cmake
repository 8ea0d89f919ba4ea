# Writes <DOC_OUTPUT_DIR>/Doxyfile: what CGAL's build does for each of its packages, for a manual on its own.
# Input: CGAL_PACKAGE_DIR, DOC_OUTPUT_DIR, PROJECT_VERSION, DELAUNAY_FROM_SURFACE_3_DOC_TAGFILES, DOXYGEN_VERSION.

set(CGAL_PACKAGE_DOC_DIR "${CGAL_PACKAGE_DIR}/doc/Delaunay_from_surface_3")
set(CGAL_DOC_PACKAGE_DEFAULTS "${DOC_OUTPUT_DIR}/standalone.dxy")
list(TRANSFORM DELAUNAY_FROM_SURFACE_3_DOC_TAGFILES REPLACE "^(.+)$" "\"\\1\"" OUTPUT_VARIABLE DOC_TAGFILES)
list(JOIN DOC_TAGFILES " " DOC_TAGFILES)

configure_file("${CGAL_PACKAGE_DOC_DIR}/standalone.dxy.in" "${DOC_OUTPUT_DIR}/standalone.dxy")
configure_file("${CGAL_PACKAGE_DOC_DIR}/Doxyfile.in" "${DOC_OUTPUT_DIR}/package.dxy")
# From 1.9.5 on pages are dark where readers prefer that. The style sheet and the drawings are made for light ones.
if(DOXYGEN_VERSION VERSION_GREATER_EQUAL 1.9.5)
  set(DOC_COLOR_STYLE "HTML_COLORSTYLE = LIGHT")
endif()
file(CONFIGURE OUTPUT "${DOC_OUTPUT_DIR}/Doxyfile" CONTENT
"@INCLUDE = ${DOC_OUTPUT_DIR}/package.dxy
PROJECT_NAME = Delaunay_from_surface_3
PROJECT_NUMBER = ${PROJECT_VERSION}
PROJECT_BRIEF = \"3D Delaunay triangulations of points and surfaces\"
${DOC_COLOR_STYLE}
")
