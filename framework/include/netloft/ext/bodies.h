/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Elements on a rigid body.
 *
 * A rigid body is its origin and, in place of one more node, the rotation vector p that turns its axes into
 * those of the world [rad]: a point r of the body is at x + R r, R = exp [p]x. Rows 3 to 5 of tile.x, v and a
 * are p and its rates, those of tile.force minus the moment that does work on p [N m], and the tangent is the
 * plain derivative: netloft/rotation.hpp has the formulas, and netloft/element.hpp spares authors from all of
 * this. p may be longer than a turn. Rows 3 to 5 of tile.current have no meaning.
 */
#ifndef NETLOFT_EXT_BODIES_H
#define NETLOFT_EXT_BODIES_H
#include <netloft/plugin.h>

#ifdef __cplusplus
extern "C" {
#endif

#define NETLOFT_EXT_BODIES "netloft.bodies/1"

/* One more value of netloft_element.stencil. */
#define NETLOFT_BODY 0x201u

#ifdef __cplusplus
}
#endif
#endif
