/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Hydrodynamic laws: pure functions for the force of the water. Users choose the law that an element uses. A
 * plugin offers netloft_laws. An element offers netloft_law_slots and receives netloft_bound_laws in
 * `create`.
 */
#ifndef NETLOFT_EXT_LAWS_H
#define NETLOFT_EXT_LAWS_H
#include <netloft/plugin.h>

#ifdef __cplusplus
extern "C" {
#endif

#define NETLOFT_EXT_LAWS "netloft.laws/1"

/* Kinds of bodies to which a law can apply. */
enum netloft_law_kind {
  NETLOFT_TWINE_LAW = 1, /* force of the water on a twine, bar or rope, per metre of its length */
  NETLOFT_SCREEN_LAW =
      2 /* force of the water on netting, treated as a screen, per square metre of its area */
};

/* Up to 64 twines or screens in a flow. Arrays are [component][64]. The law does not add but WRITES its
 * outputs, in lanes below `count`. Derivatives that are not requested are null. */
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
  const double* extent;    /* [64] length of twine [m] or area of netting [m2] that a lane represents: only a
                              weight for reports; null: not known */
} netloft_law_tile;

/* Quantities for which a law may be valid in a limited range only. */
enum netloft_law_quantity {
  NETLOFT_REYNOLDS = 0,           /* |flow| D/viscosity */
  NETLOFT_REYNOLDS_ACROSS = 1,    /* the same number for the part of the flow across a twine */
  NETLOFT_REYNOLDS_IN_MESHES = 2, /* |flow| D/(viscosity (1 - solidity)), for the flow through the meshes */
  NETLOFT_SOLIDITY = 3,
  NETLOFT_ATTACK = 4 /* angle between the flow and the twine or the netting, 0 to pi/2 [rad] */
};

/* A range in which a law was measured. The host reports for which fraction of a gear the quantity is outside
 * the range. The law must return a force outside the range, too. */
typedef struct netloft_validity {
  uint32_t size;
  uint32_t quantity;
  double lo, hi;
  const char* source;         /* who measured it: "Loland 1991" */
  const char *where, *unless; /* names of parameters, or null: the range applies only if `where` is given, and
                                 not if `unless` is given. A parameter is given unless it is a real of value
                                 zero, an empty table or the first word of a choice */
} netloft_validity;

/* A law, such as "hydro/morison". */
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

/* A plugin offers this struct. */
typedef struct netloft_laws {
  uint32_t size;
  uint32_t count;
  const netloft_law* rows;
} netloft_laws;

/* A key of an element under which the user names a law. */
typedef struct netloft_law_slot {
  uint32_t size;
  uint32_t accepts;       /* sum of netloft_law_kind */
  const char *name, *doc; /* "drag" */
  const char* fallback;   /* "hydro/morison" */
} netloft_law_slot;

/* An element offers this struct. */
typedef struct netloft_law_slots {
  uint32_t size;
  uint32_t count;
  const netloft_law_slot* rows;
} netloft_law_slots;

/* The law in a slot, resolved by the host. All elements of a family share it. */
typedef struct netloft_bound_law {
  uint32_t kind;
  uint32_t reserved;
  const void* parameters;
  int (*evaluate)(const void* parameters, const netloft_law_tile* flow);
} netloft_bound_law;

/* `create` receives this struct. */
typedef struct netloft_bound_laws {
  uint32_t size;
  uint32_t count;
  const netloft_bound_law* laws; /* [slot] valid until the elements are destroyed */
} netloft_bound_laws;

#ifdef __cplusplus
}
#endif
#endif
