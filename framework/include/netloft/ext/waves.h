/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Waves. Their velocity is part of netloft_tile.current; this extension adds the acceleration and the surface
 * of the water. An element that reads either of them lists the identifier below in netloft_element.inputs.
 * The entry in netloft_tile.inputs is null if there are no waves.
 */
#ifndef NETLOFT_EXT_WAVES_H
#define NETLOFT_EXT_WAVES_H
#include <netloft/plugin.h>

#ifdef __cplusplus
extern "C" {
#endif

#define NETLOFT_EXT_WAVES "netloft.waves/1"

/* Traits of a term. */
#define NETLOFT_READS_WAVES (1u << 19) /* reads netloft_waves; its force may then change with tile.time */
#define NETLOFT_NEEDS_WAVES (1u << 24) /* zero if there are no waves */

/* The entry in netloft_tile.inputs points to this struct. */
typedef struct netloft_waves {
  uint32_t size;
  uint32_t reserved;
  const double* acceleration; /* [dof][64] acceleration of the water particles at the nodes [m/s2] */
  const double* surface; /* [nodes][64] height of the water surface above z = 0, over the nodes [m]; null: the
                            surface is z = 0 */
} netloft_waves;

#ifdef __cplusplus
}
#endif
#endif
