/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A cord in plain C that uses only plugin.h, the core of the plugin interface. Per node:
 *   E = k/2 (l - l0)^2,   G = w z/2,   F = c |W| W/2,   W = u - v
 * k [N/m] stiffness, w [N] weight in water, c [N s2/m2] drag of the whole cord; u, v [m/s] velocities of the
 * water and of the node. */
#include <netloft/plugin.h>

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

enum { kDofs = 6 };

typedef struct Parameters {
  double k, w, c;
} Parameters;

/* Arrays by element. */
typedef struct Cords {
  const Parameters** parameters;
  double* rest_length;
} Cords;

static size_t at(int row, uint32_t lane) { return (size_t)row * NETLOFT_LANES + lane; }

static int stretch(const void* self, netloft_tile* t) {
  const Cords* cords = self;
  for (uint32_t i = 0; i < t->count; ++i) {
    const double k = cords->parameters[t->first + i]->k, l0 = cords->rest_length[t->first + i];
    double d[3], l = 0;
    for (int a = 0; a < 3; ++a) d[a] = t->x[at(3 + a, i)] - t->x[at(a, i)], l += d[a] * d[a];
    l = sqrt(l);
    t->lane_at_fault = i;
    if (l < 1e-6 * l0) return NETLOFT_OUTSIDE_DOMAIN;
    if (t->energy) t->energy[i] += 0.5 * k * (l - l0) * (l - l0);
    for (int a = 0; t->force && a < kDofs; ++a)
      t->force[at(a, i)] += (a < 3 ? -1 : 1) * k * (l - l0) * d[a % 3] / l;
    for (int r = 0, entry = 0; t->tangent && r < kDofs; ++r)
      for (int c = 0; c <= r; ++c, ++entry) {
        const double along = d[r % 3] * d[c % 3] / (l * l), across = (r % 3 == c % 3) - along;
        const double sign = (r < 3) == (c < 3) ? 1 : -1;
        t->tangent[at(entry, i)] += sign * t->cu * k * (along + (1 - l0 / l) * across);
      }
  }
  return NETLOFT_OK;
}

static int sink(const void* self, netloft_tile* t) {
  const Cords* cords = self;
  for (uint32_t i = 0; i < t->count; ++i)
    for (int node = 0; node < 2; ++node) {
      const double half = 0.5 * cords->parameters[t->first + i]->w;
      if (t->energy) t->energy[i] += half * t->x[at(3 * node + 2, i)];
      if (t->force) t->force[at(3 * node + 2, i)] += half;
    }
  return NETLOFT_OK;
}

static int drift(const void* self, netloft_tile* t) {
  const Cords* cords = self;
  for (uint32_t i = 0; i < t->count; ++i)
    for (int node = 0; node < 2; ++node) {
      const double half = 0.5 * cords->parameters[t->first + i]->c;
      double W[3], speed = 1e-300;
      for (int a = 0; a < 3; ++a) {
        const size_t here = at(3 * node + a, i);
        W[a] = (t->current ? t->current[here] : 0) - (t->v ? t->v[here] : 0);
        speed += W[a] * W[a];
      }
      speed = sqrt(speed);
      for (int r = 0; r < 3; ++r) {
        if (t->force) t->force[at(3 * node + r, i)] -= half * speed * W[r];
        for (int c = 0; t->tangent && c < 3; ++c) {
          const double slope = half * (speed * (r == c) + W[r] * W[c] / speed); /* dF[r]/dW[c] */
          const double shear = t->current_dz ? t->current_dz[at(3 * node + c, i)] : 0;
          t->tangent[at((3 * node + r) * kDofs + 3 * node + c, i)] += t->cv * slope;
          t->tangent[at((3 * node + r) * kDofs + 3 * node + 2, i)] -= t->cu * slope * shear;
        }
      }
    }
  return NETLOFT_OK;
}

static void destroy(void* self) {
  Cords* cords = self;
  if (!cords) return;
  free(cords->parameters);
  free(cords->rest_length);
  free(cords);
}

static int create(netloft_create* in, void** self) {
  Cords* cords = calloc(1, sizeof *cords);
  if (!cords) return NETLOFT_ERROR;
  cords->parameters = calloc(in->count, sizeof *cords->parameters);
  cords->rest_length = calloc(in->count, sizeof *cords->rest_length);
  if (!cords->parameters || !cords->rest_length) return destroy(cords), NETLOFT_ERROR;
  for (uint32_t e = 0; e < in->count; ++e) {
    cords->parameters[e] = in->parameters[in->part[e]];
    cords->rest_length[e] = in->data[0][e];
  }
  *self = cords;
  return NETLOFT_OK;
}

#define PARAMETER(name, unit, doc)                                                          \
  {                                                                                         \
    sizeof(netloft_parameter), NETLOFT_REAL, #name, unit, doc, 0, 0, 1e4, NETLOFT_REQUIRED, \
        offsetof(Parameters, name), NULL, NULL, NULL, NULL, NULL, 0, 0                      \
  }

static const netloft_parameter kParameters[] = {
    PARAMETER(k, "N/m", "stiffness"), PARAMETER(w, "N", "weight in water"), PARAMETER(c, "N s2/m2", "drag")};
static const netloft_datum kData[] = {{sizeof(netloft_datum), 1, "rest_length", "m", "unstretched length"}};
static const netloft_term kTerms[] = {
    {sizeof(netloft_term), NETLOFT_CONSERVATIVE | NETLOFT_SYMMETRIC, "stretch", "elastic pull", "k", stretch},
    {sizeof(netloft_term),
     NETLOFT_CONSERVATIVE | NETLOFT_SYMMETRIC | NETLOFT_CONSTANT | NETLOFT_FROM_OUTSIDE |
         NETLOFT_NEEDS_GRAVITY,
     "weight", "weight in water", "w", sink},
    {sizeof(netloft_term),
     NETLOFT_READS_VELOCITY | NETLOFT_READS_CURRENT | NETLOFT_NEEDS_FLOW | NETLOFT_FROM_OUTSIDE |
         NETLOFT_IS_DRAG,
     "drag", "force of the water", "c", drift}};
static const netloft_element kElements[] = {{sizeof(netloft_element), NETLOFT_BAR, "cord",
                                             "A cord in plain C", sizeof(Parameters), 3, kParameters, kData,
                                             1, 3, kTerms, NULL, 0, 0, create, destroy, NULL, NULL, NULL}};
static const netloft_plugin kPlugin = {sizeof(netloft_plugin),
                                       NETLOFT_ABI_MAJOR,
                                       NETLOFT_ABI_MINOR,
                                       NETLOFT_BUILD_FLAGS,
                                       "cord",
                                       "1.0",
                                       "Cords in plain C",
                                       "",
                                       kElements,
                                       1,
                                       0,
                                       NULL,
                                       NULL};

NETLOFT_EXPORT const netloft_plugin* netloft_plugin_v1(void) { return &kPlugin; }
