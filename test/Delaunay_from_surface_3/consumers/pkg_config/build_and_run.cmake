# Builds the small consumer by what pkg-config says of an installed copy, and runs it: header-only, and with the core
# compiled.
# Input: PKG_CONFIG, PKG_CONFIG_FOLDER, VERSION, COMPILER, SOURCE, PROGRAM.

function(ask result package)
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -E env "PKG_CONFIG_PATH=${PKG_CONFIG_FOLDER}"
      "${PKG_CONFIG}" ${ARGN} ${package}
    OUTPUT_VARIABLE answer OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(answer UNIX_COMMAND "${answer}")
  set(${result} "${answer}" PARENT_SCOPE)
endfunction()

foreach(package delaunay_from_surface_3 delaunay_from_surface_3_compiled)
  ask(version ${package} --modversion)
  if(NOT version STREQUAL VERSION)
    message(FATAL_ERROR "pkg-config says version ${version} of ${package}, not ${VERSION}")
  endif()
  ask(cflags ${package} --cflags)
  ask(libs ${package} --libs)
  set(program "${PROGRAM}_${package}")
  execute_process( # two steps, since ccache serves the first alone
    COMMAND ${COMPILER} -std=c++17 -O0 ${cflags} -c "${SOURCE}" -o "${program}.o"
    COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${COMPILER} "${program}.o" -o "${program}" ${libs} COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND "${program}" COMMAND_ERROR_IS_FATAL ANY)
endforeach()
