/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The boundary between Netloft and a plugin: plain data and C functions, nothing else.
 *
 * A plugin is a shared object that exports one symbol, netloft_plugin_v1, which returns a description of the
 * elements, laws, solvers, integrators and strategies inside. No C++ type, exception or allocation crosses;
 * the plugin links to nothing of ours. Authors seldom need this file: netloft/element.hpp, law.hpp,
 * solver.hpp, integrator.hpp and strategy.hpp write these structs for them.
 *
 * Every struct begins with its own size. Fields are only ever appended, so that a host reads an older
 * plugin (what is missing is zero) and a plugin of the same major version runs in a newer host.
 * Arrays of structs are stepped through by the size of their first entry.
 *
 * Units are SI. World frame: z up, z = 0 at the water surface. Positions [m], velocities [m/s], forces [N].
 *
 * Signs: a term returns its contribution to the residual, +dE/dx (minus the physical force). Its tangent
 * cu dforce/du + cv dforce/dv + ca dforce/da is positive definite for a taut twine.
 */
#ifndef NETLOFT_PLUGIN_H
#define NETLOFT_PLUGIN_H
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define NETLOFT_ABI_MAJOR 1
#define NETLOFT_ABI_MINOR 4
#define NETLOFT_LANES 64 /* elements in a tile */

/* What a function returns. OUTSIDE_DOMAIN: this state has no force, shorten the step. ERROR: stop. */
enum { NETLOFT_OK = 0, NETLOFT_OUTSIDE_DOMAIN = 1, NETLOFT_ERROR = -1 };

/* ---------------------------------------------------------------- parameters */

enum netloft_kind {
  NETLOFT_REAL = 0,    /* double */
  NETLOFT_INTEGER = 1, /* int64_t */
  NETLOFT_BOOLEAN = 2, /* one byte, 0 or 1 (bool) */
  NETLOFT_CHOICE = 3,  /* int64_t: place in `choices` */
  NETLOFT_TEXT = 4,    /* const char *, owned by the host */
  NETLOFT_TABLE = 5    /* netloft_table, owned by the host */
};

/* A sampled curve: rows with ascending first column, `columns` numbers each, row by row. Over two arguments
 * (netloft_parameter.arguments) the rows are a grid: they ascend by the first column, and within each value
 * of it by the second, which has the same values every time. */
typedef struct netloft_table {
  const double* values;
  uint32_t rows, columns;
} netloft_table;

/* What a host must know of a parameter to lead a solver to a hard answer over easier ones. */
enum {
  NETLOFT_REQUIRED = 1,
  NETLOFT_STIFFNESS = 2,   /* elastic forces grow in proportion to it: a host may start with less */
  NETLOFT_COMPRESSION = 4, /* stiffness of what is slack: at zero, the elastic energy is convex */
  NETLOFT_DAMPING = 8      /* tension per strain rate of what NETLOFT_STIFFNESS is the stiffness of */
};

/* One value that a user may set. Its name may hold dots: "twine.EA" is EA in the table `twine`. */
typedef struct netloft_parameter {
  uint32_t size;
  uint32_t kind;
  const char* name;
  const char* unit;                /* SI; "1": a pure number; "solver", "strategy": a text names one */
  const char* doc;                 /* half a sentence: "axial stiffness of one twine" */
  double fallback;                 /* value when absent; with `fallback_of`, a factor on that parameter */
  double lo, hi;                   /* allowed range, both ends included */
  uint32_t flags;                  /* NETLOFT_REQUIRED, NETLOFT_STIFFNESS and the other roles above */
  uint32_t offset;                 /* of the value in the parameter struct */
  const char* fallback_of;         /* name of an earlier real, or null */
  const char* const* choices;      /* null-terminated, for NETLOFT_CHOICE; of a text: any of them, by + */
  const char* fallback_text;       /* for NETLOFT_TEXT */
  const char* const* columns;      /* names of a table's columns, null-terminated */
  const char* const* column_units; /* their units, as many */
  uint32_t arguments; /* leading columns of a table that the others are over; 0 means 1, 2 a grid */
  uint32_t reserved;
} netloft_parameter;

/* ---------------------------------------------------------------- elements */

/* What an element stands on. The low byte is the number of nodes.
 *
 * A rigid body is its origin and, in place of one more node, the rotation vector p that turns its axes into
 * those of the world [rad]: a point r of the body is at x + R r, R = exp [p]x. Rows 3 to 5 of tile.x, v and a
 * are p and its rates, those of tile.force minus the moment that does work on p [N m], and the tangent is
 * the plain derivative: rotation.hpp has the formulas, and element.hpp spares authors from all of this. p may
 * be longer than a turn. Rows 3 to 5 of tile.current have no meaning. */
