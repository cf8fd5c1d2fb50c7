/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The boundary between Netloft and a plugin: plain data and C functions, nothing else.
 *
 * A plugin is a shared object that exports one symbol, netloft_plugin_v1, which returns a description of its
 * contents. No C++ type, exception or allocation crosses the boundary. No function of a plugin may change the
 * rounding mode or end the program, and a plugin links to no library of Netloft. Most authors use
 * netloft/element.hpp.
 *
 * This header is the core, which is sufficient for an element such as a rope or a float. Everything else is
 * an extension with its own header in netloft/ext/ and an identifier such as "netloft.waves/1". Hosts and
 * plugins ignore unknown identifiers: `extension` returns null for them, and their entries in
 * netloft_tile.inputs are null.
 *
 * Versions. A host accepts plugins of its own major version whose minor version is not newer; the version
 * changes only if this header changes. Every struct begins with its size. Fields are only ever appended, here
 * and in extensions. If a struct is too short for a field, a host takes the field as zero. A plugin checks
 * the size of an extension's struct before it reads an appended field. Any other change of an extension
 * changes the number in its identifier. The stride of an array of structs is the size of its first entry.
 *
 * Units are SI. In the world frame, z points up and is zero at the water surface.
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

#define NETLOFT_ABI_MAJOR 2
#define NETLOFT_ABI_MINOR 0
#define NETLOFT_LANES 64 /* elements in a tile */

/* Status of a call. OUTSIDE_DOMAIN: forces are not defined at this state, shorten the step. ERROR: stop. */
enum { NETLOFT_OK = 0, NETLOFT_OUTSIDE_DOMAIN = 1, NETLOFT_ERROR = -1 };

/* ---------------------------------------------------------------- parameters */

enum netloft_kind {
  NETLOFT_REAL = 0,    /* double */
  NETLOFT_INTEGER = 1, /* int64_t */
  NETLOFT_BOOLEAN = 2, /* one byte, 0 or 1 (bool) */
  NETLOFT_CHOICE = 3,  /* int64_t: index in `choices` */
  NETLOFT_TEXT = 4,    /* const char *, owned by the host */
  NETLOFT_TABLE = 5    /* netloft_table, owned by the host */
};

/* A sampled curve: rows with ascending first column, `columns` numbers each, row by row. With two arguments
 * (netloft_parameter.arguments), the rows are a grid: they ascend by the first column, and among rows with
 * the same first value by the second column. Every first value has the same second values. */
typedef struct netloft_table {
  const double* values;
  uint32_t rows, columns;
} netloft_table;

/* Roles of a parameter. A host uses them to solve easier problems before a difficult one. */
enum {
  NETLOFT_REQUIRED = 1,
  NETLOFT_STIFFNESS = 2,   /* elastic forces are proportional to it; a host may start with less */
  NETLOFT_COMPRESSION = 4, /* stiffness of slack members; if it is zero, the elastic energy is convex */
  NETLOFT_DAMPING = 8      /* tension per strain rate, for the parts that NETLOFT_STIFFNESS describes */
};

/* One value that a user may set. Its name may contain dots: "twine.EA" is EA in the table `twine`. */
typedef struct netloft_parameter {
  uint32_t size;
  uint32_t kind;
  const char* name;
  const char* unit; /* SI; "1" for a pure number; "solver" or "strategy" for a text that names one */
  const char* doc;  /* half a sentence: "axial stiffness of one twine" */
  double fallback;  /* default value; with `fallback_of`, a factor by which that parameter is multiplied */
  double lo, hi;    /* allowed range, both ends included */
  uint32_t flags;   /* NETLOFT_REQUIRED, NETLOFT_STIFFNESS and the other roles above */
  uint32_t offset;  /* position of the value in the parameter struct [bytes] */
  const char* fallback_of;         /* name of an earlier real, or null */
  const char* const* choices;      /* words, null-terminated: a CHOICE is one, a TEXT several joined by + */
  const char* fallback_text;       /* default of a NETLOFT_TEXT */
  const char* const* columns;      /* names of a table's columns, null-terminated */
  const char* const* column_units; /* units of the columns, in the same number */
  uint32_t arguments; /* number of arguments, which are the first columns: 0 or 1 for a curve, 2 for a grid */
  uint32_t reserved;
} netloft_parameter;

/* ---------------------------------------------------------------- elements */

/* The nodes that an element connects; the low byte is their number. More: ext/pairs.h, ext/bodies.h. */
enum netloft_stencil {
  NETLOFT_NODE = 1,
  NETLOFT_BAR = 2,
  NETLOFT_TRIANGLE = 3 /* counter-clockwise, seen from outside */
};

/* A number (or `width` numbers) of every element, such as its rest length or coordinates of its corners. */
typedef struct netloft_datum {
  uint32_t size;
  uint32_t width;
  const char *name, *unit, *doc;
} netloft_datum;

