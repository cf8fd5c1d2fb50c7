# SPDX-License-Identifier: BSD-3-Clause
# `cpack -G DEB` in the build folder. Dependencies on libraries are read off the binaries (dpkg-shlibdeps).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME netloft)
set(CPACK_PACKAGE_CONTACT "The Netloft authors")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_NETLOFT_PACKAGE_NAME netloft)
set(CPACK_DEBIAN_ADAPTERS_PACKAGE_NAME netloft-adapters)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_COMPONENT_ADAPTERS_DEPENDS netloft)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "g++ (>= 10), cmake (>= 3.25), make")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "paraview")
set(CPACK_COMPONENT_NETLOFT_DESCRIPTION "${PROJECT_DESCRIPTION}
 Finds the shape and the forces of trawl gears: ropes, netting, floats, catch,
 in a current and on the seabed. Elements, hydrodynamic laws and solvers are
 plugins; their authors need the headers in this package and nothing else.")
set(CPACK_COMPONENT_ADAPTERS_DESCRIPTION "Solvers of SUNDIALS as plugins of Netloft")
include(CPack)
