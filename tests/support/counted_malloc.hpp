// SPDX-License-Identifier: BSD-3-Clause
//
// Counts calls of malloc in the whole program that counted_malloc.cpp is a source of.
#pragma once

namespace netloft::test {

/// Whether this build can: not with a sanitizer, nor with another C library than glibc.
bool malloc_is_counted();

/// Calls so far of malloc and its like, by all threads.
long count_malloc();

}  // namespace netloft::test
