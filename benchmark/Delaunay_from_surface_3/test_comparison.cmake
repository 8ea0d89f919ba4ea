# Runs compare_with_plain at small sizes, with all that it can measure, and looks at what it has written.
#
#   cmake -D PROGRAM=… -D PLAIN_PEER=… -D TETGEN_PEER=… -D PYTHON=… -D SCRIPT=… -D EXAMPLES=…
#         -D FOLDER=… -P test_comparison.cmake
#
# TETGEN_PEER and PYTHON may be empty: what needs them is then left out. SCRIPT is plot_results.py.
# FOLDER is emptied and written to.
cmake_minimum_required(VERSION 3.24)

include("${CMAKE_CURRENT_LIST_DIR}/../../cmake/test_checks.cmake")

macro(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${FOLDER}"
    RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE errors)
endmacro()

# refuses(MESSAGE argument…)
function(refuses message)
  run("${PROGRAM}" ${ARGN} --output refused.json)
  if(code STREQUAL "0" OR NOT errors MATCHES "compare_with_plain: [^\n]*${message}")
    fail("${ARGN}: exit code ${code}, not '${message}' but: ${errors}")
  endif()
  if(EXISTS "${FOLDER}/refused.json")
    fail("${ARGN}: it was refused and wrote all the same")
  endif()
endfunction()

# number(LOW HIGH key…): the number of `json` under these keys lies strictly between.
function(number low high)
  string(JSON value ERROR_VARIABLE error GET "${json}" ${ARGN})
  if(NOT error STREQUAL "NOTFOUND" OR NOT value GREATER low OR NOT value LESS high)
    fail("${ARGN}: ${value} is not between ${low} and ${high}")
  endif()
endfunction()

# is(EXPECTED key…)
function(is expected)
  string(JSON value ERROR_VARIABLE error GET "${json}" ${ARGN})
  if(NOT value STREQUAL expected)
    fail("${ARGN}: '${value}', not '${expected}'")
  endif()
endfunction()

# --- All that can be measured ------------------------------------------------------------------------

set(peers --peer "again=${PLAIN_PEER}" --peer broken=false --peer "mute=echo")
if(TETGEN_PEER)
  list(APPEND peers --peer "tetgen=${TETGEN_PEER}")
endif()
run("${PROGRAM}" --surfaces genus-3 sphere-exact-shuffled --sizes 2500 --repetitions 2 --memory --output all.json
  --methods plain-fast default default-fast compact-spatial nets plain-order tracing ${peers})
if(NOT code STREQUAL "0")
  fail("exit code ${code}: ${errors}")
endif()
file(READ "${FOLDER}/all.json" json)
is(genus-3 results 0 surface)
is(sphere-exact-shuffled results 1 surface)
foreach(surface 0 1)
  set(at results ${surface} methods)
  set(names plain plain-fast default default-fast compact-spatial nets plain-order tracing)
  foreach(m RANGE 7)
    list(GET names ${m} name)
    is(${name} ${at} ${m} method)
    is(ON ${at} ${m} equal)
    is(== ${at} ${m} equal_checked_by)
    number(0 100 ${at} ${m} median_cpu)
    number(0 1000 ${at} ${m} ratio_plain_to_method)
    number(0 1000 ${at} ${m} ratio_method_to_yardstick)
    number(300 10000 ${at} ${m} memory result_above_input_per_point)
    number(300 10000 ${at} ${m} memory peak_above_input_per_point)
  endforeach()
  foreach(m 2 3 4) # the compact triangulation
    number(0 100 ${at} ${m} stages build)
    number(0 100 ${at} ${m} stages export)
    number(0 100 ${at} ${m} phases seconds update)
  endforeach()
  foreach(m 2 4)
    number(1 200 ${at} ${m} kernel cells_tested_to_start)
    number(20 200 ${at} ${m} kernel sphere_tests)
  endforeach()
  foreach(m 5 6 7) # CGAL's insertion
    number(5 200 ${at} ${m} predicates update in_sphere)
  endforeach()
  # The order decides what is destroyed, whoever inserts; only the beginnings differ.
  foreach(pair "2;5" "4;6")
    list(GET pair 0 m)
    list(GET pair 1 n)
    string(JSON destroyed GET "${json}" ${at} ${n} cells destroyed)
    string(REGEX REPLACE "[.].*" "" low "${destroyed}")
    math(EXPR high "${low} + 2")
    math(EXPR low "${low} - 1")
    number(5 100 ${at} ${n} cells destroyed)
    number(${low} ${high} ${at} ${m} cells destroyed)
  endforeach()
  is(again ${at} 8 method)
  is(ON ${at} 8 has_as_many_tetrahedra)
  number(1000000 10000000000 ${at} 8 memory peak_bytes)
  is("exit code 1" ${at} 9 left_out)
  is("it does not print cpu_seconds and tetrahedra" ${at} 10 left_out)
  if(TETGEN_PEER)
    number(5000 50000 ${at} 11 tetrahedra)
  endif()
  number(0 100 results ${surface} yardstick verification)
  number(0 100 results ${surface} yardstick total)
endforeach()
# Cospherical points are where the first filter must give up.
number(0.1 100 results 1 methods 2 kernel first_filter_failures)

run("${PROGRAM}" --mesh "${EXAMPLES}/torus.off" --sizes 0 1000 --methods default --only-times --repetitions 1
  --output torus.json)
if(NOT code STREQUAL "0")
  fail("--mesh: exit code ${code}: ${errors}")
endif()
file(READ "${FOLDER}/torus.json" json)
is(torus results 0 surface)
is(960 results 0 points)
is(1000 results 1 points)

# --- What it refuses ---------------------------------------------------------------------------------

refuses("a peer is given as NAME=COMMAND, not as 'false'" --peer false)
refuses("'default' is a method" --peer default=false)
refuses("there is no surface 'moon'" --surfaces moon)
refuses("there is no method 'magic'" --methods magic)
refuses("--repetitions must be at least 1" --repetitions 0)
refuses("cannot open 'nowhere.off'" --mesh nowhere.off)

# --- What is made of the results ---------------------------------------------------------------------

if(PYTHON)
  run("${PYTHON}" -B "${SCRIPT}" all.json torus.json --tables --output-dir .)
  if(NOT code STREQUAL "0" OR NOT output MATCHES "\n[|] genus-3 [|] 2.44141k [|]")
    fail("plot_results.py: exit code ${code}: ${output}${errors}")
  endif()
  foreach(figure before_and_now ratio phases cells)
    if(NOT EXISTS "${FOLDER}/performance_${figure}.svg")
      fail("there is no performance_${figure}.svg")
    endif()
  endforeach()
endif()

finish_checks()
