# SPDX-License-Identifier: BSD-3-Clause
# netloft_add_sundials(FOLDER ARCHIVES…): the adapter to a part of SUNDIALS, the plugin in that folder, built
# if SUNDIALS 6 has static libraries (Debian: libsundials-dev), which are linked into the plugin. ARCHIVES are
# the archives of that part; each must precede those that it uses.
function(netloft_add_sundials folder)
  cmake_parse_arguments(PARSE_ARGV 1 of "" "" "ARCHIVES")
  get_filename_component(name ${folder} NAME)
  find_path(SUNDIALS_INCLUDE_DIR sundials/sundials_context.h)
  mark_as_advanced(SUNDIALS_INCLUDE_DIR)
  set(found ${SUNDIALS_INCLUDE_DIR})
  set(archives)
  foreach(archive ${of_ARCHIVES} nvecserial generic)
    string(TOUPPER SUNDIALS_${archive}_ARCHIVE variable)
    find_library(${variable} libsundials_${archive}.a)
    mark_as_advanced(${variable})
    list(APPEND archives ${${variable}})
    if(NOT ${variable})
      set(found FALSE)
    endif()
  endforeach()
  if(NETLOFT_STATIC OR NOT found)
    return()
  endif()

  netloft_shipped_plugins(${folder})
  target_include_directories(${name} SYSTEM PRIVATE ${SUNDIALS_INCLUDE_DIR})
  target_link_libraries(${name} PRIVATE ${archives} m)
endfunction()
