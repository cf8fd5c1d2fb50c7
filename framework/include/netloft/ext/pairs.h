/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Elements on pairs of neighbours, such as the bending of a rope or of netting. A host makes them wherever it
 * makes the element that they ride on.
 */
#ifndef NETLOFT_EXT_PAIRS_H
#define NETLOFT_EXT_PAIRS_H
#include <netloft/plugin.h>

#ifdef __cplusplus
extern "C" {
#endif

#define NETLOFT_EXT_PAIRS "netloft.pairs/1"

/* More values of netloft_element.stencil. */
#define NETLOFT_BAR_PAIR 0x103u      /* nodes of two neighbouring bars of one rope, in order */
#define NETLOFT_TRIANGLE_PAIR 0x104u /* shared edge (a, b), then opposite corners: c of (a, b, c), d */

/* Offered by an element. */
typedef struct netloft_rider {
  uint32_t size;
  uint32_t reserved;
  const char* rides_on; /* an element of the same plugin: this one is made wherever that one is used */
} netloft_rider;

#ifdef __cplusplus
}
#endif
#endif
