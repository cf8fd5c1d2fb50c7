// SPDX-License-Identifier: BSD-3-Clause
// What lies under a point of the screen, or of the plan.

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

const REACH = 7;  // pixels within which a rope or a float is hit

/** The cell nearest to the eye under (x, y) pixels: {kind, index, part, cell, weights, mirrored}; null: none. */
function pick(model, camera, x, y, isCut) {
  const {result, points} = model;
  const screen = new Float64Array(points.length);
  let best = null;
  const consider = (hit, depth) => { if (!best || depth > best.depth) best = {...hit, depth}; };
  for (const sign of result.half ? [1, -1] : [1]) {
    const world = (node) => [points[3 * node], sign > 0 ? points[3 * node + 1] : -2 * result.origin[1] - points[3 * node + 1], points[3 * node + 2]];
    for (let node = 0; node < result.nPoints; ++node) screen.set(camera.project(world(node)), 3 * node);
    const at = (node) => [screen[3 * node], screen[3 * node + 1], screen[3 * node + 2]];
    const seen = (part, nodes, weights) => model.shown[part] && !isCut([0, 1, 2].map((k) => nodes.reduce((sum, node, i) => sum + weights[i] * world(node)[k], 0)));
    pickNetting(result, at, seen, [x, y], (hit, depth) => consider({...hit, mirrored: sign < 0}, depth));
    pickBars(result, at, seen, [x, y], (hit, depth) => consider({...hit, mirrored: sign < 0}, depth));
    pickDots(result, at, seen, [x, y], (hit, depth) => consider({...hit, mirrored: sign < 0}, depth));
  }
  return best;
}

function pickNetting(result, at, seen, p, consider) {
  for (let t = 0; t < result.triPart.length; ++t) {
    const nodes = [result.tri[3 * t], result.tri[3 * t + 1], result.tri[3 * t + 2]], [a, b, c] = nodes.map(at);
    if (Math.max(a[0], b[0], c[0]) < p[0] || Math.min(a[0], b[0], c[0]) > p[0] || Math.max(a[1], b[1], c[1]) < p[1] || Math.min(a[1], b[1], c[1]) > p[1]) continue;
    const weights = barycentric(p, a, b, c);
    if (weights && seen(result.triPart[t], nodes, weights))
      consider({kind: 'netting', index: t, part: result.triPart[t], cell: result.triCell[t], nodes, weights}, weights[0] * a[2] + weights[1] * b[2] + weights[2] * c[2]);
  }
}

/** Ropes and floats are drawn wider than they are: within reach they win over netting that is not far ahead of them. */
const AHEAD = 0.3;  // metres

function pickBars(result, at, seen, p, consider) {
  for (let i = 0; i < result.barPart.length; ++i) {
    const nodes = [result.bar[2 * i], result.bar[2 * i + 1]], [a, b] = nodes.map(at);
    const [distance, s] = nearSegment(p, a, b);
    if (distance < REACH && seen(result.barPart[i], nodes, [1 - s, s]))
      consider({kind: 'bar', index: i, part: result.barPart[i], cell: result.barCell[i], nodes, weights: [1 - s, s]}, a[2] + s * (b[2] - a[2]) + AHEAD - 0.01 * distance);
  }
}

function pickDots(result, at, seen, p, consider) {
  for (let i = 0; i < result.dotPart.length; ++i) {
    const nodes = [result.dot[i]], a = at(nodes[0]);
    if (Math.hypot(a[0] - p[0], a[1] - p[1]) < REACH && seen(result.dotPart[i], nodes, [1]))
      consider({kind: 'dot', index: i, part: result.dotPart[i], cell: result.dotCell[i], nodes, weights: [1]}, a[2] + 2 * AHEAD);
  }
}
