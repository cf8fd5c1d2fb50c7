# SPDX-License-Identifier: BSD-3-Clause
# netloft_hdf5_libraries and HDF5_C_INCLUDE_DIRS.
# The serial C library: a parallel HDF5 would link MPI into every program without any gain for a single writer.
set(HDF5_PREFER_PARALLEL FALSE)
find_package(HDF5 1.10.7 REQUIRED COMPONENTS C)
if(HDF5_IS_PARALLEL)
  message(FATAL_ERROR "Found the parallel (MPI) HDF5; Netloft needs the serial one (Debian: libhdf5-dev). "
                      "Point HDF5_ROOT at it.")
endif()

# The archive if it exists: Debian's shared library loads about forty others (curl, OpenSSL, Kerberos, LDAP),
# for files on servers that nobody opens here, and loading them takes longer than the rest of a small run
# (tests/bench/start_up.py). Most libraries that the archive depends on are not linked, because none of their
# symbols is used. A shared library loads its own dependencies, but the module lists them, too.
set(netloft_hdf5_libraries ${HDF5_C_LIBRARIES})
if(HDF5_C_LIBRARY_hdf5 MATCHES "\\.(so|dylib)")
  get_filename_component(beside ${HDF5_C_LIBRARY_hdf5} DIRECTORY)
  find_library(HDF5_C_ARCHIVE libhdf5.a HINTS ${beside} NO_DEFAULT_PATH)
  mark_as_advanced(HDF5_C_ARCHIVE)
  if(HDF5_C_ARCHIVE)
    list(REMOVE_ITEM netloft_hdf5_libraries ${HDF5_C_LIBRARY_hdf5})
    set(netloft_hdf5_libraries ${HDF5_C_ARCHIVE} -Wl,--push-state,--as-needed ${netloft_hdf5_libraries} -Wl,--pop-state)
  else()
    set(netloft_hdf5_libraries ${HDF5_C_LIBRARY_hdf5})
  endif()
endif()
