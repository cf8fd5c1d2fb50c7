# SPDX-License-Identifier: BSD-3-Clause
# AmdMetis::amd_metis: AMD, which is a part of SuiteSparse, and METIS, which order the unknowns of matrices. AMD is taken from
# archives if they exist, as in Debian's libsuitesparse-dev: a library that is linked statically need not be
# found at each start.
include(NetloftArchives)
find_path(Amd_INCLUDE_DIR amd.h PATH_SUFFIXES suitesparse)
find_path(Metis_INCLUDE_DIR metis.h)
find_library(Metis_LIBRARY metis)
netloft_find_archives(Amd_LIBRARIES amd suitesparseconfig)
if(NOT Amd_LIBRARIES)
  find_library(Amd_LIBRARY amd)
  set(Amd_LIBRARIES ${Amd_LIBRARY})
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(AmdMetis REQUIRED_VARS Amd_INCLUDE_DIR Amd_LIBRARIES Metis_INCLUDE_DIR Metis_LIBRARY)
mark_as_advanced(Amd_INCLUDE_DIR Amd_LIBRARY Metis_INCLUDE_DIR Metis_LIBRARY)
if(AmdMetis_FOUND AND NOT TARGET AmdMetis::amd_metis)
  add_library(AmdMetis::amd_metis INTERFACE IMPORTED)
  set_target_properties(AmdMetis::amd_metis PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${Amd_INCLUDE_DIR};${Metis_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${Amd_LIBRARIES};${Metis_LIBRARY}")
endif()
