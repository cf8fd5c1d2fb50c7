/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The ground below a gear: the bed of the scene, and the velocity at which the ground passes a towed gear. An
 * element that reads either of them lists the identifier below in netloft_element.inputs.
 */
#ifndef NETLOFT_EXT_GROUND_H
#define NETLOFT_EXT_GROUND_H
#include <netloft/plugin.h>

#ifdef __cplusplus
extern "C" {
#endif

#define NETLOFT_EXT_GROUND "netloft.ground/1"

/* Traits of a term. */
#define NETLOFT_READS_GROUND                                                                                \
  (1u << 17) /* reads netloft_ground.velocity if the ground passes the gear; a host may then give no memory \
                (ext/memory.h), because friction that only slides needs none */
#define NETLOFT_READS_BED (1u << 18) /* reads netloft_ground.bed if the scene has a bed */

/* The entry in netloft_tile.inputs points to this struct; the pointer is null if the scene has neither
 * a moving ground nor a bed. */
typedef struct netloft_ground {
  uint32_t size;
  uint32_t reserved;
  const double*
      velocity;      /* [3] of the ground, as it passes a towed gear [m/s]; null: the ground is at rest */
  const double* bed; /* [6 nodes][64] the bed below each node of the stencil: its height z_b [m], dz_b/dx,
                        dz_b/dy, and its second derivatives xx, xy, yy [1/m]; null: no bed */
} netloft_ground;

#ifdef __cplusplus
}
#endif
#endif
