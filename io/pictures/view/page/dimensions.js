// SPDX-License-Identifier: BSD-3-Clause
// Dimension lines over the picture, from the list of dimensions in the result.

const LEAST_DIMENSION = 24;  // pixels: a shorter line is nearly parallel to the line of sight
// places of a label along its line; the first free place is used
const PLACES_OF_WORDS = [0.5, 0.22, 0.62, 0.78, 0.35, 0.9, 0.1];

/** A line with an arrow at either end, its words where they hide none of those in the boxes `taken`. */
function drawDimension(svg, a, b, words, taken, width) {
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  if (length < LEAST_DIMENSION) return;
  const u = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
  const head = (tip, sign, side) => `M${tip[0]} ${tip[1]}l${sign * 9 * (u[0] - side * u[1])} ${sign * 9 * (u[1] + side * u[0])}`;
  const heads = [[a, 1], [b, -1]].flatMap(([tip, sign]) => [0.32, -0.32].map((side) => head(tip, sign, side))).join('');
  svg.append(svgElement('path', {d: `M${a[0]} ${a[1]}L${b[0]} ${b[1]}${heads}`, class: 'dimension'}));
  const label = svgElement('text', {class: 'dimension'}, words);
  svg.append(label);
  for (const along of PLACES_OF_WORDS) {
    const [x, y] = [a[0] + along * (b[0] - a[0]) + 7, a[1] + along * (b[1] - a[1]) - 7];
    label.setAttribute('x', Math.max(0, Math.min(x, width - label.getBBox().width)));
    label.setAttribute('y', y);
    const box = label.getBBox();
    if (!taken.some((other) => overlap(box, other))) break;
  }
  taken.push(label.getBBox());
}

function overlap(a, b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

/** An end of a dimension, from the origin: a node, or (null) the bed below the other end. */
function dimensionEnd(model, end, other) {
  if (end) return model.at(end.node, end.mirrored);
  const {ground, origin} = model.result;
  return [other[0], other[1], bedHeight(ground, other[0] + origin[0], other[1] + origin[1]) - origin[2]];
}

function drawDimensions(svg, model, camera) {
  const taken = [];
  for (const {name, from, to} of model.result.dimensions) {
    const a = dimensionEnd(model, from), b = dimensionEnd(model, to, a);
    const [p, q] = [a, b].map((end) => camera.project(end));
    // an end of the line would be outside the picture
    if (![p, q].every(([x, y]) => x >= 0 && x <= camera.width && y >= 0 && y <= camera.height)) continue;
    drawDimension(svg, p, q, `${name} ${formatNumber(Math.hypot(...a.map((v, d) => v - b[d])), 3)} m`, taken, camera.width);
  }
}

/** Forces of the holds as arrows at the nodes that are held, the largest `longest` pixels long. */
function drawHolds(svg, model, camera, longest) {
  const {reaction} = model.state, {nPoints, half} = model.result;
  if (!reaction) return;
  const force = (n) => [reaction[3 * n], reaction[3 * n + 1], reaction[3 * n + 2]], size = (n) => Math.hypot(...force(n));
  // Nodes that only the plane of symmetry holds do not count as held.
  const held = Array.from({length: nPoints}, (_, n) => n).filter((n) => (half ? Math.hypot(force(n)[0], force(n)[2]) : size(n)) > 0);
  const most = Math.max(...held.map(size));
  for (const n of held.filter((one) => size(one) > most / 50))
    for (const mirrored of half ? [false, true] : [false]) {
      const f = force(n), from = model.at(n, mirrored), scale = longest / camera.pixelsPerMetre / most;
      const to = from.map((v, d) => v + scale * f[d] * (mirrored && d === 1 ? -1 : 1));
      const [a, b] = [from, to].map((p) => camera.project(p));
      drawArrow(svg, a, b);
      if (size(n) > most / 2 && held.length <= 8 && b[0] >= 0) svg.append(svgElement('text', {x: b[0] + 6, y: b[1] - 4, class: 'hold'}, `${formatNumber(size(n) / 1000, 3)} kN`));
    }
}

/** Of a solve that did not end: the node that is farthest from equilibrium. */
function drawWorst(svg, model, camera) {
  const {residual} = model.state;
  if (!residual) return;
  const size = (n) => Math.hypot(residual[3 * n], residual[3 * n + 1], residual[3 * n + 2]);
  let worst = 0;
  for (let n = 1; n < model.result.nPoints; ++n) if (size(n) > size(worst)) worst = n;
  if (!(size(worst) > 0)) return;
  const [x, y] = camera.project(model.at(worst));
  svg.append(svgElement('circle', {cx: x, cy: y, r: 9, class: 'selected'}));
  svg.append(svgElement('text', {x: x + 13, y: y - 8, class: 'dimension'}, `largest force out of balance, ${shortText(size(worst), 'N')}`));
}

function drawArrow(svg, a, b) {
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  if (length < 3) return;
  const u = [(b[0] - a[0]) / length, (b[1] - a[1]) / length], head = (side) => `M${b[0]} ${b[1]}l${-9 * (u[0] - side * u[1])} ${-9 * (u[1] + side * u[0])}`;
  svg.append(svgElement('path', {d: `M${a[0]} ${a[1]}L${b[0]} ${b[1]}${head(0.4)}${head(-0.4)}`, class: 'hold'}));
}