enum netloft_stencil {
  NETLOFT_NODE = 1,
  NETLOFT_BAR = 2,
  NETLOFT_TRIANGLE = 3,     /* outer face seen counter-clockwise */
  NETLOFT_BAR_PAIR = 0x103, /* nodes of two neighbouring bars of one rope, in order */
  NETLOFT_TRIANGLE_PAIR =
      0x104,           /* the shared edge (a, b), then the corners opposite: c of the triangle (a, b, c), d */
  NETLOFT_BODY = 0x201 /* a rigid body */
};

/* A number (or `width` numbers) that every element has of its own: rest length, twine coordinates of corners.
 */
typedef struct netloft_datum {
  uint32_t size;
  uint32_t width;
  const char *name, *unit, *doc;
} netloft_datum;

/* A number that all elements of a part share, solved for together with the positions: where a catch ends. At
 * most three; they stand as x, y and z of one more node, the last of every element's nodes in a tile. The
 * host takes them for coordinates, and what stands in their place in the force for forces: choose a unit in
 * which a step of 1 means as much as one of 1 m, and scale the equation of each to newtons. */
typedef struct netloft_global {
  uint32_t size;
  uint32_t reserved;
  const char *name, *unit, *doc;
  const char* needs; /* a real parameter that must differ from zero, or it stands where it starts; or null */
} netloft_global;

/* Traits of a term. */
enum {
  NETLOFT_CONSERVATIVE = 1 << 0,   /* force is the gradient of an energy, which it gives */
  NETLOFT_SYMMETRIC = 1 << 1,      /* tangent is symmetric and packed as lower triangle */
  NETLOFT_CONSTANT = 1 << 2,       /* force does not depend on the state: no tangent */
  NETLOFT_READS_VELOCITY = 1 << 3, /* wants tile.v when there is one */
  NETLOFT_READS_ACCELERATION = 1 << 4,
  NETLOFT_READS_CURRENT = 1 << 5, /* wants tile.current and tile.current_dz when there is one */
  NETLOFT_NEEDS_GRAVITY = 1 << 6, /* gives nothing without gravity */
  NETLOFT_NEEDS_FLOW = 1 << 7,    /* gives nothing without a current or motion */
  NETLOFT_NEEDS_MOTION = 1 << 8,  /* gives nothing in a static analysis */
  NETLOFT_HAS_CONVEX = 1 << 9,    /* answers WANT_CONVEX itself; otherwise the host projects its tangent */
  NETLOFT_HAS_METRIC = 1 << 10,   /* answers WANT_METRIC itself; otherwise the host bounds its tangent */
  NETLOFT_FROM_OUTSIDE = 1 << 11, /* pushes against something that is no node (seabed, wall, pressure): the
                                     forces need not sum to zero, nor be the same in another place */
  NETLOFT_READS_STATE = 1 << 12,  /* wants tile.state and fills tile.state_new */
  NETLOFT_READS_TIME = 1 << 13,   /* force and energy may change with tile.time where nothing moves */
  NETLOFT_OF_MEMBERS = 1 << 14,   /* the force is that of the element's members (netloft_member), no more */
  NETLOFT_IS_WEIGHT = 1 << 15,    /* reports count it as weight in water */
  NETLOFT_IS_DRAG = 1 << 16,      /* reports count it as force of the flowing water */
  NETLOFT_READS_GROUND = 1 << 17, /* wants tile.ground when the ground passes the gear; it may be given no
                                     tile.state then, for what only slides remembers nothing */
  NETLOFT_READS_BED = 1 << 18,    /* wants tile.bed when the scene has a bed */
  NETLOFT_READS_WAVES = 1 << 19,  /* wants tile.water_acceleration and tile.surface when the water swings; its
                                     force and energy may change with tile.time then */
  NETLOFT_NEEDS_WAVES = 1 << 24   /* gives nothing where the water does not swing */
};

/* What a call of a term must add. At most one of the three matrices is asked for in a call; CONVEX and METRIC
 * are asked for alone. */
enum {
  NETLOFT_WANT_ENERGY = 1,
  NETLOFT_WANT_FORCE = 2,
  NETLOFT_WANT_TANGENT = 4, /* the exact tangent */
  NETLOFT_WANT_CONVEX = 8,  /* a positive semi-definite part of the tangent */
  NETLOFT_WANT_METRIC =
      16, /* the linear stiffness: constant, positive semi-definite, bounds the convex part */
  NETLOFT_WANT_GRADIENT =
      32 /* of a problem only: residual of the conservative terms, gradient of the energy */
};

