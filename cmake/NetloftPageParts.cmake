# SPDX-License-Identifier: BSD-3-Clause
# Parts of pages as texts in the program.
include_guard(GLOBAL)

# read_part(OUT FILES…): the files one after another; changed files make CMake run again.
function(read_part out)
  set(whole "")
  foreach(file IN LISTS ARGN)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    string(APPEND whole "${text}")
  endforeach()
  if("${whole}" MATCHES "</[sS][cC]|<!--|~~~\"")
    message(FATAL_ERROR "a part of the page would end its own element: ${ARGN}")
  endif()
  set(${out} "${whole}" PARENT_SCOPE)
endfunction()

# A compiler need not take long texts in one piece: pieces of 16000 characters, which it joins.
function(as_literal out text)
  set(literal "")
  string(LENGTH "${text}" length)
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${text}" ${at} 16000 piece)
    string(APPEND literal "R\"~~~(${piece})~~~\"\n")
    math(EXPR at "${at} + 16000")
  endwhile()
  set(${out} "${literal}" PARENT_SCOPE)
endfunction()

# write_source(FILE TEXT): written as it is (the scripts hold what CMake would take for expressions), and only if it has changed.
function(write_source file source)
  set(before "")
  if(EXISTS ${file})
    file(READ ${file} before)
  endif()
  if(NOT "${before}" STREQUAL "${source}")
    file(WRITE ${file} "${source}")
  endif()
endfunction()
