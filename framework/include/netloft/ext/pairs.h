/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Elements on pairs of neighbouring elements, such as the bending of a rope or of netting. Such an element
 * names another type of elements; the host creates it on every pair of neighbours of that type.
 */
#ifndef NETLOFT_EXT_PAIRS_H
#define NETLOFT_EXT_PAIRS_H
#include <netloft/plugin.h>

#ifdef __cplusplus
extern "C" {
#endif

#define NETLOFT_EXT_PAIRS "netloft.pairs/1"

/* More values of netloft_element.stencil: the nodes of two neighbouring bars of one rope, in order; or of two
 * triangles with a common edge (a, b): a, b, then the third corner c of the triangle (a, b, c), and the third
 * corner d of the other triangle. */
#define NETLOFT_BAR_PAIR 0x103u
#define NETLOFT_TRIANGLE_PAIR 0x104u

/* An element offers this struct. */
typedef struct netloft_rider {
  uint32_t size;
  uint32_t reserved;
  const char*
      rides_on; /* another element of the same plugin; this one is created on pairs of its neighbours */
} netloft_rider;

#ifdef __cplusplus
}
#endif
#endif