/* Up to 64 elements of one family. Arrays are [degree of freedom][64], lanes 0 … count-1 in use; the degree
 * of freedom is 3*node + axis. Inputs that the term did not ask for, or that the scene does not have, are
 * null. A term ADDS to its outputs, in lanes below `count` only; outputs that are not wanted are null. */
typedef struct netloft_tile {
  uint32_t size;
  uint32_t want;
  uint32_t first; /* index of lane 0 in the family; a multiple of 64 */
  uint32_t count;
  double time;              /* [s] */
  double cu, cv, ca;        /* factors of the tangent */
  double water_density;     /* [kg/m3] */
  double gravity;           /* [m/s2] */
  const double* x;          /* positions [m] */
  const double *v, *a;      /* velocities, accelerations; null at rest */
  const double* current;    /* velocity of the water at the nodes [m/s] */
  const double* current_dz; /* its derivative with z [1/s] */
  double* energy;           /* [64] [J] */
  double* force;            /* [dof][64] residual [N] */
  double* tangent; /* packed lower triangle, entry r(r+1)/2+c, if symmetric; else r*dofs+c; [entry][64] */
  char* message;   /* room for a sentence when the status is not OK */
  uint32_t message_size;
  uint32_t lane_at_fault; /* set with a status that is not OK */
  double water_viscosity; /* kinematic [m2/s] */
  const double* state;    /* [state_width][64] what the element remembers of the last accepted step */
  double* state_new;      /* [state_width][64] what it will remember if this one is accepted */
  const double* x_low;    /* digits that x has no room for: positions are x + x_low; mostly null: not known.
                             A term may ignore them; stiff ones gain digits in differences of positions [m] */
  const double* ground; /* [3] velocity at which the ground passes a towed gear [m/s]; null where it stands */
  const double* bed; /* [6 nodes][64] the bed of the scene below each node of the stencil: its height z_b [m],
                        dz_b/dx, dz_b/dy, and its second derivatives xx, xy, yy [1/m]; null: there is none */
  const double*
      water_acceleration; /* of the water at the nodes, as it passes them [m/s2]; null: it is none */
  const double* surface;  /* [nodes][64] height of the surface of the water over the nodes, above z = 0 [m];
                             null: it is z = 0 everywhere */
} netloft_tile;

typedef struct netloft_term {
  uint32_t size;
  uint32_t traits;
  const char *name, *doc;
  const char* needs; /* real parameters, one of which must differ from zero for the term to act, a space
                        between two; or null */
  int (*evaluate)(const void* self, netloft_tile* tile);
} netloft_term;

/* What an output means to reports that compare parts of different types. */
enum netloft_output_role {
  NETLOFT_OUTPUT_PLAIN = 0,
  NETLOFT_OUTPUT_TENSION = 1, /* tension in a rope or in one twine [N], negative in compression */
  NETLOFT_OUTPUT_DOUBT = 2 /* differs from zero where the element is used beyond what is known of it, as its
                              sentence says; reports warn of it */
};

/* A number reported per element, in physical sign: tension is positive when the rope pulls. */
typedef struct netloft_output {
  uint32_t size;
  uint32_t role; /* netloft_output_role */
  const char *name, *unit, *doc;
} netloft_output;

/* What bears tension in an element along one line: the bar of a rope, or all bars of one direction of a
 * triangle of netting. Its chord is w = sum of c[i] x[i] over the nodes of the element, l = |w|, t = w/l,
 * and its force on node i
 *     number c[i] T t,   T = EA (l/l0 - 1) where l > l0, else EA_compression (l/l0 - 1)
 * The sum over the members of an element is its term with NETLOFT_OF_MEMBERS. */
typedef struct netloft_member {
  double c[3];               /* of the chord; the third is zero on two nodes */
  double rest_length;        /* l0 [m] */
  double EA, EA_compression; /* axial stiffness of one, taut and slack [N] */
  double number;             /* bars or twines alike that it stands for */
} netloft_member;

/* ---------------------------------------------------------------- laws */

/* What a law speaks of. */
enum netloft_law_kind {
  NETLOFT_TWINE_LAW = 1, /* force of the water on a twine, bar or rope, per metre of it */
  NETLOFT_SCREEN_LAW = 2 /* force of the water on netting as a screen, per square metre of it */
};

/* Up to 64 twines or screens in a flow. Arrays are [component][64]. The law ADDS nothing: it writes its
 * outputs, in lanes below `count`. Derivatives are null when not wanted. */
