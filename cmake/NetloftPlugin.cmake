# SPDX-License-Identifier: BSD-3-Clause
# netloft_add_plugin(NAME SOURCES…): one plugin, NAME.so, linked to nothing of ours but headers.
#
# On x86-64 it is built a second time for x86-64-v3 (AVX2, FMA) in a folder of that name beside it; the
# loader takes the newest build the processor runs. -ffp-contract=off keeps the results of all builds equal.
# With NETLOFT_STATIC the same sources go into the program under a symbol of their own.
include_guard(GLOBAL)

set(NETLOFT_PLUGIN_MAP ${CMAKE_CURRENT_LIST_DIR}/plugin.map CACHE INTERNAL "exports one symbol")
set(NETLOFT_PLUGIN_DIR ${CMAKE_BINARY_DIR}/lib/netloft CACHE INTERNAL "where plugins are built")
set_property(GLOBAL PROPERTY NETLOFT_STATIC_PLUGINS "")

function(netloft_add_plugin name)
  if(NETLOFT_STATIC)
    add_library(netloft_plugin_${name} OBJECT ${ARGN})
    netloft_plugin_flags(netloft_plugin_${name})
    target_compile_definitions(netloft_plugin_${name} PRIVATE NETLOFT_PLUGIN_SYMBOL=netloft_plugin_v1_${name})
    set_property(GLOBAL APPEND PROPERTY NETLOFT_STATIC_PLUGINS ${name})
    return()
  endif()
  netloft_add_module(${name} ${name} ${NETLOFT_PLUGIN_DIR} ${ARGN})
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    netloft_add_module(${name}_v3 ${name} ${NETLOFT_PLUGIN_DIR}/x86-64-v3 ${ARGN})
    target_compile_options(${name}_v3 PRIVATE -march=x86-64-v3)
    add_dependencies(${name} ${name}_v3)
  endif()
endfunction()

function(netloft_add_module target output folder)
  add_library(${target} MODULE ${ARGN})
  netloft_plugin_flags(${target})
  target_link_options(${target} PRIVATE -Wl,-z,defs -Wl,--version-script=${NETLOFT_PLUGIN_MAP})
  set_target_properties(${target} PROPERTIES PREFIX "" OUTPUT_NAME ${output} LIBRARY_OUTPUT_DIRECTORY ${folder})
endfunction()

function(netloft_plugin_flags target)
  target_link_libraries(${target} PRIVATE netloft::plugin)
  target_compile_options(${target} PRIVATE -ffp-contract=off -fno-math-errno -fno-trapping-math)
  set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
endfunction()
