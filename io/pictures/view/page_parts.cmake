# SPDX-License-Identifier: BSD-3-Clause
# Makes the fixed parts of a page texts in the program, and the policy with which a browser runs only these
# scripts.
set(classes dom numbers decode cells scale camera shaders geometry model ground places fields picking solids dimensions selection legend plan frames curves parts panes
    input controls viewer)

# in_base64(OUT HEX) converts a hexadecimal checksum of CMake to base64 for a Content-Security-Policy.
function(in_base64 out hex)
  set(digits ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/)
  set(text "")
  foreach(at RANGE 0 60 6)
    string(SUBSTRING "${hex}0000" ${at} 6 group)
    math(EXPR bits "0x${group}")
    foreach(shift 18 12 6 0)
      math(EXPR digit "(${bits} >> ${shift}) & 63")
      string(SUBSTRING ${digits} ${digit} 1 letter)
      string(APPEND text ${letter})
    endforeach()
  endforeach()
  string(SUBSTRING "${text}" 0 43 text)
  set(${out} "${text}=" PARENT_SCOPE)
endfunction()

list(TRANSFORM classes PREPEND view/page/)
list(TRANSFORM classes APPEND .js)
read_part(libraries view/libraries/libraries.js)
read_part(classes ${classes})
read_part(start view/page/start.js)
read_part(style view/libraries/uPlot.css view/page/page.css)
read_part(body view/page/app.html)
set(viewer "(() => {\n'use strict';\n${classes}${start}})();\n")  # as viewer_script() joins them
foreach(part libraries viewer style)
  string(SHA256 hash "${${part}}")
  in_base64(${part}_hash ${hash})
endforeach()
set(policy "default-src 'none'; script-src 'sha256-${libraries_hash}' 'sha256-${viewer_hash}'; style-src 'sha256-${style_hash}'; img-src data:; base-uri 'none'; form-action 'none'")
set(quietPolicy "default-src 'none'; style-src 'sha256-${style_hash}'; img-src data:; base-uri 'none'; form-action 'none'")

set(source "// SPDX-License-Identifier: BSD-3-Clause\n#include \"io/pictures/view/page_parts.hpp\"\n\nnamespace netloft::pictures {\n")
foreach(part libraries classes start style body policy quietPolicy)
  as_literal(literal "${${part}}")
  string(SUBSTRING ${part} 0 1 first)
  string(TOUPPER ${first} first)
  string(SUBSTRING ${part} 1 -1 rest)
  string(APPEND source "const char* const kPage${first}${rest} =\n${literal};\n")
endforeach()
string(APPEND source "}  // namespace netloft::pictures\n")
set(page_parts ${CMAKE_CURRENT_BINARY_DIR}/page_parts.cpp)
write_source(${page_parts} "${source}")
