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
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-netloft)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
get_property(netloft_python_version GLOBAL PROPERTY NETLOFT_PYTHON_VERSION)  # the module is for this one only: "3.11"
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python${netloft_python_version}, python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-scipy, python3-xarray")
set(CPACK_COMPONENT_PYTHON_DEPENDS netloft)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "The package netloft of Python
 Scenes, answers, arrays and derivatives of Netloft as objects.")
include(CPack)
