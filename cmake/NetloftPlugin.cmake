# SPDX-License-Identifier: BSD-3-Clause
# netloft_add_plugin(NAME SOURCES… [TESTS sources…] [SCENES files…]): one plugin, NAME.so, which uses none of
# our libraries, only headers. -ffp-contract=off keeps the results of all builds equal.
#
# In this tree it goes to the folder of plugins, and on x86-64 it is built a second time for x86-64-v3 (AVX2, FMA)
# in a folder of that name beside it; the loader takes the newest build that the processor can run. With
# NETLOFT_STATIC, the same sources are linked into the program under their own symbol.
#
# netloft_shipped_plugins(FOLDERS…) does this for folders of this tree: all sources of a folder are the plugin
# of its name, and may include headers by path. The caller sets NETLOFT_X86_64_V3 to OFF if no kernel would
# gain by the second build. The target netloft_plugins has all builds of all of them, netloft_plugins_here the
# one that this processor runs.
#
# After find_package(netloft), the plugin is written to the build folder, for any processor; NETLOFT_X86_64_V3
# adds the other build. `ctest` then checks it by `netloft test`, and runs each of TESTS and, with the plugin,
# each of SCENES.
include_guard(GLOBAL)

set_property(GLOBAL PROPERTY NETLOFT_STATIC_PLUGINS "")
set(netloft_runs_x86_64_v3 FALSE)
if(EXISTS /proc/cpuinfo)
  file(STRINGS /proc/cpuinfo netloft_runs_x86_64_v3 REGEX "^flags.* fma .* avx2 .*bmi2 " LIMIT_COUNT 1)
endif()

function(netloft_add_plugin name)
  cmake_parse_arguments(arg "" "" "TESTS;SCENES" ${ARGN})
  if(NOT arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "netloft_add_plugin(${name}): name the sources of the plugin, such as ${name}.cpp")
  endif()
  if(NETLOFT_STATIC)
    netloft_add_static_plugin(${name} ${arg_UNPARSED_ARGUMENTS})
    return()
  endif()
  netloft_plugin_folder(folder)
  netloft_add_module(${name} ${name} ${folder} ${arg_UNPARSED_ARGUMENTS})
  if(NETLOFT_X86_64_V3 AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    netloft_add_module(${name}_v3 ${name} ${folder}/x86-64-v3 ${arg_UNPARSED_ARGUMENTS})
    target_compile_options(${name}_v3 PRIVATE -march=x86-64-v3)
  endif()
  if(TARGET netloft::program)
    netloft_add_plugin_tests(${name})
  endif()
endfunction()

function(netloft_shipped_plugins)
  foreach(folder IN LISTS ARGN)
    get_filename_component(name ${folder} NAME)
    file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
    netloft_add_plugin(${name} ${sources})
    foreach(target ${name} ${name}_v3 netloft_plugin_${name})
      if(TARGET ${target})
        target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
        set_target_properties(${target} PROPERTIES UNITY_BUILD ${NETLOFT_UNITY} UNITY_BUILD_BATCH_SIZE 0)
      endif()
    endforeach()
    if(TARGET ${name}_v3)
      add_dependencies(netloft_plugins ${name}_v3)
    endif()
    if(TARGET ${name}_v3 AND netloft_runs_x86_64_v3)
      add_dependencies(netloft_plugins_here ${name}_v3)
    elseif(TARGET ${name})
      add_dependencies(netloft_plugins_here ${name})
    endif()
    if(TARGET ${name})
      add_dependencies(netloft_plugins ${name})
    endif()
  endforeach()
endfunction()

function(netloft_add_static_plugin name)
  add_library(netloft_plugin_${name} OBJECT ${ARGN})
  netloft_plugin_flags(netloft_plugin_${name})
  target_compile_definitions(netloft_plugin_${name} PRIVATE NETLOFT_PLUGIN_SYMBOL=netloft_plugin_v1_${name})
  set_property(GLOBAL APPEND PROPERTY NETLOFT_STATIC_PLUGINS ${name})
endfunction()

function(netloft_plugin_folder result)
  set(folder ${CMAKE_CURRENT_BINARY_DIR})
  if(NETLOFT_PLUGIN_DIR)
    set(folder ${NETLOFT_PLUGIN_DIR})
  endif()
  set(${result} ${folder} PARENT_SCOPE)
endfunction()

function(netloft_add_module target output folder)
  add_library(${target} MODULE ${ARGN})
  netloft_plugin_flags(${target})
  # A sanitizer of clang is linked into the program only; plugins find it there when they are opened.
  set(complete -Wl,-z,defs)
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang" AND CMAKE_CXX_FLAGS MATCHES "-fsanitize")
    set(complete "")
  endif()
  target_link_options(${target} PRIVATE ${complete} -Wl,--version-script=${CMAKE_CURRENT_FUNCTION_LIST_DIR}/plugin.map)
  set_target_properties(${target} PROPERTIES PREFIX "" OUTPUT_NAME ${output} LIBRARY_OUTPUT_DIRECTORY ${folder})
endfunction()

# Without a build type, a plugin is optimised.
function(netloft_plugin_flags target)
  target_link_libraries(${target} PRIVATE netloft::plugin)
  target_compile_options(${target} PRIVATE $<$<CONFIG:>:-O2> -ffp-contract=off -fno-math-errno -fno-trapping-math)
  set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
endfunction()

# Reads the variables arg_TESTS and arg_SCENES of the caller, netloft_add_plugin.
function(netloft_add_plugin_tests name)
  add_test(NAME ${name}.conforms COMMAND netloft::program test $<TARGET_FILE:${name}>)
  foreach(source IN LISTS arg_TESTS)
    get_filename_component(stem ${source} NAME_WE)
    add_executable(${stem} ${source})
    target_link_libraries(${stem} PRIVATE netloft::plugin)
    add_test(NAME ${name}.${stem} COMMAND ${stem})
  endforeach()
  foreach(scene IN LISTS arg_SCENES)
    get_filename_component(stem ${scene} NAME_WE)
    add_test(NAME ${name}.runs.${stem} COMMAND netloft::program run ${CMAKE_CURRENT_SOURCE_DIR}/${scene}
             --plugins $<TARGET_FILE_DIR:${name}> -o ${CMAKE_CURRENT_BINARY_DIR}/${stem}.hdf)
  endforeach()
endfunction()