typedef struct netloft_law_tile {
  uint32_t size;
  uint32_t count;
  double water_density;    /* [kg/m3] */
  double water_viscosity;  /* kinematic [m2/s] */
  const double* flow;      /* [3][64] velocity of the water relative to the twine [m/s] */
  const double* direction; /* [3][64] unit vector along the twine, or normal to the screen */
  const double* diameter;  /* [64] of the twine [m] */
  const double* solidity;  /* [64] area of the twines over area of the netting; zero for a rope */
  double* force;           /* [3][64] physical force [N/m] or [N/m2] */
  double* d_flow;          /* [9][64] dforce[r]/dflow[c] at 3r+c */
  double* d_direction;     /* [9][64] dforce[r]/ddirection[c] */
  double* d_solidity;      /* [3][64] */
  const double* extent; /* [64] metres of twine, square metres of netting that a lane stands for, for reports
                           of how much of a gear is where; null: not told. No force depends on it */
} netloft_law_tile;

/* Quantities of a flow in which a law may be valid over a range only. */
enum netloft_law_quantity {
  NETLOFT_REYNOLDS = 0,        /* |flow| D/viscosity */
  NETLOFT_REYNOLDS_ACROSS = 1, /* the same of the flow across a twine */
  NETLOFT_REYNOLDS_IN_MESHES =
      2, /* |flow| D/(viscosity (1 - solidity)): of the flow through a screen's meshes */
  NETLOFT_SOLIDITY = 3,
  NETLOFT_ATTACK = 4 /* angle between the flow and the twine or the netting, 0 to pi/2 [rad] */
};

/* A range that a law was measured in. The host compares what the law is asked with it and reports how much of
 * a gear lies outside; the law itself answers everywhere. */
typedef struct netloft_validity {
  uint32_t size;
  uint32_t quantity;
  double lo, hi;
  const char* source;         /* who measured: "Loland 1991" */
  const char *where, *unless; /* parameters with which the range holds, with which it does not: those that are
                                 given, no real at zero, no empty table, no first word of a choice; or null */
} netloft_validity;

/* A pure function that elements use without knowing it: "hydro/morison". */
typedef struct netloft_law {
  uint32_t size;
  uint32_t kind;
  const char *name, *doc;
  uint32_t parameter_bytes;
  uint32_t parameter_count;
  const netloft_parameter* parameters;
  int (*evaluate)(const void* parameters, const netloft_law_tile* flow);
  const netloft_validity* validity;
  uint32_t validity_count;
  uint32_t reserved;
} netloft_law;

/* A place in an element for a law: the user names one under this key. */
typedef struct netloft_law_slot {
  uint32_t size;
  uint32_t accepts;       /* sum of netloft_law_kind */
  const char *name, *doc; /* "drag" */
  const char* fallback;   /* "hydro/morison" */
} netloft_law_slot;

/* The law in a slot, resolved by the host. All elements of a family share it. */
typedef struct netloft_bound_law {
  uint32_t kind;
  uint32_t reserved;
  const void* parameters;
  int (*evaluate)(const void* parameters, const netloft_law_tile* flow);
} netloft_bound_law;

/* ---------------------------------------------------------------- creation */

/* What the host hands to `create`: all elements of one type in a scene, at once. */
typedef struct netloft_create {
  uint32_t size;
  uint32_t count; /* elements */
  uint32_t part_count;
  uint32_t at_fault;             /* set by `create`: the element it refuses */
  const void* const* parameters; /* [part] filled parameter struct; valid as long as the family */
  const uint32_t* part;          /* [element] which part it belongs to */
  const double* const* data;     /* [datum] -> [element][width] */
  char* message;
  uint32_t message_size;
  uint32_t law_count;
  const netloft_bound_law* laws; /* [slot] */
  double* globals;               /* [part][global] set by `create`: where each starts; null if none */
} netloft_create;

typedef struct netloft_element {
  uint32_t size;
  uint32_t stencil;
  const char *name, *doc;   /* "bar" in plugin "rope" is rope/bar */
  uint32_t parameter_bytes; /* size of the parameter struct */
  uint32_t parameter_count;
  const netloft_parameter* parameters;
  const netloft_datum* data;
  uint32_t datum_count;
  uint32_t term_count;
  const netloft_term* terms;
  const netloft_output* outputs;
  uint32_t output_count;
  uint32_t reserved;
  int (*create)(netloft_create* in, void** self);
  void (*destroy)(void* self);
  int (*output)(const void* self, netloft_tile* tile, double* values); /* values[output][64] */
  const char* rides_on; /* an element of the same plugin: made wherever that one is used, on pairs of it */
  const netloft_law_slot* laws;
  uint32_t law_count;
  uint32_t state_width; /* numbers an element remembers */
  const netloft_global* globals;
  uint32_t global_count;
  uint32_t member_count; /* members of each element; zero: none are told */
  /* Writes the members of elements first … first + count - 1 at a time [s]: out[element][member]. */
  int (*members)(const void* self, double time, uint32_t first, uint32_t count, netloft_member* out);
} netloft_element;

