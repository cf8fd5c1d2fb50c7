/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Time schemes. A plugin offers netloft_integrators.
 */
#ifndef NETLOFT_EXT_INTEGRATOR_H
#define NETLOFT_EXT_INTEGRATOR_H
#include <netloft/plugin.h>

#ifdef __cplusplus
extern "C" {
#endif

#define NETLOFT_EXT_INTEGRATOR "netloft.integrator/1"

/* A scene that moves, as an integrator sees it: F(t, u, v, a) = 0. One step leads from t to t + h. u are
 * displacements of the unknowns from the start [m], v and a their first and second derivatives. F is the
 * residual, +dE/dx: inertia and all other forces. The host chooses h, accepts or rejects the result of a
 * step, and keeps the statistics. */
typedef struct netloft_motion {
  uint32_t size;
  uint32_t unknowns;
  void* host;
  double t, h;                   /* [s] */
  const double *u, *v, *a;       /* in: state at t; a is a_new of the step before */
  double *u_new, *v_new, *a_new; /* out: state at t + h */
  double* error;                 /* out: estimate of the error of u_new in this step [m]; zero if not set */

  /* F(t, u, v, a) [N]. Returns NETLOFT_OK, NETLOFT_OUTSIDE_DOMAIN or NETLOFT_ERROR. */
  int (*residual)(void* host, double t, const double* u, const double* v, const double* a, double* residual);
  /* Finds the a for which F(t, u, v, a) = 0 from the masses of the nodes, without a system of equations. */
  int (*accelerate)(void* host, double t, const double* u, const double* v, double* a);
  /* Finds the u for which F(t, u, v0 + cv u, a0 + ca u) = 0, starting from the given u, by the solver of the
   * analysis. Returns NETLOFT_OK, or NETLOFT_OUTSIDE_DOMAIN if it failed; a shorter step may succeed. */
  int (*solve)(void* host, double t, const double* v0, double cv, const double* a0, double ca, double* u);
  /* Memory for `unknowns` numbers, the same for the same index during the whole integration. */
  double* (*scratch)(void* host, uint32_t index);

  char* message; /* memory for a sentence of the integrator */
  uint32_t message_size;
  uint32_t reserved;

  /* Finds the u at t + h for which the mean forces of the step balance. The step begins at the u at t;
   *    v = v0 + cv u and a = a0 + ca u
   * are the rates in its middle. The mean force is F at the midpoint between both ends. For forces with an
   * energy, a correction is added: the work of the mean force over the step is then exactly the decrease of
   * the energy. The correction has no resultant force or moment if the force at the midpoint has none. In
   * addition, a member (ext/members.h) of stiffness k resists the change Dl of its length in the step by the
   * tension T. The host remembers a rate of stretch m of each member [m/s] and updates it after the step:
   *    T = damping/2 k (Dl - h m),   m <- m + memory (Dl/h - m)
   * If a member is slack at either end of a step, its m is zero afterwards. Returns the same as `solve`. */
  int (*solve_between)(void* host, const double* v0, double cv, const double* a0, double ca, double damping,
                       double memory, double* u);
} netloft_motion;

/* Traits of an integrator. */
enum {
  NETLOFT_EXPLICIT = 1, /* never calls `solve` */
  NETLOFT_BETWEEN = 2   /* calls `solve_between`, whose matrix is never symmetric */
};

typedef struct netloft_integrator {
  uint32_t size;
  uint32_t traits;
  const char *name, *doc;
  uint32_t parameter_bytes;
  uint32_t parameter_count;
  const netloft_parameter* parameters;
  /* Takes a step. Returns NETLOFT_OK, NETLOFT_OUTSIDE_DOMAIN (a shorter step may succeed) or NETLOFT_ERROR.
   */
  int (*step)(const void* parameters, netloft_motion* motion);
  /* The power of h to which the error estimate is proportional. */
  double (*order)(const void* parameters);
  /* Longest stable step [s] if the highest angular frequency is `omega` [rad/s]; 0: all steps are stable. */
  double (*stable_step)(const void* parameters, double omega);
} netloft_integrator;

/* A plugin offers this struct. */
typedef struct netloft_integrators {
  uint32_t size;
  uint32_t count;
  const netloft_integrator* rows;
} netloft_integrators;

#ifdef __cplusplus
}
#endif
#endif
