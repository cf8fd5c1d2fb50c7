/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Numbers that each element remembers from one accepted step to the next, such as the point at which friction
 * last held it on the ground. The element offers netloft_memory, lists the identifier in its `inputs` and
 * receives netloft_remembered with a tile.
 */
#ifndef NETLOFT_EXT_MEMORY_H
#define NETLOFT_EXT_MEMORY_H
#include <netloft/plugin.h>

#ifdef __cplusplus
extern "C" {
#endif

#define NETLOFT_EXT_MEMORY "netloft.memory/1"

/* Trait of a term. */
#define NETLOFT_READS_STATE (1u << 12) /* reads netloft_remembered.state and fills state_new */

/* An element offers this struct. */
typedef struct netloft_memory {
  uint32_t size;
  uint32_t width; /* numbers that an element remembers */
} netloft_memory;

/* The entry in netloft_tile.inputs points to this struct; the pointer is null if both arrays would
 * be null. */
typedef struct netloft_remembered {
  uint32_t size;
  uint32_t reserved;
  const double* state; /* [width][64] after the last accepted step; all zeros before the first */
  double* state_new;   /* [width][64] out: the numbers to remember if this step is accepted; or null */
} netloft_remembered;

#ifdef __cplusplus
}
#endif
#endif