/* ---------------------------------------------------------------- solvers */

/* Which matrix of the last evaluation a factorisation takes. With INDEFINITE added, any matrix that is not
 * singular will do (LU); without it, a symmetric matrix that is not positive definite is refused at no great
 * price. */
enum netloft_matrix { NETLOFT_EXACT = 0, NETLOFT_CONVEX = 1, NETLOFT_NONE = 2, NETLOFT_INDEFINITE = 16 };

/* How a factorisation ended. */
enum netloft_factor {
  NETLOFT_FACTOR_OK = 0,
  NETLOFT_NOT_POSITIVE = 1,
  NETLOFT_SINGULAR = 2,
  NETLOFT_FACTOR_FAILED = 3
};

/* Answer of `progress`: go on, the point is good enough, or give up (limit reached, interrupted). */
enum netloft_progress { NETLOFT_GO_ON = 0, NETLOFT_ARRIVED = 1, NETLOFT_GIVE_UP = 2 };

/* Why a solver returned. The host recomputes the residual and has the last word on convergence. */
enum netloft_outcome {
  NETLOFT_STOPPED = 0,        /* `progress` said ARRIVED or GIVE_UP */
  NETLOFT_STEP_TOO_SHORT = 1, /* no step brings it closer */
  NETLOFT_LINEAR_SOLVE = 2,   /* the matrix could not be factorised */
  NETLOFT_LEFT_DOMAIN = 3,    /* an element has no force at the point */
  NETLOFT_NOT_FINITE = 4,     /* numbers overflowed */
  NETLOFT_SOLVER_ERROR = 5    /* see message */
};

/* What a solver sees of a scene: r(u) = 0, with an energy whose gradient is r if the problem is conservative.
 * `u` are displacements of the unknowns from the start [m]. Every function takes `host` first. */
typedef struct netloft_problem {
  uint32_t size;
  uint32_t unknowns;
  uint32_t traits; /* NETLOFT_CONSERVATIVE, NETLOFT_SYMMETRIC */
  uint32_t reserved;
  void* host;
  double* u; /* in: where to start; out: where the solver ended */

  /* Evaluates at u: energy [J] and residual [N] as wanted (either may be null), and keeps the wanted matrix.
   * Returns NETLOFT_OK, NETLOFT_OUTSIDE_DOMAIN or NETLOFT_ERROR. */
  int (*evaluate)(void* host, uint32_t want, const double* u, double* energy, double* residual);
  /* Factorises `matrix` of the last evaluation + shift x metric. The metric is the linear stiffness. */
  int (*factorise)(void* host, int matrix, double shift);
  /* Solves with the last good factor; rhs and x may be the same. */
  int (*solve)(void* host, const double* rhs, double* x);
  /* y = (matrix + shift x metric) x, of the last evaluation. */
  int (*multiply)(void* host, int matrix, double shift, const double* x, double* y);
  /* Statistics one iteration at an accepted point u whose residual is given; says whether to go on. What was
   * evaluated before does not matter. */
  int (*progress)(void* host, const double* u, double energy, const double* residual, const char* note);
  /* Largest move of a node over the largest element length, of a step du: a pure number. */
  double (*step_length)(void* host, const double* du);

  char* message; /* room for a sentence of the solver's */
  uint32_t message_size;

  /* y[i] = sum of |entry| over row i of (matrix + shift x metric), of the last evaluation: bounds its largest
   * eigenvalue, and fits masses. */
  int (*row_sums)(void* host, int matrix, double shift, double* y);
  /* Negative eigenvalues of the last matrix factorised with INDEFINITE, or -1 if not known. */
  int (*negative_pivots)(void* host);
  /* Factorises (1 - share) x exact + share x convex + shift x metric, both kept by evaluations at the same
   * point; `share` in [0, 1]. */
  int (*factorise_between)(void* host, double share, double shift);
  /* Energy [J], residual [N] and gradient of the energy [N] at u, none of them null: the same bits as from
   * two calls of `evaluate`, with and without NETLOFT_WANT_GRADIENT, for little more than the price of one.
   * Keeps no matrix. Returns as `evaluate`. */
  int (*evaluate_both)(void* host, const double* u, double* energy, double* residual, double* gradient);
} netloft_problem;

