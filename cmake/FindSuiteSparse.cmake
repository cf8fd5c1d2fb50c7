# SPDX-License-Identifier: BSD-3-Clause
# SuiteSparse::cholmod, SuiteSparse::umfpack. SuiteSparse 7 has configuration files of its own; 5.x has none.
find_package(CHOLMOD CONFIG QUIET)
find_package(UMFPACK CONFIG QUIET)
if(TARGET SuiteSparse::CHOLMOD AND TARGET SuiteSparse::UMFPACK)
  add_library(SuiteSparse::cholmod ALIAS SuiteSparse::CHOLMOD)
  add_library(SuiteSparse::umfpack ALIAS SuiteSparse::UMFPACK)
  set(SuiteSparse_FOUND TRUE)
  return()
endif()

# The archives where they all are, as in Debian's libsuitesparse-dev: of what takes no time to solve, a fifth was spent
# loading what shared libraries stand on. METIS, LAPACK and BLAS are shared.
include(NetloftBlas)
find_path(SuiteSparse_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(SuiteSparse_metis_LIBRARY metis)
netloft_find_archives(SuiteSparse_ARCHIVES umfpack cholmod amd colamd ccolamd camd suitesparseconfig)
if(SuiteSparse_ARCHIVES AND SuiteSparse_metis_LIBRARY AND NETLOFT_lapack_LIBRARY AND NETLOFT_blas_LIBRARY)
  set(SuiteSparse_LIBRARIES ${SuiteSparse_ARCHIVES} ${SuiteSparse_metis_LIBRARY} netloft_blas gomp m)
else()
  find_library(CHOLMOD_LIBRARY cholmod)
  find_library(UMFPACK_LIBRARY umfpack)
  find_library(SUITESPARSECONFIG_LIBRARY suitesparseconfig)
  if(CHOLMOD_LIBRARY AND UMFPACK_LIBRARY AND SUITESPARSECONFIG_LIBRARY)
    set(SuiteSparse_LIBRARIES ${CHOLMOD_LIBRARY} ${UMFPACK_LIBRARY} ${SUITESPARSECONFIG_LIBRARY})
  endif()
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SuiteSparse REQUIRED_VARS SuiteSparse_INCLUDE_DIR SuiteSparse_LIBRARIES)
mark_as_advanced(SuiteSparse_INCLUDE_DIR SuiteSparse_metis_LIBRARY)
if(SuiteSparse_FOUND AND NOT TARGET SuiteSparse::cholmod)
  foreach(part cholmod umfpack)
    add_library(SuiteSparse::${part} INTERFACE IMPORTED)
    set_target_properties(SuiteSparse::${part} PROPERTIES
      INTERFACE_INCLUDE_DIRECTORIES ${SuiteSparse_INCLUDE_DIR}
      INTERFACE_LINK_LIBRARIES "${SuiteSparse_LIBRARIES}")
  endforeach()
endif()