/* Traits of a term. Bits that have no name here belong to extensions. */
enum {
  NETLOFT_CONSERVATIVE = 1 << 0,   /* residual is the gradient of an energy, which the term computes */
  NETLOFT_SYMMETRIC = 1 << 1,      /* tangent is symmetric and packed as its lower triangle */
  NETLOFT_CONSTANT = 1 << 2,       /* force does not depend on the state: no tangent */
  NETLOFT_READS_VELOCITY = 1 << 3, /* reads tile.v, if it is not null */
  NETLOFT_READS_ACCELERATION = 1 << 4,
  NETLOFT_READS_CURRENT = 1 << 5, /* reads tile.current and tile.current_dz, if not null */
  NETLOFT_NEEDS_GRAVITY = 1 << 6, /* zero without gravity */
  NETLOFT_NEEDS_FLOW = 1 << 7,    /* zero without a current or motion */
  NETLOFT_NEEDS_MOTION = 1 << 8,  /* zero in a static analysis */
  NETLOFT_FROM_OUTSIDE = 1 << 11, /* acts against something that is not a node (seabed, wall, pressure):
                                     forces may have a resultant and may depend on the position */
  NETLOFT_READS_TIME = 1 << 13,   /* force and energy may change with tile.time, even if nothing moves */
  NETLOFT_IS_WEIGHT = 1 << 15,    /* reports count it as weight in water */
  NETLOFT_IS_DRAG = 1 << 16       /* reports count it as force of the flowing water */
};

/* Results that a call of a term must add. */
enum { NETLOFT_WANT_ENERGY = 1, NETLOFT_WANT_FORCE = 2, NETLOFT_WANT_TANGENT = 4 };

/* Up to 64 elements of one type. Arrays are [degree of freedom][64], lanes 0 ... count-1 in use; the degree
 * of freedom is 3*node + axis. Inputs that the traits of the term do not request, or that the scene does not
 * have, are null. A term ADDS to its outputs, in lanes below `count` only; outputs that are not requested are
 * null. */
typedef struct netloft_tile {
  uint32_t size;
  uint32_t want;
  uint32_t first; /* index of the element in lane 0; a multiple of 64 */
  uint32_t count;
  double time;              /* [s] */
  double cu, cv, ca;        /* factors of the tangent, see the top of this header */
  double water_density;     /* [kg/m3] */
  double water_viscosity;   /* kinematic [m2/s] */
  double gravity;           /* [m/s2] */
  const double* x;          /* positions [m] */
  const double* x_low;      /* digits of the positions that x rounds off: x + x_low gives exact differences
                               [m]; usually null: not known. A term may ignore it */
  const double *v, *a;      /* velocities, accelerations; null at rest */
  const double* current;    /* velocity of the water at the nodes [m/s] */
  const double* current_dz; /* derivative of `current` with respect to z [1/s] */
  double* energy;           /* [64] [J] */
  double* force;            /* [dof][64] residual [N] */
  double* tangent; /* packed lower triangle, entry r(r+1)/2+c, if symmetric; else r*dofs+c; [entry][64] */
  char* message;   /* memory for a sentence if the status is not OK */
  uint32_t message_size;
  uint32_t lane_at_fault;    /* set by the term with a status that is not OK */
  const void* const* inputs; /* data of extensions in the order of netloft_element.inputs; null where the host
                                or the scene has none */
} netloft_tile;

typedef struct netloft_term {
  uint32_t size;
  uint32_t traits;
  const char *name, *doc;
  const char* needs; /* names of real parameters, separated by spaces: the term acts only if one of them
                        is not zero; null: always */
  int (*evaluate)(const void* self, netloft_tile* tile);
} netloft_term;

/* The meaning of an output, for reports that compare parts of different types. */
enum netloft_output_role {
  NETLOFT_OUTPUT_PLAIN = 0,
  NETLOFT_OUTPUT_TENSION = 1, /* tension in a rope or in one twine [N], negative in compression */
  NETLOFT_OUTPUT_DOUBT = 2    /* not zero if the element is used beyond its known range of validity, which
                                 `doc` describes; reports warn of it */
};

/* A number reported for each element, with its physical sign: tension is positive when the rope pulls. */
typedef struct netloft_output {
  uint32_t size;
  uint32_t role; /* netloft_output_role */
  const char *name, *unit, *doc;
} netloft_output;

/* The argument of `create`: all elements of one type in a scene, at once. */
typedef struct netloft_create {
  uint32_t size;
  uint32_t count; /* elements */
  uint32_t part_count;
  uint32_t at_fault;             /* set by `create`: the index of the element that it refuses */
  const void* const* parameters; /* [part] filled parameter struct, valid until `destroy` */
  const uint32_t* part;          /* [element] which part it belongs to */
  const double* const* data;     /* [datum] -> [element][width] */
  char* message;
  uint32_t message_size;
  uint32_t reserved;
  void* host;
  const void* (*extension)(void* host, const char* id); /* the host's data for an extension, or null */
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
  const char* const* inputs; /* extensions whose data its tiles need, null-terminated; or null */
  const void* (*extension)(const char* id); /* what the element offers for an extension, or null */
} netloft_element;

/* ---------------------------------------------------------------- the plugin */

enum { NETLOFT_FAST_MATH = 1 };

/* The first five fields are the same in every version of the interface. */
typedef struct netloft_plugin {
  uint32_t size;
  uint32_t abi_major, abi_minor;
  uint32_t flags;   /* NETLOFT_FAST_MATH if compiled with -ffast-math, which the host refuses */
  const char* name; /* the name of its file without ending: "rope" in rope.so */
  const char *version, *doc, *compiler;
  const netloft_element* elements;
  uint32_t element_count, reserved;
  const char* const* required; /* extensions that a host must support, null-terminated; or null */
  const void* (*extension)(const char* id); /* what the plugin offers for an extension, or null */
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
