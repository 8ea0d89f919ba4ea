# What the tests in CMake's language share: an empty FOLDER, fail() and finish_checks().

file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
set_property(GLOBAL PROPERTY failures 0)

# Says what is wrong; the test goes on.
function(fail text)
  message("FAILED: ${text}")
  get_property(failures GLOBAL PROPERTY failures)
  math(EXPR failures "${failures} + 1")
  set_property(GLOBAL PROPERTY failures ${failures})
endfunction()

# To be called last: the test fails if a check has.
function(finish_checks)
  get_property(failures GLOBAL PROPERTY failures)
  if(failures GREATER 0)
    message(FATAL_ERROR "${failures} checks failed")
  endif()
endfunction()
