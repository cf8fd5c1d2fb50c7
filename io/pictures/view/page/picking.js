// SPDX-License-Identifier: BSD-3-Clause
// Finds the element under a point of the screen or of the plan.

/** Weights of the corners a, b, c of a triangle at p; null: p lies outside. */
function barycentric(p, a, b, c) {
  const d = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
  if (Math.abs(d) < 1e-12) return null;
  const l1 = ((p[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (p[1] - a[1])) / d;
  const l2 = ((b[0] - a[0]) * (p[1] - a[1]) - (p[0] - a[0]) * (b[1] - a[1])) / d;
  return l1 >= -1e-6 && l2 >= -1e-6 && l1 + l2 <= 1 + 1e-6 ? [1 - l1 - l2, l1, l2] : null;
}

/** Distance of p from the segment a b on the screen, and where along it. */
function nearSegment(p, a, b) {
  const dx = b[0] - a[0], dy = b[1] - a[1], length = dx * dx + dy * dy;
  const s = length > 0 ? Math.min(Math.max(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / length, 0), 1) : 0;
  return [Math.hypot(p[0] - a[0] - s * dx, p[1] - a[1] - s * dy), s];
}

const REACH = 7;    // distance from the pointer within which a rope or a float is found [pixels]
const AHEAD = 0.3;  // metres: ropes and floats are drawn larger than they are, and are selected even if
                    // netting is this far ahead of them

/** Where elements of each kind are hit by a point p of the screen; `at` has the nodes there: weights and depth, or null. */
const HITS = {
  netting(p, [a, b, c]) {
    if (Math.max(a[0], b[0], c[0]) < p[0] || Math.min(a[0], b[0], c[0]) > p[0] || Math.max(a[1], b[1], c[1]) < p[1] || Math.min(a[1], b[1], c[1]) > p[1]) return null;
    const weights = barycentric(p, a, b, c);
    return weights && {weights, depth: weights[0] * a[2] + weights[1] * b[2] + weights[2] * c[2]};
  },
  rope(p, [a, b]) {
    const [distance, s] = nearSegment(p, a, b);
    return distance < REACH ? {weights: [1 - s, s], depth: a[2] + s * (b[2] - a[2]) + AHEAD - 0.01 * distance} : null;
  },
  point(p, [a]) {
    return Math.hypot(a[0] - p[0], a[1] - p[1]) < REACH ? {weights: [1], depth: a[2] + 2 * AHEAD} : null;
  },
};

/** The element nearest to the eye under (x, y) pixels: {kind, index, part, cell, nodes, weights, mirrored}; null: none. */
function pick(model, camera, x, y, isCut) {
  const {result} = model, screen = new Array(result.nPoints);
  let best = null;
  for (const mirrored of result.half ? [false, true] : [false]) {
    for (let node = 0; node < result.nPoints; ++node) screen[node] = camera.project(model.at(node, mirrored));
    for (const c of CELLS)
      for (let index = 0; index < result[c.parts].length; ++index) {
        const part = result[c.parts][index];
        if (!model.shown[part]) continue;
        const nodes = nodesOfElement(result, c.kind, index), hit = HITS[c.kind]([x, y], nodes.map((n) => screen[n]));
        if (!hit || (best && hit.depth <= best.depth)) continue;
        const place = [0, 1, 2].map((d) => nodes.reduce((sum, n, i) => sum + hit.weights[i] * model.at(n, mirrored)[d], 0));
        if (!isCut(place)) best = {kind: c.kind, index, part, cell: result[c.cells][index], nodes, weights: hit.weights, mirrored, depth: hit.depth};
      }
    best = pickPlate(model, camera, [x, y], mirrored, isCut, best);
  }
  return best;
}

/** The plate of a rigid body, if it is nearer than what was found: the single node at its origin. */
function pickPlate(model, camera, p, mirrored, isCut, best) {
  const {result, solids} = model;
  for (let t = 0; t < result.plateDot.length; ++t) {
    const index = result.plateDot[t], part = result.dotPart[index];
    if (!model.shown[part]) continue;
    const corners = solids.at(solids.corners, t, mirrored), hit = HITS.netting(p, corners.map((c) => camera.project(c)));
    if (!hit || (best && hit.depth <= best.depth) || isCut(corners[0])) continue;
    best = {kind: 'point', index, part, cell: result.dotCell[index], nodes: [result.dot[index]], weights: [1], mirrored, depth: hit.depth};
  }
  return best;
}
