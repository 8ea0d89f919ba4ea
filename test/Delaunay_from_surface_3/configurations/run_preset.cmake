# Configures, builds and tests one preset of the project. Input: PRESET, CTEST_COMMAND.

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

if(PRESET MATCHES "clang|sanitize")
  find_program(clang clang++)
  if(NOT clang)
    message("skipped: configuration ${PRESET}, there is no clang++")
    return()
  endif()
endif()
if(PRESET MATCHES "^cgal-([0-9.]+|sid)")
  set(tree "build/cgal/${CMAKE_MATCH_1}")
  if(NOT EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${tree}/usr/include/CGAL/version.h")
    message("skipped: configuration ${PRESET}, there is no CGAL in ${tree}")
    return()
  endif()
endif()

run("${CMAKE_COMMAND}" --preset ${PRESET})
run("${CMAKE_COMMAND}" --build --preset ${PRESET} --parallel 1)
run("${CTEST_COMMAND}" --preset ${PRESET})
