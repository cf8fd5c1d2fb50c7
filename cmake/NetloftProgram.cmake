# SPDX-License-Identifier: BSD-3-Clause
# netloft_add_program(NAME SOURCES…): a program with Netloft's command line, plugins and BLAS, so that it
# computes the same bits.
include_guard(GLOBAL)
include(NetloftBlas)

function(netloft_add_program name)
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE netloft_command_line)
  # The dynamic linker looks a name up in one library after the other, in the order in which they were linked.
  # Among shared libraries OpenBLAS has 12 000 of the 15 000 names that are looked up when the program starts,
  # and the C++ library has most of the others: with these two first, the start takes half as many
  # instructions.
  set_property(TARGET ${name} PROPERTY NETLOFT_BLAS_ARCHIVE ON)
  find_library(NETLOFT_OPENBLAS openblas)
  mark_as_advanced(NETLOFT_OPENBLAS)
  if(NOT APPLE)
    if(NETLOFT_OPENBLAS AND NOT NETLOFT_OPENBLAS_ARCHIVE)
      set(first ${NETLOFT_OPENBLAS})
    endif()
    target_link_options(${name} PRIVATE LINKER:--push-state,--no-as-needed ${first} -lstdc++ LINKER:--pop-state)
  endif()
  if(NOT NETLOFT_STATIC)
    add_dependencies(${name} netloft_plugins_here)
    return()
  endif()
  get_property(plugins GLOBAL PROPERTY NETLOFT_STATIC_PLUGINS)
  foreach(plugin IN LISTS plugins)
    target_link_libraries(${name} PRIVATE netloft_plugin_${plugin})
  endforeach()
endfunction()
