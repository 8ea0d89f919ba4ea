# The pages of the manual that show measured results have the tables that their scripts make of the committed JSON.
#
#   cmake -D PYTHON=… -D BENCHMARK=… -D MANUAL=… -D FOLDER=… -P test_manual_tables.cmake
#
# BENCHMARK is the folder of the scripts and of results/, MANUAL that of the pages. FOLDER is emptied and written to.
cmake_minimum_required(VERSION 3.24)

include("${CMAKE_CURRENT_LIST_DIR}/../../cmake/test_checks.cmake")

# check(PAGE SCRIPT PATTERN…): the patterns name the files in results/.
function(check page script)
  list(TRANSFORM ARGN PREPEND "${BENCHMARK}/results/")
  file(GLOB results ${ARGN})
  set(command "${PYTHON}" -B "${BENCHMARK}/${script}" ${results} --manual)
  execute_process(COMMAND ${command} "${MANUAL}/${page}" --check RESULT_VARIABLE code ERROR_VARIABLE errors)
  if(NOT code STREQUAL "0")
    fail("${page}: exit code ${code}: ${errors}")
  endif()

  # A stale figure, and a table without its place, are seen; the first is made good again.
  file(READ "${MANUAL}/${page}" text)
  string(REGEX REPLACE "[0-9] [|]\n\n<!-- end" "x |\n\n<!-- end" stale "${text}")
  string(REGEX REPLACE "<!-- [a-z]" "<!-- a" misplaced "${text}")
  set(copy "${FOLDER}/${page}")
  foreach(change stale misplaced)
    file(WRITE "${copy}" "${${change}}")
    execute_process(COMMAND ${command} "${copy}" --check RESULT_VARIABLE code ERROR_VARIABLE errors)
    if(NOT code STREQUAL "1" OR NOT errors MATCHES "${script}: ")
      fail("${page}, ${change}: exit code ${code}: ${errors}")
    endif()
  endforeach()
  file(WRITE "${copy}" "${stale}")
  execute_process(COMMAND ${command} "${copy}" RESULT_VARIABLE code ERROR_VARIABLE errors)
  file(READ "${copy}" refilled)
  if(NOT code STREQUAL "0" OR NOT refilled STREQUAL text)
    fail("${page}, refilled: exit code ${code}: ${errors}")
  endif()
endfunction()

check(Performance.txt plot_results.py compare_*.json paper_*.json)
check(Theory.txt plot_location_costs.py location_costs.json)
check(bounded_degree_subgraphs.txt subgraph_tables.py subgraph_*.json)

finish_checks()
