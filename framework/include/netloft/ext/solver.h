/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Solvers of r(u) = 0. A plugin offers netloft_solvers.
 */
#ifndef NETLOFT_EXT_SOLVER_H
#define NETLOFT_EXT_SOLVER_H
#include <netloft/ext/convex.h>

#ifdef __cplusplus
extern "C" {
#endif

#define NETLOFT_EXT_SOLVER "netloft.solver/1"

/* An additional value of `want`: residual of the conservative terms, which is the gradient of the energy. */
#define NETLOFT_WANT_GRADIENT 32u

/* Which matrix of the last evaluation to factorise. If INDEFINITE is added, any matrix that is not
 * singular is accepted (LU); otherwise, a symmetric matrix that is not positive definite is refused at little
 * cost. */
enum netloft_matrix { NETLOFT_EXACT = 0, NETLOFT_CONVEX = 1, NETLOFT_NONE = 2, NETLOFT_INDEFINITE = 16 };

/* Result of a factorisation. */
enum netloft_factor {
  NETLOFT_FACTOR_OK = 0,
  NETLOFT_NOT_POSITIVE = 1,
  NETLOFT_SINGULAR = 2,
  NETLOFT_FACTOR_FAILED = 3
};

/* Result of `progress`: continue; stop, the point has converged; or stop because of a limit or an
 * interruption. */
enum netloft_progress { NETLOFT_GO_ON = 0, NETLOFT_ARRIVED = 1, NETLOFT_GIVE_UP = 2 };

/* The reason why a solver returned. The host recomputes the residual and decides on convergence. */
enum netloft_outcome {
  NETLOFT_STOPPED = 0,        /* `progress` returned ARRIVED or GIVE_UP */
  NETLOFT_STEP_TOO_SHORT = 1, /* no step reduces the residual */
  NETLOFT_LINEAR_SOLVE = 2,   /* the matrix could not be factorised */
  NETLOFT_LEFT_DOMAIN = 3,    /* the forces of an element are not defined at the point */
  NETLOFT_NOT_FINITE = 4,     /* numbers overflowed */
  NETLOFT_SOLVER_ERROR = 5    /* see message */
};

/* A scene as a solver sees it: r(u) = 0, with an energy whose gradient is r if the problem is conservative.
 * `u` are displacements of the unknowns from the start [m]. Every function takes `host` first. */
typedef struct netloft_problem {
  uint32_t size;
  uint32_t unknowns;
  uint32_t traits; /* NETLOFT_CONSERVATIVE, NETLOFT_SYMMETRIC */
  uint32_t reserved;
  void* host;
  double* u; /* in: initial guess; out: final point */

  /* Evaluates at u: energy [J] and residual [N] as requested (either may be null); stores the requested
   * matrix. Returns NETLOFT_OK, NETLOFT_OUTSIDE_DOMAIN or NETLOFT_ERROR. */
  int (*evaluate)(void* host, uint32_t want, const double* u, double* energy, double* residual);
  /* Factorises `matrix` of the last evaluation + shift x metric. The metric is the linear stiffness. */
  int (*factorise)(void* host, int matrix, double shift);
  /* Solves with the last successful factorisation; rhs and x may be the same. */
  int (*solve)(void* host, const double* rhs, double* x);
  /* y = (matrix + shift x metric) x, with a matrix of the last evaluation. */
  int (*multiply)(void* host, int matrix, double shift, const double* x, double* y);
  /* Counts an iteration at an accepted point u with the given residual. Returns a netloft_progress. The last
   * evaluation need not have been at u. */
  int (*progress)(void* host, const double* u, double energy, const double* residual, const char* note);
  /* Largest displacement of a node in the step du, divided by the length of the longest element. */
  double (*step_length)(void* host, const double* du);

  char* message; /* memory for a sentence of the solver */
  uint32_t message_size;

  /* y[i] = sum of |entry| over row i of (matrix + shift x metric), of the last evaluation. The largest sum
   * bounds the largest eigenvalue; dynamic relaxation uses the sums as masses. */
  int (*row_sums)(void* host, int matrix, double shift, double* y);
  /* Negative eigenvalues of the last matrix factorised with INDEFINITE, or -1 if not known. */
  int (*negative_pivots)(void* host);
  /* Factorises (1 - share) x exact + share x convex + shift x metric, with `share` in [0, 1]. Evaluations at
   * the same point must have stored both matrices. */
  int (*factorise_between)(void* host, double share, double shift);
  /* Computes energy [J], residual [N] and gradient of the energy [N] at u; none of them may be null. The
   * results have the same bits as those of two calls of `evaluate`, with and without NETLOFT_WANT_GRADIENT,
   * but cost little more than one call. Stores no matrix. Returns the same as `evaluate`. */
  int (*evaluate_both)(void* host, const double* u, double* energy, double* residual, double* gradient);
} netloft_problem;

typedef struct netloft_solver {
  uint32_t size;
  uint32_t needs; /* traits of the problem without which the solver cannot work */
  const char *name, *doc;
  uint32_t parameter_bytes;
  uint32_t parameter_count;
  const netloft_parameter* parameters;
  int (*solve)(const void* parameters, netloft_problem* problem); /* returns a netloft_outcome */
} netloft_solver;

/* A plugin offers this struct. */
typedef struct netloft_solvers {
  uint32_t size;
  uint32_t count;
  const netloft_solver* rows;
} netloft_solvers;

#ifdef __cplusplus
}
#endif
#endif
