// SPDX-License-Identifier: BSD-3-Clause
//
// Counts the calls of malloc in programs that contain counted_malloc.cpp.
#pragma once

namespace netloft::test {

/// Whether this build counts calls. A build with a sanitizer, or with a C library other than glibc, does not.
bool malloc_is_counted();

/// Number of calls of malloc and similar functions so far, by all threads.
long count_malloc();

}  // namespace netloft::test
