/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Strategies, which bring a scene to equilibrium with solvers. A plugin offers netloft_strategies.
 */
#ifndef NETLOFT_EXT_STRATEGY_H
#define NETLOFT_EXT_STRATEGY_H
#include <netloft/ext/members.h>
#include <netloft/ext/solver.h>

#ifdef __cplusplus
extern "C" {
#endif

#define NETLOFT_EXT_STRATEGY "netloft.strategy/1"

/* An easier variant of a scene, described by numbers that do not refer to particular elements. The host uses
 * the roles of parameters (NETLOFT_STIFFNESS …) to find the parameters that each number changes. */
typedef struct netloft_variant {
  uint32_t size;
  uint32_t
      level; /* mesh: 0 is that of the scene; every next level has about half as many cells along a side */
  double stiffness_cap; /* [N] all stiffnesses of a part are lowered by one factor, so that none exceeds it;
                           0: unchanged */
  double compression;   /* factor on the stiffness of slack members, in [0, 1] */
  double current;       /* factor on the current, in [0, 1] */
} netloft_variant;

/* Traits of the scene of a search, in addition to NETLOFT_CONSERVATIVE and NETLOFT_SYMMETRIC. */
enum netloft_search_trait {
  NETLOFT_SEARCH_REMEMBERS = 1 << 20,   /* elements have a memory (dry friction) */
  NETLOFT_SEARCH_FLOWS = 1 << 21,       /* there is a current */
  NETLOFT_SEARCH_COMPRESSION = 1 << 22, /* some stiffness of slack members is not zero */
  NETLOFT_SEARCH_MEMBERS =
      1 << 23, /* `members` can be called: the gear has members, and all nodes move along x, y, z */
  NETLOFT_SEARCH_BENDING = 1 << 25 /* some elastic forces are not those of members (`bending`) */
};

/* The end of a stage, as assessed by the host. */
enum netloft_ending {
  NETLOFT_ENDED_CONVERGED = 0,     /* forces balance, no growing disturbance was found */
  NETLOFT_ENDED_UNSTABLE = 1,      /* forces balance, and a small disturbance grows */
  NETLOFT_ENDED_NOT_CONVERGED = 2, /* the solver found no further step */
  NETLOFT_ENDED_OUT_OF_WORK = 3,   /* the budget of work or of iterations was used up */
  NETLOFT_ENDED_UNSETTLED = 4,     /* the path of the solver exceeded `path`, or the gear ran away */
  NETLOFT_ENDED_INTERRUPTED = 5    /* interrupted by the user or the time limit; the strategy must return */
};

enum netloft_stability {
  NETLOFT_STABILITY_UNKNOWN = 0,
  NETLOFT_STABLE = 1,
  NETLOFT_NEUTRAL = 2,  /* some motion meets no resistance */
  NETLOFT_MARGINAL = 3, /* growth cannot be distinguished from none (framework/judging/growth.hpp) */
  NETLOFT_UNSTABLE = 4,
  NETLOFT_LOCALLY_UNSTABLE = 5 /* a negligible part of the gear is unstable, and the rest of it is not */
};

enum netloft_stage_flag {
  NETLOFT_COMPENSATED = 1 /* positions keep the digits that double precision rounds off: slower, for scenes in
                             which rounding alone prevents balance */
};

/* One solve of one variant: its task and its result. The unit of work is one factorisation of the tangent of
 * the scene itself, with one evaluation and one solution. */
typedef struct netloft_stage {
  uint32_t size;
  uint32_t flags; /* netloft_stage_flag */
  netloft_variant variant;
  const char* name;       /* purpose of the stage in a few words, for the report */
  const char* solver;     /* "ptc"; null: the solver of the analysis, with its parameters */
  const char* parameters; /* "method=classic,damping=1"; null: none */
  double tolerance;       /* limit of the largest residual over the largest load; 0: as in the analysis */
  double work;            /* budget; 0: all that is left of the search */
  double path;            /* limit of the sum of largest nodal displacements / gear size; 0: none */
  uint32_t iterations;    /* limit of iterations; 0: as in the analysis */
  uint32_t reserved;
  double* u; /* displacements of the unknowns of the variant's level; in: initial guess, out: final point */

  uint32_t ending, stability;    /* netloft_ending, netloft_stability */
  double residual, load, energy; /* largest residual and load on a node [N], [N]; energy [J] */
  double rounding;               /* residual that rounding of the positions can cause [N] */
  double spent;                  /* work */
  uint32_t iterations_done, factorisations;
  const double* growing; /* a disturbance that grows, with as many entries as u; null: not known. Valid until
                            the next call */
  double growth_rate;    /* growth rate of the disturbance [1/s]; zero if it is not known */
  double growth_frequency; /* angular frequency of its oscillation [rad/s] */
} netloft_stage;

/* The members of a variant (lines that bear tension), separate from all other forces, for methods in which
 * the tension of a member is an unknown. Vectors over all degrees of freedom have the unknowns first, then
 * the held degrees of freedom, whose residuals are reactions. */
typedef struct netloft_members {
  uint32_t size;
  uint32_t count;               /* members */
  uint32_t unknowns, dofs;      /* lengths of u, of a residual */
  uint32_t parts;               /* parts of the scene */
  uint32_t traits;              /* NETLOFT_SYMMETRIC if the tangent of the other forces is symmetric */
  void* host;                   /* the struct is valid until another function of the search is called */
  const netloft_member* member; /* [count] */
  const uint32_t* part;         /* [count] part of the scene that a member belongs to */
  double largest_coordinate;    /* largest coordinate at the start [m], to estimate rounding */

  /* Computes the chords w[count][3] of the members at displacements u [m]. */
  int (*chords)(void* host, const double* u, double* w);
  /* Computes the changes w[count][3] of the chords in a step of the unknowns [m]. */
  int (*changes)(void* host, const double* step, double* w);
  /* Computes the residual of all other forces at u [N], dofs long, and stores their tangent. If the result is
   * not NETLOFT_OK, the forces are not defined at u. */
  int (*evaluate)(void* host, const double* u, double* residual);
  /* Adds n c f to the residual for every member, with n = netloft_member.number, forces f[count][3] [N]. */
  int (*add_forces)(void* host, const double* f, double* residual);
  /* Sets the matrix: the tangent of the last evaluation + sum over members of n (c c^T) x K, a Kronecker
   * product, with n and c of a member (netloft_member.number and .c) and K[count][9], symmetric [N/m]. */
  int (*set_matrix)(void* host, const double* K);
  /* Sets the matrix as above for K = a t t^T + b I, and adds n c f t to the residual for every member, with
   * lines[count][6] = (t, f, a, b): unit vector, tension [N], a and b [N/m]. */
  int (*set_matrix_along)(void* host, const double* lines, double* residual);
  /* Factorises the matrix. With how = NETLOFT_INDEFINITE, any matrix that is not singular is accepted.
   * Returns a netloft_factor. */
  int (*factorise)(void* host, int how);
  int (*solve)(void* host, const double* rhs, double* x);
  /* Counts an iteration with the given largest residual [N]. Returns a netloft_progress. */
  int (*progress)(void* host, double residual, const char* note);
} netloft_members;

/* A scene as a strategy sees it, with its easier variants, which are solved stage by stage within a budget of
 * work. The host counts work, assesses points and decides on convergence; a strategy does not. Functions take
 * `host` first and return NETLOFT_OK, or NETLOFT_ERROR with a sentence in `message`. */
typedef struct netloft_search {
  uint32_t size;
  uint32_t unknowns;
  uint32_t levels; /* number of meshes at most, at least one; see `size_of` */
  uint32_t traits; /* NETLOFT_CONSERVATIVE, NETLOFT_SYMMETRIC, netloft_search_trait */
  void* host;
  const double*
      start; /* initial displacements [unknowns]; null: start from the initial positions of the scene */
  double gear_size;    /* largest distance of nodes at the start [m] */
  double element_size; /* longest element at the start [m] */
  double load;         /* sum of the forces that drive the gear at the start [N] */
  double largest_load; /* largest of these forces on a node [N] */
  double stiffness;    /* largest axial stiffness [N] */
  uint32_t member_count;
  uint32_t message_size;
  char* message;

  /* Number of unknowns of a level of mesh; zero if there is no such level. */
  uint32_t (*size_of)(void* host, uint32_t level);
  int (*solve)(void* host, netloft_stage* stage);
  /* Lets another strategy solve a stage. The scene of that strategy is the variant of the stage, its budget
   * is stage.work. */
  int (*call)(void* host, const char* strategy, const char* parameters, netloft_stage* stage);
  /* Interpolates displacements from one level of mesh to another. */
  int (*transfer)(void* host, uint32_t from, const double* u, uint32_t to, double* out);
  /* Assesses stage.u without solving anything. */
  int (*assess)(void* host, netloft_stage* stage);
  /* Gives the problem r(u) = 0 of a variant to a strategy with a method of its own. The u of the problem is
   * stage.u, and the budget is stage.work. The caller sets `problem->size` to the size of its struct; the
   * host sets it to the size that it filled. The problem is valid until another function of the search is
   * called. Afterwards, `assess` computes the result. */
  int (*problem)(void* host, netloft_stage* stage, netloft_problem* problem);
  /* Gives the members of a variant in the same way; the search must have the trait NETLOFT_SEARCH_MEMBERS. */
  int (*members)(void* host, netloft_stage* stage, netloft_members* members);
  /* Work that is left; never negative. If it is zero, also after an interruption by the user, the strategy
   * must return. */
  double (*work_left)(void* host);
  /* Reports an equilibrium of the scene itself. May be called again for another equilibrium. The host
   * assesses all of them and chooses: a converged one if there is any; among several, that of least energy if
   * all forces have an energy, otherwise the first. */
  int (*answer)(void* host, const double* u);
  /* Largest force on a node, along one axis, of all elastic forces that are not those of members: of meshes
   * held open, of bent ropes and netting [N]. The point `u` must be an equilibrium of the scene itself, and
   * all forces must have an energy. The result is zero if the tangent of all other forces is positive
   * definite, because the gear then keeps its shape without these forces. Costs one factorisation. */
  double (*bending)(void* host, const double* u);
} netloft_search;

typedef struct netloft_strategy {
  uint32_t size;
  uint32_t needs; /* traits of the search without which the strategy cannot work */
  const char *name, *doc;
  uint32_t parameter_bytes;
  uint32_t parameter_count;
  const netloft_parameter* parameters;
  /* Returns NETLOFT_OK, whether or not there is an answer, or NETLOFT_ERROR with a sentence. */
  int (*run)(const void* parameters, netloft_search* search);
  /* Writes the plan, one line for each stage with the reason, without solving anything. May be null. */
  int (*explain)(const void* parameters, netloft_search* search, char* text, uint32_t text_size);
} netloft_strategy;

/* A plugin offers this struct. */
typedef struct netloft_strategies {
  uint32_t size;
  uint32_t count;
  const netloft_strategy* rows;
} netloft_strategies;

#ifdef __cplusplus
}
#endif
#endif
