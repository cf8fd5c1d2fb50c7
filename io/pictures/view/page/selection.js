// SPDX-License-Identifier: BSD-3-Clause
// The selection: its description, its marks, and its distance from the previous selection.

/** The place of a hit, from the origin of its result [m]. */
function placeOfHit(model, hit) {
  return [0, 1, 2].map((d) => hit.nodes.reduce((sum, n, i) => sum + hit.weights[i] * model.at(n, hit.mirrored)[d], 0));
}

/** The pane in which it was selected. */
const paneOf = (hit) => (hit && hit.pane) || 0;

/** Rows of name and value. */
function describeHit(model, hit) {
  const {result} = model, part = result.parts[hit.part], rows = [['part', part.name], ['type', part.type]];
  if (hit.kind === 'netting' && Number.isFinite(result.triUV[6 * hit.index])) {
    const uv = [0, 1].map((k) => [0, 1, 2].reduce((sum, i) => sum + hit.weights[i] * result.triUV[6 * hit.index + 2 * i + k], 0));
    rows.push(['on the plan', `${formatNumber(uv[0], 3)} meshes across, ${formatNumber(uv[1], 3)} deep`]);
  }
  rows.push(['position', placeOfHit(model, hit).map((v, d) => formatNumber(v + result.origin[d], 5)).join(', ') + ' m']);
  const node = hit.nodes[hit.weights.indexOf(Math.max(...hit.weights))];
  rows.push(['nearest node', `${result.parts[result.nodePart[node]].name} ${result.nodeNumber[node]}` + (hit.mirrored ? ', mirrored' : '')]);
  if (result.nodeError !== null) rows.push(['position, error', `± ${formatNumber(result.nodeError, 2)} m of the solver`]);
  return [...rows, ...figuresOfBody(model, part.name), ...valuesOfHit(model, hit), ...forcesOfNode(model, node),
    ['errors', 'not known for single elements']];
}

/** How a rigid body stands, and what its element says of itself. */
function figuresOfBody(model, name) {
  const {figures, series} = model.result, begin = `bodies/${name}/`;
  return figures.filter((f) => f.name.startsWith(begin)).map((f) => {
    const moving = series.find((s) => s.name === `gear/${f.name}`), value = moving ? moving.values[model.stateIndex] : f.value;
    const text = f.unit === 'rad' ? `${formatNumber(value * 180 / Math.PI)}°` : withUnit(value, f.unit);
    return [words(f.name.slice(begin.length)), moving || f.error === null ? text : `${text} ± ${formatNumber(f.error, 1)}${f.unit === 'rad' ? ' rad' : ''}`];
  });
}

function valuesOfHit(model, hit) {
  const kind = CELLS.findIndex((c) => c.kind === hit.kind);
  return model.result.fields.map((field, i) => [LABELS[field.name] || words(field.name), model.state.fields[i][hit.cell], field.units[kind]])
    .filter(([, value]) => Number.isFinite(value)).map(([name, value, unit]) => [name, withUnit(value, unit)]);
}

function forcesOfNode(model, node) {
  const rows = [];
  for (const [name, text] of [['reaction', 'node held with'], ['residual', 'node out of balance by']]) {
    if (!model.state[name]) continue;
    const force = [0, 1, 2].map((d) => model.state[name][3 * node + d]), size = Math.hypot(...force);
    if (size > 0) rows.push([text, `${formatNumber(size)} N (${force.map((f) => formatNumber(f, 3)).join(', ')})`]);
  }
  return rows;
}

const NOTHING_SELECTED = $('selection').textContent;

class Selection {
  constructor(viewer, box) {
    Object.assign(this, {viewer, box, hit: null, before: null});
  }

  /** The gear to which the selection belongs. */
  get model() { return paneOf(this.hit) ? this.viewer.models[paneOf(this.hit)] : this.viewer.model; }

  /** `measures`: the distance from what was selected before is wanted. */
  set(hit, measures = false) {
    this.before = hit && measures && paneOf(hit) === paneOf(this.hit) ? this.hit : null;
    this.hit = hit;
    this.describe();
    this.viewer.draw();
    this.viewer.canvas.dispatchEvent(new CustomEvent('selected', {detail: hit && this.model.result.parts[hit.part].name}));
  }

  /** The next element that is shown, whatever its kind, for those who have no pointer. */
  step(by) {
    const {result, shown} = this.viewer.model, n = CELLS.reduce((sum, c) => sum + result[c.parts].length, 0);
    let place = this.hit ? placeOfElement(result, this.hit) : by > 0 ? -1 : 0;
    for (let tried = 0; tried < n; ++tried) {
      place = (place + by + n) % n;
      const {kind, index} = elementAt(result, place);
      if (shown[result[cellsOf(kind).parts][index]]) { this.take(kind, index); return; }
    }
  }

  /** The first element of the next part that is shown, in the order of the list of parts. */
  stepPart(by) {
    const {result, shown} = this.viewer.model, n = result.parts.length;
    let part = this.hit ? this.hit.part : by > 0 ? -1 : 0;
    for (let tried = 0; tried < n; ++tried) {
      part = (part + by + n) % n;
      const c = shown[part] && CELLS.find((one) => result[one.parts].includes(part));
      if (c) { this.take(c.kind, result[c.parts].indexOf(part)); return; }
    }
  }

  take(kind, index) {
    const {result} = this.viewer.model, c = cellsOf(kind);
    this.set({kind, index, part: result[c.parts][index], cell: result[c.cells][index], nodes: nodesOfElement(result, kind, index), weights: Array(c.of).fill(1 / c.of), mirrored: false});
  }

  distance() {
    const [a, b] = [this.before, this.hit].map((hit) => placeOfHit(this.model, hit));
    return Math.hypot(...a.map((v, d) => v - b[d]));
  }

  describe() {
    this.box.replaceChildren();
    if (!this.hit) { this.box.textContent = NOTHING_SELECTED; return; }
    const list = element('dl'), rows = describeHit(this.model, this.hit);
    if (this.before) rows.unshift(['distance', `${formatNumber(this.distance())} m from the place before`]);
    for (const [name, value] of rows) list.append(element('dt', {}, name), element('dd', {}, value));
    this.box.append(list);
  }

  drawMarks(svg, camera) {
    if (!this.hit) return;
    const {model} = this, corners = this.hit.nodes.map((n) => camera.project(model.at(n, this.hit.mirrored)));
    svg.append(svgElement('path', {d: corners.map((c, i) => `${i ? 'L' : 'M'}${c[0]} ${c[1]}`).join('') + 'Z', class: 'selected'}));
    const at = camera.project(placeOfHit(model, this.hit));
    svg.append(svgElement('circle', {cx: at[0], cy: at[1], r: 7, class: 'selected'}));
    if (this.before) drawDimension(svg, camera.project(placeOfHit(model, this.before)), at, `${formatNumber(this.distance())} m`, [], camera.width);
  }
}
