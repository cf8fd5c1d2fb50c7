/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Two matrices that approximate the exact tangent: a convex part and a metric. A term can often compute them
 * faster and more accurately than the host, which derives them from the tangent by a projection and a bound.
 * The host requests a matrix only from terms with its trait, one matrix per call.
 */
#ifndef NETLOFT_EXT_CONVEX_H
#define NETLOFT_EXT_CONVEX_H
#include <netloft/plugin.h>

#ifdef __cplusplus
extern "C" {
#endif

#define NETLOFT_EXT_CONVEX "netloft.convex/1"

/* Traits of a term with NETLOFT_SYMMETRIC. */
#define NETLOFT_HAS_CONVEX (1u << 9)  /* computes NETLOFT_WANT_CONVEX */
#define NETLOFT_HAS_METRIC (1u << 10) /* computes NETLOFT_WANT_METRIC */

/* Values of netloft_tile.want. The matrix is added to netloft_tile.tangent. */
#define NETLOFT_WANT_CONVEX 8u  /* a positive semi-definite approximation of the tangent */
#define NETLOFT_WANT_METRIC 16u /* the linear stiffness: constant, semi-definite, bounds the convex part */

#ifdef __cplusplus
}
#endif
#endif
