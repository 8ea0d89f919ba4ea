# Builds the small consumer by what pkg-config says of an installed copy, and runs it.
# Input: PKG_CONFIG, PKG_CONFIG_FOLDER, VERSION, COMPILER, SOURCE, PROGRAM.

function(ask result)
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -E env "PKG_CONFIG_PATH=${PKG_CONFIG_FOLDER}"
      "${PKG_CONFIG}" ${ARGN} delaunay_from_surface_3
    OUTPUT_VARIABLE answer OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(answer UNIX_COMMAND "${answer}")
  set(${result} "${answer}" PARENT_SCOPE)
endfunction()

ask(version --modversion)
if(NOT version STREQUAL VERSION)
  message(FATAL_ERROR "pkg-config says version ${version}, not ${VERSION}")
endif()
ask(cflags --cflags)
ask(libs --libs)
execute_process( # two steps, since ccache serves the first alone
  COMMAND ${COMPILER} -std=c++17 -O0 ${cflags} -c "${SOURCE}" -o "${PROGRAM}.o"
  COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${COMPILER} "${PROGRAM}.o" -o "${PROGRAM}" ${libs} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${PROGRAM}" COMMAND_ERROR_IS_FATAL ANY)
