# SPDX-License-Identifier: BSD-3-Clause
# netloft_add_ranks_module(SOURCES…): the module of MPI and parallel MUMPS, mpi/mumps_mpi.so in the folder of plugins, built
# where both are there (Debian: libmumps-dev) and the program has a MUMPS, whose inputs it prepares. The program opens it
# only under a launcher of MPI. Not under sanitizers: they would report on MPI.
function(netloft_add_ranks_module)
  if(NETLOFT_STATIC OR NOT NETLOFT_MUMPS OR NOT MumpsSeq_FOUND OR CMAKE_CXX_FLAGS MATCHES "-fsanitize")
    return()
  endif()
  find_package(MPI QUIET COMPONENTS C)
  find_library(MUMPS_MPI_LIBRARY dmumps)
  mark_as_advanced(MUMPS_MPI_LIBRARY)
  if(NOT MPI_C_FOUND OR NOT MUMPS_MPI_LIBRARY)
    return()
  endif()

  add_library(mumps_mpi MODULE ${ARGN})
  target_include_directories(mumps_mpi PRIVATE ${PROJECT_SOURCE_DIR})
  target_include_directories(mumps_mpi SYSTEM PRIVATE ${MumpsSeq_INCLUDE_DIR})
  target_compile_definitions(mumps_mpi PRIVATE OMPI_SKIP_MPICXX)
  target_link_libraries(mumps_mpi PRIVATE ${MUMPS_MPI_LIBRARY} MPI::MPI_C)
  target_link_options(mumps_mpi PRIVATE -Wl,-z,defs -Wl,--version-script=${PROJECT_SOURCE_DIR}/cmake/ranks.map)
  set_target_properties(mumps_mpi PROPERTIES PREFIX "" CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
                        LIBRARY_OUTPUT_DIRECTORY ${NETLOFT_PLUGIN_DIR}/mpi)
  add_dependencies(netloft_plugins mumps_mpi)
endfunction()
