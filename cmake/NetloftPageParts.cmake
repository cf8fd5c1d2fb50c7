# SPDX-License-Identifier: BSD-3-Clause
# Texts of parts of pages, which are compiled into the program.
include_guard(GLOBAL)

# read_part(OUT FILES…): joins the texts of the files; CMake runs again when a file changes.
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

# Compilers may refuse long texts in one literal, so texts are divided into literals of 16000 characters.
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

# write_source(FILE TEXT): writes the text without expanding generator expressions, which scripts may contain
# by chance, and only if it has changed.
function(write_source file source)
  set(before "")
  if(EXISTS ${file})
    file(READ ${file} before)
  endif()
  if(NOT "${before}" STREQUAL "${source}")
    file(WRITE ${file} "${source}")
  endif()
endfunction()
