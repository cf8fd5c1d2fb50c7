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

find_path(SuiteSparse_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
find_library(UMFPACK_LIBRARY umfpack)
find_library(SUITESPARSECONFIG_LIBRARY suitesparseconfig)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SuiteSparse REQUIRED_VARS SuiteSparse_INCLUDE_DIR CHOLMOD_LIBRARY
                                  UMFPACK_LIBRARY SUITESPARSECONFIG_LIBRARY)
if(SuiteSparse_FOUND AND NOT TARGET SuiteSparse::cholmod)
  foreach(part cholmod umfpack)
    string(TOUPPER ${part} upper)
    add_library(SuiteSparse::${part} UNKNOWN IMPORTED)
    set_target_properties(SuiteSparse::${part} PROPERTIES
      IMPORTED_LOCATION ${${upper}_LIBRARY}
      INTERFACE_INCLUDE_DIRECTORIES ${SuiteSparse_INCLUDE_DIR}
      INTERFACE_LINK_LIBRARIES ${SUITESPARSECONFIG_LIBRARY})
  endforeach()
endif()
