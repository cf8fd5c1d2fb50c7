# SPDX-License-Identifier: BSD-3-Clause
# netloft_blas: LAPACK and BLAS, shared. In a target with the property NETLOFT_BLAS_ARCHIVE, OpenBLAS's
# archive instead, if it exists: 13 000 names are looked up in the shared library whenever a program starts,
# which is a tenth of the time of a very small run. The archive makes a program 27 MB larger, so that tests
# use the shared library.
include(NetloftArchives)
netloft_find_archives(NETLOFT_OPENBLAS_ARCHIVE openblas)
if(TARGET netloft_blas)
  return()
endif()
find_library(NETLOFT_lapack_LIBRARY lapack)
find_library(NETLOFT_blas_LIBRARY blas)
mark_as_advanced(NETLOFT_lapack_LIBRARY NETLOFT_blas_LIBRARY)
add_library(netloft_blas INTERFACE IMPORTED GLOBAL)
set(netloft_wants_archive "$<BOOL:$<TARGET_PROPERTY:NETLOFT_BLAS_ARCHIVE>>")
if(NETLOFT_OPENBLAS_ARCHIVE)
  set_property(TARGET netloft_blas PROPERTY INTERFACE_LINK_LIBRARIES "$<${netloft_wants_archive}:${NETLOFT_OPENBLAS_ARCHIVE}>"
    "$<$<NOT:${netloft_wants_archive}>:${NETLOFT_lapack_LIBRARY}>" "$<$<NOT:${netloft_wants_archive}>:${NETLOFT_blas_LIBRARY}>")
else()
  set_property(TARGET netloft_blas PROPERTY INTERFACE_LINK_LIBRARIES ${NETLOFT_lapack_LIBRARY} ${NETLOFT_blas_LIBRARY})
endif()
