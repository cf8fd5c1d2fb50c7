/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Water that a gear changes. An element with this extension is a flow: its shared unknowns
 * (ext/shared_unknowns.h) describe how the gear changes the water, for instance by how much netting slows it.
 * The host asks the flow for the velocity of the water at the netting that it reaches, evaluates the drag of
 * the netting with this velocity, and adds the drag to the equations of the unknowns. It computes all
 * derivatives from those of the drag and of the flow, so that the tangent is exact.
 *
 * The flow's own terms are the other part of its equations. They are evaluated like those of any element.
 */
#ifndef NETLOFT_EXT_FLOW_H
#define NETLOFT_EXT_FLOW_H
#include <netloft/plugin.h>

#ifdef __cplusplus
extern "C" {
#endif

#define NETLOFT_EXT_FLOW "netloft.flow/1"

/* Up to 64 places in the water. Arrays are [component][64]. The flow does not add but WRITES its outputs, in
 * lanes below `count`. Let U be the undisturbed velocity, a_k the unknowns, s the reach, n the normal, and
 * w(U, a, s, n) the velocity that the flow returns. Drag -r_p at place p (r_p is a residual) then adds to the
 * residual of unknown k the sum over all places of weight_kp . r_p. Weights must not depend on the unknowns
 * or on the normal. If derivatives are not wanted, all pointers d_... are NULL. */
typedef struct netloft_flow_tile {
  uint32_t size;
  uint32_t count;
  uint32_t part; /* part of the flow to which the unknowns belong, in the order of `create` */
  uint32_t reserved;
  const double* unknowns; /* [unknown][64] */
  const double* current;  /* [3][64] velocity of the undisturbed water [m/s] */
  const double* reach;    /* [64] how much the flow affects the place: from 0, not at all, to 1, fully */
  double* velocity;       /* [3][64] velocity of the water [m/s] */
  double* d_current;      /* [9][64] dvelocity[r]/dcurrent[c] at 3r+c */
  double* d_unknown;      /* [unknown][3][64] dvelocity/dunknown */
  double* weight;         /* [unknown][3][64] weights of the residual of the drag in the equations */
  double* d_weight;       /* [unknown][9][64] dweight[r]/dcurrent[c] at 3r+c */
  const double* normal;   /* [3][64] unit normal of the netting, of either sign; 0 on ropes */
  double* d_normal;       /* [9][64] dvelocity[r]/dnormal[c] at 3r+c */
} netloft_flow_tile;

/* An element offers this struct. */
typedef struct netloft_flow {
  uint32_t size;
  uint32_t reserved;
  int (*evaluate)(const void* self, netloft_flow_tile* tile); /* `self` is what `create` made */
} netloft_flow;

#ifdef __cplusplus
}
#endif
#endif
