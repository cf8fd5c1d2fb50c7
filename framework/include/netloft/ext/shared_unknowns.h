/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Unknowns that all elements of a part share, and that are found together with the positions, such as the
 * front of a catch. A part has at most three such unknowns: they are x, y and z of an additional node, which
 * is the last node of every element in a tile. The host treats them as coordinates, and their rows of the
 * residual as forces. Therefore choose a unit in which a change by 1 matters as much as a displacement of 1
 * m, and scale the equation of each unknown so that its terms are forces in newtons.
 */
#ifndef NETLOFT_EXT_SHARED_UNKNOWNS_H
#define NETLOFT_EXT_SHARED_UNKNOWNS_H
#include <netloft/plugin.h>

#ifdef __cplusplus
extern "C" {
#endif

#define NETLOFT_EXT_SHARED_UNKNOWNS "netloft.shared_unknowns/1"

typedef struct netloft_global {
  uint32_t size;
  uint32_t reserved;
  const char *name, *unit, *doc;
  const char*
      needs; /* name of a real parameter: if it is zero, the unknown keeps its initial value; or null */
} netloft_global;

/* An element offers this struct. */
typedef struct netloft_globals {
  uint32_t size;
  uint32_t count;
  const netloft_global* rows;
} netloft_globals;

/* `create` receives this struct. */
typedef struct netloft_global_starts {
  uint32_t size;
  uint32_t reserved;
  double* start; /* [part][global] set by `create` */
} netloft_global_starts;

#ifdef __cplusplus
}
#endif
#endif
