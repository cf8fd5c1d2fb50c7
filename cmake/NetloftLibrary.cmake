# SPDX-License-Identifier: BSD-3-Clause
# netloft_library(NAME ROOMS folders… [ALONE sources…] [EXCEPT sources…] [PUBLIC libraries…] [PRIVATE libraries…]): a static
# library of all sources in these folders, which are relative to the calling folder (".").
#
# With NETLOFT_UNITY they are compiled as one source, because for most sources, reading headers and
# instantiating the same templates as other sources takes most of the time. Names without linkage must then be
# unique within a library. ALONE are sources that are compiled separately, because of their own options or
# large headers. EXCEPT are sources that the caller adds itself or leaves out.
include_guard(GLOBAL)

function(netloft_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "ROOMS;ALONE;EXCEPT;PUBLIC;PRIVATE")
  add_library(${name} STATIC)
  netloft_sources(${name} ROOMS ${arg_ROOMS} ALONE ${arg_ALONE} EXCEPT ${arg_EXCEPT})
  target_link_libraries(${name} PUBLIC netloft_root ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
endfunction()

# netloft_sources(TARGET ROOMS folders… [ENDING text] [ALONE sources…] [EXCEPT sources…]): the same for a
# target that exists already; ENDING, .cpp by default, chooses its sources. All sources of one call are
# compiled as one source.
function(netloft_sources target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "ENDING" "ROOMS;ALONE;EXCEPT")
  if(NOT arg_ENDING)
    set(arg_ENDING .cpp)
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${NETLOFT_UNITY} UNITY_BUILD_MODE GROUP)
  list(GET arg_ROOMS 0 first)
  string(MAKE_C_IDENTIFIER ${target}_${first} group)
  foreach(room IN LISTS arg_ROOMS)
    file(GLOB sources CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${room}/*${arg_ENDING})
    list(REMOVE_ITEM sources ${arg_EXCEPT} "")
    set_source_files_properties(${sources} PROPERTIES UNITY_GROUP ${group})
    target_sources(${target} PRIVATE ${sources})
  endforeach()
  if(arg_ALONE)
    set_source_files_properties(${arg_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
endfunction()
