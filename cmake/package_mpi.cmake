# Defines the target Delaunay_from_surface_3::mpi, for CGAL/Tiles_by_mpi_3.h, where MPI is found; nothing else needs
# it.
#
# add_mpi_test(name RANKS number [LABELS fast|long] COMMAND program [argument…]): by so many processes, on this machine.

set(MPI_CXX_SKIP_MPICXX ON) # what is called is C
find_package(MPI QUIET COMPONENTS CXX)
# Open MPI wants to be told that there may be more processes than cores, and that root may start some.
set(DELAUNAY_FROM_SURFACE_3_MPI_ENVIRONMENT OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  OMPI_MCA_rmaps_base_oversubscribe=1 "PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe")

if(TARGET Delaunay_from_surface_3::mpi OR NOT MPI_CXX_FOUND)
  return()
endif()
add_library(Delaunay_from_surface_3_mpi INTERFACE)
add_library(Delaunay_from_surface_3::mpi ALIAS Delaunay_from_surface_3_mpi)
target_link_libraries(Delaunay_from_surface_3_mpi INTERFACE
  Delaunay_from_surface_3::Delaunay_from_surface_3 MPI::MPI_CXX)

function(add_mpi_test name)
  cmake_parse_arguments(arg "" "RANKS;LABELS" "COMMAND" ${ARGN})
  list(POP_FRONT arg_COMMAND program)
  add_test(NAME ${name} COMMAND "${MPIEXEC_EXECUTABLE}" "${MPIEXEC_NUMPROC_FLAG}" ${arg_RANKS} ${MPIEXEC_PREFLAGS}
    $<TARGET_FILE:${program}> ${MPIEXEC_POSTFLAGS} ${arg_COMMAND})
  set_tests_properties(${name} PROPERTIES LABELS "${arg_LABELS}" TIMEOUT 300 PROCESSORS ${arg_RANKS}
    ENVIRONMENT "${DELAUNAY_FROM_SURFACE_3_MPI_ENVIRONMENT}")
  if(arg_LABELS)
    add_dependencies(tests_${arg_LABELS} ${program})
  endif()
endfunction()
