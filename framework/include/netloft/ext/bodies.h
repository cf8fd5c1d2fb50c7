/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Elements on a rigid body.
 *
 * A rigid body has two nodes in a tile: its origin x and, in rows 3 to 5, its rotation vector p [rad]. A
 * point r, in the axes of the body, is at x + R r in the world, where R is the rotation by the angle |p|
 * about p. Rows 3 to 5 of tile.v and tile.a are the first and second derivatives of p with respect to time.
 * Rows 3 to 5 of tile.force are minus a generalised force [N m], which does the same work on p as the moment
 * on the body; the tangent has its partial derivatives. netloft/rotation.hpp has the formulas; authors who
 * use netloft/element.hpp do not need them. p may be longer than a full turn. Rows 3 to 5 of tile.current
 * have no meaning.
 */
#ifndef NETLOFT_EXT_BODIES_H
#define NETLOFT_EXT_BODIES_H
#include <netloft/plugin.h>

#ifdef __cplusplus
extern "C" {
#endif

#define NETLOFT_EXT_BODIES "netloft.bodies/1"

/* Value of netloft_element.stencil for an element on a rigid body. */
#define NETLOFT_BODY 0x201u

#ifdef __cplusplus
}
#endif
#endif