typedef struct netloft_solver {
  uint32_t size;
  uint32_t needs; /* traits without which it cannot work */
  const char *name, *doc;
  uint32_t parameter_bytes;
  uint32_t parameter_count;
  const netloft_parameter* parameters;
  int (*solve)(const void* parameters, netloft_problem* problem); /* returns a netloft_outcome */
} netloft_solver;

/* ---------------------------------------------------------------- integrators */

/* What an integrator sees of a scene that moves: F(t, u, v, a) = 0, in which one step leads from t to t + h.
 * u are displacements of the unknowns from the start [m], v and a their rates. F is the residual: inertia and
 * all other forces, +dE/dx. The host chooses h, accepts or rejects what a step has found, and keeps the
 * statistics. */
typedef struct netloft_motion {
  uint32_t size;
  uint32_t unknowns;
  void* host;
  double t, h;                   /* [s] */
  const double *u, *v, *a;       /* at t; a is whatever the integrator left there itself */
  double *u_new, *v_new, *a_new; /* out: at t + h */
  double* error; /* out: estimate of the error of u_new in this step [m]; zero if left alone */

  /* F(t, u, v, a) [N]. Returns NETLOFT_OK, NETLOFT_OUTSIDE_DOMAIN or NETLOFT_ERROR. */
  int (*residual)(void* host, double t, const double* u, const double* v, const double* a, double* residual);
  /* a such that F(t, u, v, a) = 0; explicitly, by the masses of the nodes. */
  int (*accelerate)(void* host, double t, const double* u, const double* v, double* a);
  /* u such that F(t, u, v0 + cv u, a0 + ca u) = 0, from the u given, by the solver of the analysis. OK, or
   * NETLOFT_OUTSIDE_DOMAIN if it did not arrive: a shorter step may. */
  int (*solve)(void* host, double t, const double* v0, double cv, const double* a0, double ca, double* u);
  /* Room for `unknowns` numbers, the same for the same index as long as the integration lasts. */
  double* (*scratch)(void* host, uint32_t index);

  char* message; /* room for a sentence of the integrator's */
  uint32_t message_size;
  uint32_t reserved;

  /* u such that the mean forces of the step from `u` at t to that u at t + h are in balance, where
   *   v = v0 + cv u and a = a0 + ca u
   * are the rates in the middle of the step. Means are F at the middle of both ends, but for forces with an
   * energy: those do exactly the work over the step by which their energy falls, and push and turn nothing
   * as a whole that they do not push and turn in the middle. Members (netloft_member) resist a change of
   * length from step to step in addition, with a tension
   *   T = damping/2 k (Dl - m),  m <- m + memory (Dl - m) once the step is accepted
   * k their stiffness, Dl the change of their length in the step. Returns as `solve`. */
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
  /* One step. Returns NETLOFT_OK, NETLOFT_OUTSIDE_DOMAIN (a shorter step may do) or NETLOFT_ERROR. */
  int (*step)(const void* parameters, netloft_motion* motion);
  /* Order of the error estimate: it shrinks with this power of the step. */
  double (*order)(const void* parameters);
  /* Longest step [s] that is stable where the highest angular frequency is `omega` [rad/s]; 0: any is. */
  double (*stable_step)(const void* parameters, double omega);
} netloft_integrator;

/* ---------------------------------------------------------------- strategies */

/* How a scene is made easier. Values, not code: whoever chooses them need not know any element. The host
 * knows by the roles of parameters which of them each value touches. */
typedef struct netloft_variant {
  uint32_t size;
  uint32_t level; /* mesh: 0 the scene's own, 1, 2, … each with about half as many cells along a side */
  double
      stiffness_cap; /* [N] stiffnesses of a part are lowered together until none exceeds it; 0: as written */
  double compression; /* factor on the stiffness of what is slack, in [0, 1] */
  double current;     /* factor on the current, in [0, 1] */
} netloft_variant;

/* What a search knows of its scene, beside NETLOFT_CONSERVATIVE and NETLOFT_SYMMETRIC. */
enum netloft_search_trait {
  NETLOFT_SEARCH_REMEMBERS = 1 << 20,   /* elements remember (dry friction) */
  NETLOFT_SEARCH_FLOWS = 1 << 21,       /* there is a current */
  NETLOFT_SEARCH_COMPRESSION = 1 << 22, /* some stiffness of what is slack differs from zero */
  NETLOFT_SEARCH_MEMBERS =
      1 << 23 /* `members` works: tension is borne by members, on nodes that move freely */
};

