# Installs the package by the lines that README.md has for it, into PREFIX; what they build goes to BUILD_FOLDER.
# Input: PACKAGE_FOLDER, PREFIX, BUILD_FOLDER, OPTIONS, which are added to the first line.

file(REMOVE_RECURSE "${PREFIX}" "${BUILD_FOLDER}")
file(STRINGS "${PACKAGE_FOLDER}/README.md" lines REGEX "^ +cmake --(preset install|build --preset install|install)( |$)")
list(LENGTH lines count)
if(NOT count EQUAL 3)
  message(FATAL_ERROR "README.md has ${count} lines to install the package by: ${lines}")
endif()

list(GET lines 0 configure)
list(GET lines 1 build)
list(GET lines 2 install)
if(NOT build MATCHES "cmake --build --preset install$")
  message(FATAL_ERROR "the second line does not build: ${build}")
endif()
if(NOT install MATCHES " build/install$")
  message(FATAL_ERROR "the preset builds in build/install, README.md installs by: ${install}")
endif()
separate_arguments(configure UNIX_COMMAND "${configure}")
separate_arguments(install UNIX_COMMAND "${install}")
list(TRANSFORM configure REPLACE "^PREFIX$" "${PREFIX}")
list(TRANSFORM install REPLACE "^build/install$" "${BUILD_FOLDER}")
execute_process(COMMAND ${configure} -B "${BUILD_FOLDER}" ${OPTIONS}
  WORKING_DIRECTORY "${PACKAGE_FOLDER}" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${BUILD_FOLDER}" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${install} WORKING_DIRECTORY "${PACKAGE_FOLDER}" COMMAND_ERROR_IS_FATAL ANY)
