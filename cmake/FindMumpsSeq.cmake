# SPDX-License-Identifier: BSD-3-Clause
# MUMPS without MPI, for static linking (Debian: libmumps-seq-dev).
#
# netloft_mumps_object(OUT): custom command that makes OUT, one object file with all of MUMPS and its stand-in
# for MPI inside. It exports netloft_dmumps_c and nothing else, so that a real MPI, and another MUMPS linked to
# it may be in the same process (a library of a plugin may load both). It takes its memory from
# netloft_mumps_malloc and similar functions, which the program that links the object must define, because
# MUMPS allocates anew in every factorisation.
find_path(MumpsSeq_INCLUDE_DIR dmumps_c.h)
set(MumpsSeq_ARCHIVES "")
foreach(part dmumps mumps_common pord mpiseq)
  find_library(MumpsSeq_${part}_ARCHIVE lib${part}_seq.a)
  mark_as_advanced(MumpsSeq_${part}_ARCHIVE)
  list(APPEND MumpsSeq_ARCHIVES ${MumpsSeq_${part}_ARCHIVE})
endforeach()
# Libraries that MUMPS needs. The run-time packages of Scotch and Fortran have no file names without versions.
find_library(MumpsSeq_esmumps_LIBRARY NAMES esmumps esmumps-7.0 esmumps-6.1)
find_library(MumpsSeq_scotch_LIBRARY NAMES scotch scotch-7.0 scotch-6.1)
find_library(MumpsSeq_gfortran_LIBRARY NAMES gfortran libgfortran.so.5)
include(NetloftBlas)
netloft_find_archives(MumpsSeq_scotch_ARCHIVES esmumps scotch scotcherr)
if(NOT MumpsSeq_scotch_ARCHIVES)
  set(MumpsSeq_scotch_ARCHIVES ${MumpsSeq_esmumps_LIBRARY} ${MumpsSeq_scotch_LIBRARY})
endif()
set(MumpsSeq_LIBRARIES ${MumpsSeq_scotch_ARCHIVES} netloft_blas ${MumpsSeq_gfortran_LIBRARY})

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MumpsSeq REQUIRED_VARS
  MumpsSeq_INCLUDE_DIR MumpsSeq_dmumps_ARCHIVE MumpsSeq_mumps_common_ARCHIVE MumpsSeq_pord_ARCHIVE
  MumpsSeq_mpiseq_ARCHIVE MumpsSeq_esmumps_LIBRARY MumpsSeq_scotch_LIBRARY MumpsSeq_gfortran_LIBRARY
  NETLOFT_lapack_LIBRARY NETLOFT_blas_LIBRARY CMAKE_OBJCOPY)
mark_as_advanced(MumpsSeq_INCLUDE_DIR MumpsSeq_esmumps_LIBRARY MumpsSeq_scotch_LIBRARY MumpsSeq_gfortran_LIBRARY)

function(netloft_mumps_object out)
  set(renamed --redefine-sym dmumps_c=netloft_dmumps_c)
  foreach(function malloc calloc realloc free)
    list(APPEND renamed --redefine-sym ${function}=netloft_mumps_${function})
  endforeach()
  list(APPEND renamed --redefine-sym _gfortran_string_trim=netloft_mumps_string_trim)
  add_custom_command(
    OUTPUT ${out}
    COMMAND ${CMAKE_C_COMPILER} -r -nostdlib -Wl,-u,dmumps_c -o ${out}.all ${MumpsSeq_ARCHIVES}
    COMMAND ${CMAKE_OBJCOPY} --keep-global-symbol=dmumps_c ${out}.all ${out}.one
    COMMAND ${CMAKE_OBJCOPY} ${renamed} ${out}.one ${out}
    COMMAND ${CMAKE_COMMAND} -E rm ${out}.all ${out}.one
    DEPENDS ${MumpsSeq_ARCHIVES}
    COMMENT "Drawing MUMPS together into one object" VERBATIM)
endfunction()
