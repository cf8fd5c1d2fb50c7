/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Straight lines in an element that bear tension: the bar of a rope, or all bars of one direction of a
 * triangle of netting. Solvers may treat their tensions as unknowns, and time schemes conserve their energy.
 */
#ifndef NETLOFT_EXT_MEMBERS_H
#define NETLOFT_EXT_MEMBERS_H
#include <netloft/plugin.h>

#ifdef __cplusplus
extern "C" {
#endif

#define NETLOFT_EXT_MEMBERS "netloft.members/1"

/* Trait of a term whose force is that of the element's members, and nothing else. */
#define NETLOFT_OF_MEMBERS (1u << 14)

/* The chord of a member is w = sum of c[i] x[i] over the nodes of the element, l = |w|, t = w/l. With the
 * tension T, the residual of node i is
 *      number c[i] T t,   T = EA (l/l0 - 1) where l > l0, else EA_compression (l/l0 - 1)
 * The sum over the members of an element is its term with NETLOFT_OF_MEMBERS. */
typedef struct netloft_member {
  double c[3];               /* coefficients of the chord; the third is zero if the element has two nodes */
  double rest_length;        /* l0 [m] */
  double EA, EA_compression; /* axial stiffness of one bar or twine, taut and slack [N] */
  double number;             /* number of equal bars or twines that the member represents */
} netloft_member;

/* An element that has a term with NETLOFT_OF_MEMBERS offers this struct. */
typedef struct netloft_element_members {
  uint32_t size;
  uint32_t count; /* members of each element */
  /* Writes the members of elements first ... first + elements - 1 at a time [s]: out[element][member]. */
  int (*write)(const void* self, double time, uint32_t first, uint32_t elements, netloft_member* out);
} netloft_element_members;

#ifdef __cplusplus
}
#endif
#endif
