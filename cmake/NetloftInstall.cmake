# SPDX-License-Identifier: BSD-3-Clause
# The files that `cmake --install` writes. The folder may be moved: the program finds the other files relative
# to its own place. The build folder has the same layout, so that find_package(netloft) and `netloft --cflags`
# work there, too.
#
#   bin/netloft   include/netloft/   lib/netloft/ (plugins)   lib/cmake/netloft/
#   share/netloft/ (gear-library, schema of scenes)   share/doc/netloft/ (guides, licence)
#   share/man/   share/bash-completion/   share/zsh/
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME netloft)
set(NETLOFT_CMAKE_DIR lib/cmake/netloft)

set(netloft_UP ../../..)
configure_file(cmake/netloftConfig.cmake.in ${PROJECT_BINARY_DIR}/${NETLOFT_CMAKE_DIR}/netloftConfig.cmake @ONLY)
include(CMakePackageConfigHelpers)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/${NETLOFT_CMAKE_DIR}/netloftConfigVersion.cmake
                                 COMPATIBILITY SameMajorVersion)
foreach(file NetloftPlugin.cmake plugin.map)
  configure_file(cmake/${file} ${PROJECT_BINARY_DIR}/${NETLOFT_CMAKE_DIR}/${file} COPYONLY)
endforeach()
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/framework/include ${PROJECT_BINARY_DIR}/include SYMBOLIC)

# The schema of scenes comes from the tables of the plugins of this build.
set(netloft_schema ${PROJECT_BINARY_DIR}/share/netloft/scene.schema.json)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share/netloft)
add_custom_command(OUTPUT ${netloft_schema} COMMAND netloft schema > ${netloft_schema} DEPENDS netloft netloft_plugins VERBATIM)
add_custom_target(netloft_schema ALL DEPENDS ${netloft_schema})

# The manual page and the completions of shells come from the table of commands in the program.
set(netloft_documents "")
function(netloft_document file)
  cmake_path(GET file PARENT_PATH folder)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/${folder})
  add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/${file} COMMAND netloft ${ARGN} > ${PROJECT_BINARY_DIR}/${file} DEPENDS netloft VERBATIM)
  list(APPEND netloft_documents ${PROJECT_BINARY_DIR}/${file})
  set(netloft_documents ${netloft_documents} PARENT_SCOPE)
  install(FILES ${PROJECT_BINARY_DIR}/${file} DESTINATION ${folder})
endfunction()
netloft_document(share/man/man1/netloft.1 --manual)
netloft_document(share/bash-completion/completions/netloft --completions bash)
netloft_document(share/zsh/site-functions/_netloft --completions zsh)
add_custom_target(netloft_documents ALL DEPENDS ${netloft_documents})

install(TARGETS netloft RUNTIME DESTINATION bin)
if(NOT NETLOFT_STATIC)
  # Adapters to large libraries are a separate component, which is optional.
  set(adapters "/(kinsol|arkode)\\.so$")
  install(DIRECTORY ${NETLOFT_PLUGIN_DIR}/ DESTINATION lib/netloft FILES_MATCHING PATTERN "*.so"
          REGEX ${adapters} EXCLUDE)
  if(TARGET kinsol OR TARGET arkode)
    install(DIRECTORY ${NETLOFT_PLUGIN_DIR}/ DESTINATION lib/netloft COMPONENT adapters FILES_MATCHING REGEX ${adapters})
  endif()
endif()
install(DIRECTORY framework/include/netloft DESTINATION include)
install(DIRECTORY ${PROJECT_BINARY_DIR}/${NETLOFT_CMAKE_DIR}/ DESTINATION ${NETLOFT_CMAKE_DIR})
install(DIRECTORY gear-library DESTINATION share/netloft)
install(DIRECTORY framework/guides DESTINATION share/doc/netloft PATTERN README.md EXCLUDE)
install(FILES ${netloft_schema} DESTINATION share/netloft)
install(FILES LICENSE DESTINATION share/doc/netloft RENAME copyright)
# Licences of libraries that are in the program from archives and headers (Debian keeps them there).
foreach(archive libexpat1-dev libhdf5-dev libmumps-seq-dev libopenblas-serial-dev libscotch-dev libsuitesparse-dev libudunits2-dev
        libboost-dev libcli11-dev libeigen3-dev libstb-dev nlohmann-json3-dev)
  if(EXISTS /usr/share/doc/${archive}/copyright)
    install(FILES /usr/share/doc/${archive}/copyright DESTINATION share/doc/netloft RENAME copyright-of-${archive})
    list(APPEND netloft_notices ${archive})
  endif()
endforeach()
# The package of Python contains the same files; make_wheel.py adds those of shared libraries.
if(NETLOFT_PYTHON)
  foreach(package IN LISTS netloft_notices ITEMS pybind11-dev)
    if(EXISTS /usr/share/doc/${package}/copyright)
      install(FILES /usr/share/doc/${package}/copyright DESTINATION lib/python3/dist-packages/netloft/licences COMPONENT python
              RENAME copyright-of-${package})
    endif()
  endforeach()
endif()
install(FILES CHANGELOG.md DESTINATION share/doc/netloft)
if(NETLOFT_PYTHON)
  install(FILES io/python/PYTHON.md io/python/RECIPES.md DESTINATION share/doc/netloft COMPONENT python)
endif()
install(FILES io/scenes/SCENE.md io/gears/GEAR.md io/formats/hdf5/LAYOUT.md DESTINATION share/doc/netloft)