/* How a stage ended, by the host. */
enum netloft_ending {
  NETLOFT_ENDED_CONVERGED = 0,     /* forces balance, and nothing was found that grows */
  NETLOFT_ENDED_UNSTABLE = 1,      /* forces balance, and a small disturbance grows */
  NETLOFT_ENDED_NOT_CONVERGED = 2, /* the solver found no way on */
  NETLOFT_ENDED_OUT_OF_WORK = 3,   /* its budget of work or of iterations was used up */
  NETLOFT_ENDED_UNSETTLED = 4,     /* it went farther than `path`, or away for ever */
  NETLOFT_ENDED_INTERRUPTED = 5    /* by the user, or the user's time is over: return */
};

enum netloft_stability {
  NETLOFT_STABILITY_UNKNOWN = 0,
  NETLOFT_STABLE = 1,
  NETLOFT_NEUTRAL = 2,  /* something can move without any force */
  NETLOFT_MARGINAL = 3, /* growth is not told from none: see growth.hpp of the host */
  NETLOFT_UNSTABLE = 4
};

enum netloft_stage_flag {
  NETLOFT_COMPENSATED = 1 /* positions keep the digits that double precision rounds off; slower, for what
                             rounding alone keeps from balance */
};

/* One solve of one variant: what is asked, and what came of it. The work that one factorisation of the
 * scene's own tangent costs, with the evaluation and the solution that go with it, is the unit of work. */
typedef struct netloft_stage {
  uint32_t size;
  uint32_t flags; /* netloft_stage_flag */
  netloft_variant variant;
  const char* name;       /* what it is for, in a few words, for the report */
  const char* solver;     /* "ptc"; null: that of the analysis, with its parameters */
  const char* parameters; /* "method=classic,damping=1"; null: none but those */
  double tolerance;       /* largest residual over the largest load; 0: that of the analysis */
  double work;            /* budget; 0: whatever the search has left */
  double path;            /* most that nodes may move in all, over the gear's size; 0: any */
  uint32_t iterations;    /* limit; 0: that of the analysis */
  uint32_t reserved;
  double*
      u; /* displacements of the unknowns of the variant's level: in, where to start; out, where it ended */

  uint32_t ending, stability;    /* netloft_ending, netloft_stability */
  double residual, load, energy; /* largest residual and load on a node [N], [N]; [J] */
  double rounding;               /* what rounding of the positions is worth [N] */
  double spent;                  /* work */
  uint32_t iterations_done, factorisations;
  const double*
      growing;        /* a disturbance that grows, as long as u; null: not known. Valid until the next call */
  double growth_rate; /* of that [1/s]; zero where it is not known */
  double growth_frequency; /* with which it swings as it grows [rad/s] */
} netloft_stage;

/* The members of a variant and all its other forces apart, for methods in which the tension of a member is an
 * unknown of its own. Vectors over all degrees of freedom have the unknowns first, then the held ones, whose
 * residuals are reactions. */
typedef struct netloft_members {
  uint32_t size;
  uint32_t count;               /* members */
  uint32_t unknowns, dofs;      /* lengths of u, of a residual */
  uint32_t parts;               /* parts of the scene */
  uint32_t traits;              /* NETLOFT_SYMMETRIC: the tangent of the other forces is */
  void* host;                   /* valid until the search is asked for anything else */
  const netloft_member* member; /* [count] */
  const uint32_t* part;         /* [count] part of the scene that a member belongs to */
  double largest_coordinate;    /* [m] at the start, for the worth of rounding */

  /* w[count][3]: chords of the members at displacements u [m]. */
  int (*chords)(void* host, const double* u, double* w);
  /* w[count][3]: by how much a step of the unknowns changes the chords [m]. */
  int (*changes)(void* host, const double* step, double* w);
  /* Residual of all other forces at u [N], dofs long; keeps their tangent. NETLOFT_OK, or there are none. */
  int (*evaluate)(void* host, const double* u, double* residual);
  /* residual += sum of number c f over the members, f[count][3] [N]. */
  int (*add_forces)(void* host, const double* f, double* residual);
  /* Starts a matrix: the tangent of the last evaluation + sum of number c c^T K, K[count][9] symmetric [N/m].
   */
  int (*set_matrix)(void* host, const double* K);
  /* The same of members with K = a t t^T + b I, lines[count][6] = (t, f, a, b); adds number c f t to the
   * residual, too. */
  int (*set_matrix_along)(void* host, const double* lines, double* residual);
  /* Factorises the matrix; NETLOFT_INDEFINITE: any that is not singular will do. Returns a netloft_factor. */
  int (*factorise)(void* host, int how);
  int (*solve)(void* host, const double* rhs, double* x);
  /* Counts an iteration whose largest residual is given [N]; says whether to go on (netloft_progress). */
  int (*progress)(void* host, double residual, const char* note);
} netloft_members;

