/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Waves. Their velocity is part of netloft_tile.current; this extension adds the acceleration of the water
 * and the surface. An element lists the identifier in its `inputs`; the place in a tile is null without
 * waves.
 */
#ifndef NETLOFT_EXT_WAVES_H
#define NETLOFT_EXT_WAVES_H
#include <netloft/plugin.h>

#ifdef __cplusplus
extern "C" {
#endif

#define NETLOFT_EXT_WAVES "netloft.waves/1"

/* Traits of a term. */
#define NETLOFT_READS_WAVES (1u << 19) /* wants netloft_waves; may change with tile.time then */
#define NETLOFT_NEEDS_WAVES (1u << 24) /* gives nothing where the water does not swing */

/* Input of a tile. */
typedef struct netloft_waves {
  uint32_t size;
  uint32_t reserved;
  const double* acceleration; /* [dof][64] of the water at the nodes, as it passes them [m/s2] */
  const double* surface; /* [nodes][64] height of the surface of the water over the nodes, above z = 0 [m];
                                 null: it is z = 0 everywhere */
} netloft_waves;

#ifdef __cplusplus
}
#endif
#endif
