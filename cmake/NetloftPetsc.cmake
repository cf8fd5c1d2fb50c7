# SPDX-License-Identifier: BSD-3-Clause
# netloft_add_petsc(NAME SOURCES…): the adapter to a part of PETSc, in the folder that calls, built where PETSc 3.18 and its
# MPI are there (Debian: libpetsc-real-dev). Not under sanitizers: they would report on MPI.
function(netloft_add_petsc name)
  find_package(PkgConfig QUIET)
  if(NETLOFT_STATIC OR NOT PkgConfig_FOUND OR CMAKE_CXX_FLAGS MATCHES "-fsanitize")
    return()
  endif()
  pkg_check_modules(PETSC QUIET IMPORTED_TARGET petsc>=3.18)
  find_package(MPI QUIET COMPONENTS C)
  if(NOT PETSC_FOUND OR NOT MPI_C_FOUND)
    return()
  endif()

  netloft_add_plugin(${name} ${ARGN} ${PROJECT_SOURCE_DIR}/solvers/common/petsc.cpp)
  foreach(target ${name} ${name}_v3)
    if(TARGET ${target})
      target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
      target_link_libraries(${target} PRIVATE PkgConfig::PETSC MPI::MPI_C)
    endif()
  endforeach()
  add_dependencies(netloft_plugins ${name})
endfunction()
