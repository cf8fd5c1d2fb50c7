/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The standard streams of the C library, under names that stay within this module. Archives of HDF5 and
 * SuiteSparse are compiled for programs, in which these variables are at a fixed distance from the code;
 * those of a shared library are not.
 */
#include <dlfcn.h>

#define HIDDEN __attribute__((visibility("hidden")))

HIDDEN void *stdin, *stdout, *stderr;

__attribute__((constructor(101))) static void find_streams(void) {
  stdin = *(void**)dlsym(RTLD_DEFAULT, "stdin");
  stdout = *(void**)dlsym(RTLD_DEFAULT, "stdout");
  stderr = *(void**)dlsym(RTLD_DEFAULT, "stderr");
}
