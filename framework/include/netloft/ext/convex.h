/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Matrices that approximate the exact tangent. A term can compute them better than its host, which otherwise
 * projects and bounds the tangent. A host requests them only from terms with the trait, one per call.
 */
#ifndef NETLOFT_EXT_CONVEX_H
#define NETLOFT_EXT_CONVEX_H
#include <netloft/plugin.h>

#ifdef __cplusplus
extern "C" {
#endif

#define NETLOFT_EXT_CONVEX "netloft.convex/1"

/* Traits of a term with NETLOFT_SYMMETRIC. */
#define NETLOFT_HAS_CONVEX (1u << 9)  /* answers NETLOFT_WANT_CONVEX */
#define NETLOFT_HAS_METRIC (1u << 10) /* answers NETLOFT_WANT_METRIC */

/* Values of netloft_tile.want. The matrix is added to netloft_tile.tangent. */
#define NETLOFT_WANT_CONVEX 8u  /* a positive semi-definite part of the tangent */
#define NETLOFT_WANT_METRIC 16u /* the linear stiffness: constant, semi-definite, bounds the convex part */

#ifdef __cplusplus
}
#endif
#endif
