# SPDX-License-Identifier: BSD-3-Clause
# netloft_find_archives(OUT NAMES...): sets OUT to the static libraries of these names, in their order; to an
# empty list if one is missing, or where NETLOFT_ARCHIVES is OFF. Libraries that are linked statically need
# not be found, mapped and relocated whenever a program starts.
option(NETLOFT_ARCHIVES "Link numerical libraries statically where there are archives of them" ON)
function(netloft_find_archives out)
  set(${out} "" PARENT_SCOPE)
  set(archives "")
  foreach(name ${ARGN})
    find_library(NETLOFT_${name}_ARCHIVE lib${name}.a)
    mark_as_advanced(NETLOFT_${name}_ARCHIVE)
    list(APPEND archives ${NETLOFT_${name}_ARCHIVE})
  endforeach()
  if(NETLOFT_ARCHIVES AND NOT archives MATCHES "NOTFOUND")
    set(${out} ${archives} PARENT_SCOPE)
  endif()
endfunction()
