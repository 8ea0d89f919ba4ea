# Runs the program delaunay_from_surface as a user would, and checks exit codes, output and files.
#
#   cmake -D PROGRAM=… -D EXAMPLES=… -D DATA=… -D FOLDER=… -P test_program.cmake
#
# EXAMPLES is the folder of the examples' data, DATA that of the tests'; FOLDER is emptied and written to.
cmake_minimum_required(VERSION 3.24)

include("${CMAKE_CURRENT_LIST_DIR}/../../cmake/test_checks.cmake")

# works(ARGS argument… PRINTS regular-expression… [NOTES regular-expression])
# The program ends with 0, prints what is expected, and writes to the standard error nothing or NOTES.
function(works)
  cmake_parse_arguments(arg "" "NOTES" "ARGS;PRINTS" ${ARGN})
  execute_process(COMMAND "${PROGRAM}" ${arg_ARGS} WORKING_DIRECTORY "${FOLDER}"
    RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  if(NOT code STREQUAL "0")
    fail("${arg_ARGS}: exit code ${code}, not 0: ${errors}")
  endif()
  foreach(expected IN LISTS arg_PRINTS)
    if(NOT output MATCHES "${expected}")
      fail("${arg_ARGS}: '${expected}' is not in the output:\n${output}")
    endif()
  endforeach()
  if(NOT errors MATCHES "^${arg_NOTES}$")
    fail("${arg_ARGS}: the standard error is not '${arg_NOTES}' but:\n${errors}")
  endif()
endfunction()

# refuses(MESSAGE ARGS argument…)
# The program ends with 1 and writes one line to the standard error, which begins with "error: MESSAGE".
function(refuses message)
  cmake_parse_arguments(arg "" "" "ARGS" ${ARGN})
  execute_process(COMMAND "${PROGRAM}" ${arg_ARGS} WORKING_DIRECTORY "${FOLDER}"
    RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  if(NOT code STREQUAL "1")
    fail("${arg_ARGS}: exit code ${code}, not 1: ${errors}")
  endif()
  if(NOT errors MATCHES "^error: ${message}[^\n]*\n$")
    fail("${arg_ARGS}: the standard error is not 'error: ${message}' but:\n${errors}")
  endif()
endfunction()

function(write name)
  list(JOIN ARGN "\n" text)
  file(WRITE "${FOLDER}/${name}" "${text}\n")
endfunction()

# --- What it says about itself -------------------------------------------------------------------------

works(ARGS --help PRINTS "Usage: delaunay_from_surface SURFACE" "Example.*--compare" "Exit code")
works(ARGS --version PRINTS "^delaunay_from_surface [0-9]+[.][0-9]+[.][0-9]+ [(]CGAL [0-9.]+")

# --- A mesh, by all traits -----------------------------------------------------------------------------

set(torus "${EXAMPLES}/torus.off")
foreach(traits default tracing plain)
  works(ARGS "${torus}" --traits ${traits} --seed 3 --compare --repetitions 2 --stats
    PRINTS "\nsurface: +triangle mesh\n" "\ntraits: +${traits}\n" "\nseed: +3\n" "\ndimension: +3\n"
           "\nvertices: +960\n" "\nduplicates: +0\n" "\nfinite cells: +8317\n" "\nrepetitions: +2\n"
           "\npackage CPU seconds: +[0-9.]+\n" "\nplain CPU seconds: +[0-9.]+\n" "\nCPU ratio: +[0-9.]+\n"
           "\nwall ratio: +[0-9.]+\n" "\nequal: +yes\n" "\nDelaunay edges: +2880 of 2880 "
           "\nDelaunay triangles: +1920 of 1920 " "\nlocate: +[0-9.]+\n" "\nall +locate +960 "
           "\nall +update +960 ")
endforeach()
works(ARGS "${torus}" --traits tracing --stats PRINTS "\n1 +trace +[0-9]+ " "\nall +trace +[0-9]+ ")
works(ARGS "${torus}" PRINTS "\nfinite cells: +8317\n" "cells: +[0-9]+\n$") # and nothing after that

# --- Surfaces that are less than a mesh of triangles ---------------------------------------------------

set(soup_note "note: [a-z_]+[.][a-z]+: not a consistently oriented manifold mesh, taken as a polygon soup\n")

# A rhombus with the wrong diagonal: the edge 0-1 and both triangles are not Delaunay.
write(rhombus.off OFF "6 2 0" "-2 0 0" "2 0 0" "0 1 0" "0 -1 0" "0 0 5" "0 0 -5" "3 0 1 2" "3 1 0 3")
works(ARGS rhombus.off --compare --stats
  PRINTS "surface: +triangle mesh\n" "\nother edges: +1 of 5 [(]20[.]0000 %[)]\n"
         "\nDelaunay triangles: +0 of 2 " "\nother triangles: +2 of 2 " "\nequal: +yes\n")

write(flat.off OFF "4 2 0" "-2 0 0" "2 0 0" "0 1 0" "0 -1 0" "3 0 1 2" "3 1 0 3")
works(ARGS flat.off --compare --stats --output flat.vtu
  PRINTS "\ndimension: +2\n" "\nwritten: +2 triangles to flat.vtu\n" "\nother edges: +1 of 5 " "\nequal: +yes\n")

write(three_sheets.off OFF "5 3 0" "0 0 0" "0 0 1" "1 0 0" "-1 1 0" "-1 -1 0" "3 0 1 2" "3 0 1 3" "3 0 1 4")
works(ARGS three_sheets.off --compare --stats
  PRINTS "\nsurface: +polygon soup\n" "\nDelaunay triangles: +3 of 3 " "\nequal: +yes\n"
  NOTES "note: faces that are not triangles: 0, edges with more than two faces: 1\n${soup_note}")

write(polygons.off OFF "5 2 0" "0 0 0" "1 0 0" "1 1 0" "0 1 0" "2 0 1" "4 0 1 2 3" "3 1 4 2")
works(ARGS polygons.off --compare --stats
  PRINTS "\nsurface: +polygon mesh\n" "\nDelaunay edges: +6 of 6 " "\nDelaunay triangles: +1 of 1 "
         "\npolygons: +1 [(]not counted as triangles[)]\n" "\nequal: +yes\n"
  NOTES "note: faces that are not triangles: 1\n")

# Vertices 1 and 3, 2 and 4 are the same points: two triangles with one edge in common.
write(seam.off OFF "7 2 0" "0 0 0" "1 0 0" "0 1 0" "1 0 0" "0 1 0" "1 1 0" "0 0 1" "3 0 1 2" "3 3 5 4")
works(ARGS seam.off --compare --stats --output seam.mesh
  PRINTS "\nsurface vertices: +7\n" "\nvertices: +5\n" "\nduplicates: +2\n" "\nDelaunay edges: +5 of 5 " "\nequal: +yes\n")

write(points.off OFF "3 0 0" "0 0 0" "1 0 0" "5 0 0")
works(ARGS points.off --compare --stats --output points.mesh
  PRINTS "\nsurface: +points without faces\n" "\ndimension: +1\n" "\nDelaunay edges: +not counted in dimension 1\n"
         "\nwritten: +2 edges to points.mesh\n" "\nequal: +yes\n"
  NOTES "note: points.off: there are no faces, its points are taken alone\n")

write(same.off OFF "2 0 0" "1 2 3" "1 2 3")
works(ARGS same.off --compare --stats --output same.vtu
  PRINTS "\ndimension: +0\n" "\nduplicates: +1\n" "\nequal: +yes\n" NOTES "note: same.off: there are no faces[^\n]*\n")

# --- The other formats ---------------------------------------------------------------------------------

write(tetrahedron.obj "v 0 0 0" "v 1 0 0" "v 0 1 0" "v 0 0 1" "f 1 3 2" "f 1 2 4" "f 2 3 4" "f 3 1 4")
write(tetrahedron.PLY ply "format ascii 1.0" "element vertex 4" "property double x" "property double y"
  "property double z" "element face 2" "property list uchar int vertex_indices" end_header
  "0 0 0" "1 0 0" "0 1 0" "0 0 1" "3 0 2 1" "3 0 1 3")
write(tetrahedron.stl "solid t" "facet normal 0 0 0" "outer loop" "vertex 0 0 0" "vertex 0 1 0" "vertex 1 0 0"
  endloop endfacet "facet normal 0 0 0" "outer loop" "vertex 0 0 0" "vertex 1 0 0" "vertex 0 0 1"
  endloop endfacet "endsolid t")
foreach(extension obj PLY stl)
  works(ARGS tetrahedron.${extension} --compare --output tetrahedron.mesh
    PRINTS "\nsurface: +triangle mesh\n" "\nvertices: +4\n" "\nfinite cells: +1\n" "\nequal: +yes\n")
endforeach()

# --- What it writes ------------------------------------------------------------------------------------

works(ARGS tetrahedron.obj -o tetrahedron.mesh PRINTS "\nwritten: +1 tetrahedra to tetrahedron.mesh\n$")
file(READ "${FOLDER}/tetrahedron.mesh" medit)
if(NOT medit MATCHES "^MeshVersionFormatted 2\nDimension 3\n\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n\nTetrahedra\n1\n[1-4] [1-4] [1-4] [1-4] 0\n\nEnd\n$")
  fail("tetrahedron.mesh is not what it should be:\n${medit}")
endif()

works(ARGS "${torus}" --output torus.vtu PRINTS "\nwritten: +8317 tetrahedra to torus.vtu\n$")
file(STRINGS "${FOLDER}/torus.vtu" piece REGEX "<Piece NumberOfPoints=\"960\" NumberOfCells=\"8317\">")
if(NOT piece)
  fail("torus.vtu has no Piece of 960 points and 8317 cells")
endif()
# Four arrays of 8 + size bytes follow the underscore: coordinates, corners, ends and types.
file(READ "${FOLDER}/torus.vtu" bytes HEX)
string(FIND "${bytes}" "22726177223e5f" raw) # "raw">_
file(SIZE "${FOLDER}/torus.vtu" size)
math(EXPR expected "${raw} / 2 + 7 + 4 * 8 + 960 * 24 + 8317 * (32 + 8 + 1) + 30") # 30: the closing tags
if(NOT size EQUAL expected)
  fail("torus.vtu has ${size} bytes, not ${expected}")
endif()

# --- What it refuses -----------------------------------------------------------------------------------

refuses("no surface given")
refuses("unrecognised option '--bogus'" ARGS --bogus)
refuses("unrecognised option '--comp'" ARGS "${torus}" --comp)
refuses("too many positional options" ARGS "${torus}" "${torus}")
refuses("unknown traits 'fast'" ARGS "${torus}" --traits fast)
refuses("option '--seed' needs a whole number" ARGS "${torus}" --seed -1)
refuses("option '--seed' needs a whole number" ARGS "${torus}" --seed 4294967296)
refuses("the argument [(]'one'[)] for option '--seed' is invalid" ARGS "${torus}" --seed one)
refuses("option '--repetitions' needs '--compare'" ARGS "${torus}" --repetitions 3)
refuses("option '--repetitions' needs a whole number" ARGS "${torus}" --compare --repetitions 0)

refuses("missing[.]off: No such file" ARGS missing.off)
refuses("[.]: unknown extension" ARGS .)
file(MAKE_DIRECTORY "${FOLDER}/folder.off")
refuses("folder[.]off: is a directory" ARGS folder.off)
write(points.xyz "0 0 0")
refuses("points[.]xyz: unknown extension" ARGS points.xyz)
file(TOUCH "${FOLDER}/empty.off")
refuses("empty[.]off: the file is empty" ARGS empty.off)
write(no_vertices.off OFF "0 0 0")
refuses("no_vertices[.]off: there are no vertices" ARGS no_vertices.off)
write(words.off "once upon a time")
refuses("words[.]off: cannot be read as [.]off" ARGS words.off)
write(short.off OFF "4 1 0" "0 0 0" "1 0 0")
refuses("short[.]off: cannot be read as [.]off" ARGS short.off)
write(nan.off OFF "3 1 0" "0 0 0" "1 0 0" "0 nan 0" "3 0 1 2")
refuses("nan[.]off: cannot be read as [.]off" ARGS nan.off)
refuses("[^ ]*nan[.]ply: vertex 3: its y coordinate is not a finite number" ARGS "${DATA}/nan.ply")
refuses("[^ ]*inf[.]ply: vertex 3: its z coordinate is not a finite number" ARGS "${DATA}/inf.ply")
refuses("[^ ]*nan[.]stl: triangle 4: a coordinate is not a finite number" ARGS "${DATA}/nan.stl")
refuses("[^ ]*negative_index[.]ply: face 0: it has a vertex that is not one of the 4" ARGS "${DATA}/negative_index.ply")
write(index.obj "v 0 0 0" "v 1 0 0" "v 0 1 0" "f 1 2 3" "f 1 2 4")
refuses("index[.]obj: face 1: it has a vertex that is not one of the 3" ARGS index.obj)

refuses("torus[.]vtk: unknown extension" ARGS "${torus}" --output torus.vtk)
refuses("nowhere/torus[.]vtu: cannot be written" ARGS "${torus}" --output nowhere/torus.vtu)
file(MAKE_DIRECTORY "${FOLDER}/folder.vtu")
refuses("folder[.]vtu: cannot be written" ARGS "${torus}" --output folder.vtu)

# An error leaves the older output alone and nothing new behind.
file(READ "${FOLDER}/tetrahedron.mesh" before)
refuses("missing[.]off" ARGS missing.off --output tetrahedron.mesh)
refuses("missing[.]off" ARGS missing.off --output never.vtu)
file(READ "${FOLDER}/tetrahedron.mesh" after)
if(NOT after STREQUAL before)
  fail("an error has changed an older output")
endif()
file(GLOB left_behind "${FOLDER}/*.part" "${FOLDER}/never.vtu")
if(left_behind)
  fail("left behind: ${left_behind}")
endif()

# A full disk is simulated where the system can.
if(EXISTS /dev/full)
  execute_process(COMMAND "${PROGRAM}" "${torus}" OUTPUT_FILE /dev/full RESULT_VARIABLE code ERROR_VARIABLE errors)
  if(NOT code STREQUAL "1" OR NOT errors MATCHES "^error: the results cannot be written[^\n]*\n$")
    fail("a full standard output: exit code ${code}, ${errors}")
  endif()
endif()

finish_checks()
