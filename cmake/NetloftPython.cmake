# SPDX-License-Identifier: BSD-3-Clause
# NETLOFT_SYSTEM_PYTHON: the Python that runs test scripts. The configuration of a build with tests fails
# without its modules, because tests that are left out cannot fail. Debian's python3 has them; another python3
# before it on the path usually has not.
find_program(NETLOFT_SYSTEM_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
if(NETLOFT_SYSTEM_PYTHON)
  execute_process(COMMAND ${NETLOFT_SYSTEM_PYTHON} -c "import h5py, numpy, tomllib" RESULT_VARIABLE netloft_python_lacks
                  OUTPUT_QUIET ERROR_VARIABLE netloft_python_says)
endif()
if(NOT NETLOFT_SYSTEM_PYTHON OR netloft_python_lacks)
  message(FATAL_ERROR "The tests need /usr/bin/python3, version 3.11 or later, with h5py and numpy (Debian: python3-h5py, "
          "python3-numpy). ${netloft_python_says}")
endif()
