# SPDX-License-Identifier: BSD-3-Clause
# Udunits2::udunits2. Debian ships neither a CMake configuration nor a .pc file.
find_path(Udunits2_INCLUDE_DIR udunits2.h PATH_SUFFIXES udunits2 udunits)
find_library(Udunits2_LIBRARY udunits2)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Udunits2 REQUIRED_VARS Udunits2_INCLUDE_DIR Udunits2_LIBRARY)
mark_as_advanced(Udunits2_INCLUDE_DIR Udunits2_LIBRARY)
if(Udunits2_FOUND AND NOT TARGET Udunits2::udunits2)
  include(NetloftArchives)
  netloft_find_archives(Udunits2_ARCHIVES udunits2 expat)
  if(NOT Udunits2_ARCHIVES)
    set(Udunits2_ARCHIVES ${Udunits2_LIBRARY})
  endif()
  add_library(Udunits2::udunits2 INTERFACE IMPORTED)
  set_target_properties(Udunits2::udunits2 PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES ${Udunits2_INCLUDE_DIR}
    INTERFACE_LINK_LIBRARIES "${Udunits2_ARCHIVES};${CMAKE_DL_LIBS}")
endif()