/* What a strategy sees: a scene and its easier variants, solved stage by stage within a budget of work. The
 * host counts, judges and keeps the statistics; a strategy never says of itself that it has converged.
 * Functions take `host` first and return NETLOFT_OK, or NETLOFT_ERROR with a sentence in `message`. */
typedef struct netloft_search {
  uint32_t size;
  uint32_t unknowns;
  uint32_t levels; /* meshes there may be, at least one; `size_of` says which there are */
  uint32_t traits; /* NETLOFT_CONSERVATIVE, NETLOFT_SYMMETRIC, netloft_search_trait */
  void* host;
  const double* start; /* displacements to start from, `unknowns` long; null: from the sketch */
  double gear_size;    /* largest distance of nodes at the start [m] */
  double element_size; /* longest element at the start [m] */
  double load;         /* sum of the forces that drive the gear at the start [N] */
  double largest_load; /* largest of them on a node [N] */
  double stiffness;    /* largest axial stiffness [N] */
  uint32_t member_count;
  uint32_t message_size;
  char* message;

  /* Unknowns of a level; zero where there is no such level. */
  uint32_t (*size_of)(void* host, uint32_t level);
  int (*solve)(void* host, netloft_stage* stage);
  /* The same by another strategy: the variant is its scene, stage.work its budget. */
  int (*call)(void* host, const char* strategy, const char* parameters, netloft_stage* stage);
  /* Reads displacements of one level off those of another. */
  int (*transfer)(void* host, uint32_t from, const double* u, uint32_t to, double* out);
  /* Judges stage.u without solving anything. */
  int (*assess)(void* host, netloft_stage* stage);
  /* r(u) = 0 of a variant, with stage.u as its u and within stage.work, for a strategy with a method of its
   * own. `problem->size` says how much room there is, and afterwards how much of it the host has filled. Ends
   * with the next call of another function of the search; then `assess` tells what it is worth. */
  int (*problem)(void* host, netloft_stage* stage, netloft_problem* problem);
  /* Likewise, where the search has NETLOFT_SEARCH_MEMBERS. */
  int (*members)(void* host, netloft_stage* stage, netloft_members* members);
  /* Budget that is left; never negative. Zero, also where the user interrupts: return. */
  double (*work_left)(void* host);
  /* An equilibrium of the scene itself. May be called again, for another shape; the host judges each and
   * chooses: converged before anything else, then the least energy where forces have one, then the first. */
  int (*answer)(void* host, const double* u);
} netloft_search;

typedef struct netloft_strategy {
  uint32_t size;
  uint32_t needs; /* traits of the search without which it cannot work */
  const char *name, *doc;
  uint32_t parameter_bytes;
  uint32_t parameter_count;
  const netloft_parameter* parameters;
  /* Returns NETLOFT_OK, whether or not there is an answer, or NETLOFT_ERROR with a sentence. */
  int (*run)(const void* parameters, netloft_search* search);
  /* Writes what it would try, in which order and why, a line each, without solving anything. May be null. */
  int (*explain)(const void* parameters, netloft_search* search, char* text, uint32_t text_size);
} netloft_strategy;

/* ---------------------------------------------------------------- the plugin */

enum { NETLOFT_FAST_MATH = 1 };

typedef struct netloft_plugin {
  uint32_t size;
  uint32_t abi_major, abi_minor;
  uint32_t flags;   /* NETLOFT_FAST_MATH when compiled so: refused */
  const char* name; /* the stem of its file: "rope" in rope.so */
  const char *version, *doc, *compiler;
  const netloft_element* elements;
  const netloft_solver* solvers;
  uint32_t element_count, solver_count;
  const netloft_law* laws;
  uint32_t law_count, integrator_count;
  const netloft_integrator* integrators;
  const netloft_strategy* strategies;
  uint32_t strategy_count, reserved;
} netloft_plugin;

#if defined(__FAST_MATH__)
#define NETLOFT_BUILD_FLAGS NETLOFT_FAST_MATH
#else
#define NETLOFT_BUILD_FLAGS 0
#endif

#ifndef NETLOFT_PLUGIN_SYMBOL
#define NETLOFT_PLUGIN_SYMBOL netloft_plugin_v1
#endif
#define NETLOFT_EXPORT __attribute__((visibility("default")))

typedef const netloft_plugin* (*netloft_plugin_function)(void);

#ifdef __cplusplus
}
#endif
#endif
