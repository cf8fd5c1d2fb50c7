// SPDX-License-Identifier: BSD-3-Clause
// The page as a whole: one picture, what it shows, and the controls beside it.

const $ = (id) => document.getElementById(id);
const SECTIONS = {x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1]};
const BY_PART = 'part', BY_MOVE = 'distance between the two results';

class Viewer {
  constructor(results) {
    this.results = results;
    this.canvas = $('canvas');
    this.camera = new OrbitCamera();
    this.renderer = new L.WebGLRenderer({canvas: this.canvas, antialias: true, preserveDrawingBuffer: true});
    this.shared = {pixelsPerMetre: {value: 1}, eye: {value: new L.Vector3()}, right: {value: new L.Vector3()}, up: {value: new L.Vector3()},
      stops: {value: STOPS.map((c) => new L.Vector3(...c))}, range: {value: new L.Vector2(0, 1)}, isLog: {value: false},
      section: {value: new L.Vector4(0, 0, 0, 1e30)}, fill: {value: 0.4}};
    this.models = results.map((result) => new GearModel(result, this.shared));
    this.scene = new L.Scene();
    this.scene.add(...this.models.map((m) => m.group));
    this.frame = 0;
    this.isSweep = results.length > 2;
    this.selection = null;
    this.frames = this.isSweep ? results.map((r, i) => ({model: i, state: r.states.length - 1})) : results[0].states.map((_, state) => ({model: 0, state}));
  }

  get model() { return this.models[this.frames[this.frame].model]; }
  get result() { return this.model.result; }
  get second() { return this.results.length === 2 ? this.models[1] : null; }

  async start() {
    await this.showFrame(this.frames.length - 1, true);
    this.makeMarks();
    this.plan = new PlanDrawing($('plan'), this.results[0], (hit) => this.select(hit));
    this.makeControls();
    this.resize();
    this.look('oblique');
    this.setField(this.second ? BY_MOVE : this.fieldChoices()[0].name);
    new ResizeObserver(() => { this.resize(); this.draw(); }).observe($('stage'));
  }

  // ---- what is shown

  async showFrame(index, isFirst = false) {
    const frame = this.frames[index];
    const states = await Promise.all(this.models.map((model, i) => decodeState(model.result,
      i === frame.model ? frame.state : Math.min(frame.state, model.result.states.length - 1))));
    this.frame = index;
    this.models.forEach((model, i) => { model.state = states[i]; model.move(states[i].points); });
    if (isFirst) return;
    this.applyVisibility();
    this.repaint();
    this.describeFrame();
  }

  applyVisibility() {
    const mode = this.second ? $('overlay').value : 'one';
    this.models.forEach((model, i) => {
      model.group.visible = this.isSweep ? i === this.frames[this.frame].model : this.results.length < 2 || mode === 'both' || mode === String(i);
      model.uniforms.usePlain.value = this.second && mode === 'both' && i === 1 ? 1 : 0;
    });
  }

  fieldChoices() {
    const fields = this.result.fields.map((f) => ({...f, label: f.name.replaceAll('_', ' ')}));
    const more = [{name: BY_PART, label: 'part', unit: '1', doc: 'the part of the gear'}];
    if (this.second) more.unshift({name: BY_MOVE, label: BY_MOVE, unit: 'm', doc: 'how far a node moved from the first result to the second'});
    return [...fields, ...more];
  }

  setField(name) {
    this.field = this.fieldChoices().find((f) => f.name === name);
    $('field').value = name;
    $('log').checked = this.field.unit === 'N';
    this.repaint();
  }

  /** Values by cell of a model; null: by part. */
  valuesOf(model) {
    if (this.field.name === BY_PART) return null;
    if (this.field.name === BY_MOVE) return this.moves();
    const at = model.result.fields.findIndex((f) => f.name === this.field.name);
    return at < 0 ? new Float32Array(0) : model.state.fields[at];
  }

  /** How far the middle of each cell of the first result lies from the same place in the second. */
  moves() {
    const [a, b] = this.models, moves = new Float32Array(a.result.nCells).fill(NaN);
    const where = placesIn(b);
    const put = (nodes, cells, of) => cells.forEach((cell, i) => {
      let sum = 0;
      for (let k = 0; k < of; ++k) {
        const node = nodes[of * i + k], other = where(a.result, node);
        sum += other < 0 ? NaN : Math.hypot(...[0, 1, 2].map((d) => a.points[3 * node + d] + a.result.origin[d] - b.points[3 * other + d] - b.result.origin[d]));
      }
      moves[cell] = sum / of;
    });
    put(a.result.tri, a.result.triCell, 3);
    put(a.result.bar, a.result.barCell, 2);
    put(a.result.dot, a.result.dotCell, 1);
    return moves;
  }

  /** The range of a field is that of all states, so that a colour means the same in each. */
  scaleOf(values) {
    if (!values) return null;
    let [lo, hi] = this.field.name === BY_MOVE ? [0, 0] : [Infinity, -Infinity];
    if (this.field.range) {
      for (const result of this.results) {
        const same = result.fields.find((f) => f.name === this.field.name);
        const from = same && same.range && ($('log').checked ? same.low : same.range[0]);
        if (same && same.range) [lo, hi] = [Math.min(lo, from), Math.max(hi, same.range[1])];
      }
    } else for (const v of values) if (Number.isFinite(v)) { lo = Math.min(lo, v); hi = Math.max(hi, v); }
    const scale = lo <= hi ? new Scale(lo, hi, $('log').checked) : new Scale(0, 1, false);
    scale.isCutBelow = Boolean(this.field.range && scale.log && this.field.range[0] < scale.lo);
    return scale;
  }

  repaint() {
    this.models.forEach((model) => { model.values = this.valuesOf(model); model.paint(model.values); });
    this.scale = this.scaleOf(this.model.values);
    this.shared.isLog.value = Boolean(this.scale && this.scale.log);
    this.shared.range.value.set(this.scale ? this.scale.lo : 1, this.scale ? this.scale.hi : 0);
    drawLegend($('legend'), this.field.label, this.scale, this.field.unit);
    $('legend').title = this.field.doc;
    this.draw();
  }

  colourOfCell(cell, part) {
    if (!this.model.values) return cssColour(partColour(part));
    const value = this.models[0].values[cell];
    return Number.isFinite(value) && this.scale ? cssColour(colourAt(this.scale.place(value))) : '#8c8c8c';
  }

  // ---- the picture

  look(view) {
    this.camera.look(view);
    const nets = new Set(this.result.triPart);
    const whole = $('extent').checked || nets.size === 0;
    this.camera.fit(this.model.box(whole ? undefined : (part) => nets.has(part)));
    this.draw();
  }

  resize() {
    const box = $('stage').getBoundingClientRect();
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.renderer.setSize(Math.max(1, box.width), Math.max(1, box.height), false);
    this.camera.resize(box.width, box.height);
  }

  draw() {
    if (this.drawing) return;
    this.drawing = true;
    requestAnimationFrame(() => { this.drawing = false; this.drawNow(); });
  }

  drawNow() {
    this.camera.apply();
    const axes = this.camera.axes(), s = this.shared;
    s.pixelsPerMetre.value = this.camera.pixelsPerMetre * this.renderer.getPixelRatio();
    s.eye.value.set(...axes.eye); s.right.value.set(...axes.right); s.up.value.set(...axes.up);
    this.placeGround();
    const style = getComputedStyle(document.documentElement);
    this.renderer.setClearColor(new L.Color(style.getPropertyValue('--water').trim()), 1);
    this.renderer.render(this.scene, this.camera.camera);
    drawScaleBar($('scale'), this.camera.pixelsPerMetre, this.camera.width);
    $('dimensions').replaceChildren();
    if ($('measures').checked) drawDimensions($('dimensions'), this.model, this.camera);
    this.drawSelection();
    if (this.plan && !this.isSweep) this.plan.draw((cell, part) => this.colourOfCell(cell, part), this.models[0].shown, this.selection, style.getPropertyValue('--ink'));
    document.documentElement.dataset.drawn = String(Number(document.documentElement.dataset.drawn || 0) + 1);
  }

  placeGround() {
    const {bed, origin} = this.result, want = {bed: bed && $('bed').checked, surface: $('surface').checked};
    this.grounds = this.grounds || {};
    for (const name of ['bed', 'surface']) {
      if (want[name] && !this.grounds[name]) {
        const height = name === 'bed' ? (x, y) => bed.slopeX * x + bed.slopeY * y - bed.depth : () => 0;
        this.grounds[name] = makeGround(this.model.box(), height, origin, name === 'bed' ? [0.62, 0.53, 0.36] : [0.45, 0.7, 0.9], this.shared.pixelsPerMetre, 0.45);
        this.scene.add(this.grounds[name]);
      }
      if (this.grounds[name]) this.grounds[name].visible = Boolean(want[name]);
    }
  }

  // ---- selection

  makeMarks() {
    this.isCut = (p) => { const s = this.shared.section.value; return p[0] * s.x + p[1] * s.y + p[2] * s.z > s.w; };
  }

  pickAt(x, y) { return pick(this.model, this.camera, x, y, this.isCut); }

  select(hit) {
    this.selection = hit;
    describeSelection($('selection'), this, hit);
    this.draw();
  }

  drawSelection() {
    const s = this.selection;
    if (!s) return;
    const {points, result} = this.model, y = (v) => (s.mirrored ? -2 * result.origin[1] - v : v);
    const corners = s.nodes.map((n) => this.camera.project([points[3 * n], y(points[3 * n + 1]), points[3 * n + 2]]));
    const path = corners.map((c, i) => `${i ? 'L' : 'M'}${c[0]} ${c[1]}`).join('') + 'Z';
    $('dimensions').append(svgElement('path', {d: path, class: 'selected'}));
    const at = [0, 1].map((axis) => corners.reduce((sum, c, i) => sum + s.weights[i] * c[axis], 0));
    $('dimensions').append(svgElement('circle', {cx: at[0], cy: at[1], r: 7, class: 'selected'}));
  }

  /** The next cell of the same part, for those who have no pointer. */
  step(by) {
    const r = this.result, s = this.selection;
    const kind = s ? s.kind : r.triPart.length ? 'netting' : 'bar';
    const [parts, cells, nodes, of] = {netting: [r.triPart, r.triCell, r.tri, 3], bar: [r.barPart, r.barCell, r.bar, 2], dot: [r.dotPart, r.dotCell, r.dot, 1]}[kind];
    const index = ((s ? s.index + by : 0) + parts.length) % parts.length;
    this.select({kind, index, part: parts[index], cell: cells[index], nodes: Array.from(nodes.slice(of * index, of * index + of)), weights: Array(of).fill(1 / of), mirrored: false});
  }

  describeFrame() {
    const frame = this.frames[this.frame], r = this.result;
    $('when').textContent = this.isSweep ? r.file : r.motion ? `${formatNumber(r.times[frame.state])} s` : `state ${frame.state + 1} of ${r.states.length}`;
    $('frame').value = String(this.frame);
    $('frame').setAttribute('aria-valuetext', $('when').textContent);
    if (this.curve) this.curve.mark(this.isSweep ? this.frame : r.times[frame.state]);
    if (this.selection) describeSelection($('selection'), this, this.selection);
  }
}

/** Finds the node of another result that has the same part and panel coordinates, or the same number in its part. */
function placesIn(model) {
  const r = model.result, byNumber = new Map(), key = (part, number) => `${part} ${number}`;
  for (let n = 0; n < r.nPoints; ++n) byNumber.set(key(r.parts[r.nodePart[n]].name, r.nodeNumber[n]), n);
  return (result, node) => {
    const found = byNumber.get(key(result.parts[result.nodePart[node]].name, result.nodeNumber[node]));
    return found === undefined || result.nPoints !== r.nPoints ? -1 : found;
  };
}

function describeSelection(box, viewer, hit) {
  box.replaceChildren();
  if (!hit) { box.textContent = 'Nothing is selected. Click a part of the gear, or press N.'; return; }
  const {result, state} = viewer.model, part = result.parts[hit.part], rows = [];
  const mean = (array, k, of) => hit.nodes.reduce((sum, n, i) => sum + hit.weights[i] * array[of * n + k], 0);
  rows.push(['part', part.name], ['type', part.type]);
  if (hit.kind === 'netting' && Number.isFinite(result.triUV[6 * hit.index])) {
    const uv = [0, 1].map((k) => [0, 1, 2].reduce((sum, i) => sum + hit.weights[i] * result.triUV[6 * hit.index + 2 * i + k], 0));
    rows.push(['on the plan', `${formatNumber(uv[0])} meshes across, ${formatNumber(uv[1])} deep`]);
  }
  const place = [0, 1, 2].map((k) => mean(state.points, k, 3) + result.origin[k]);
  if (hit.mirrored) place[1] = -place[1];
  rows.push(['position', place.map((v) => formatNumber(v, 5)).join(', ') + ' m']);
  if (result.nodeError !== null) rows.push(['position, solver error', `± ${formatNumber(result.nodeError, 2)} m; of the mesh ±?`]);
  result.fields.forEach((field, i) => {
    const value = state.fields[i][hit.cell];
    if (Number.isFinite(value)) rows.push([field.name.replaceAll('_', ' '), `${withUnit(value, field.unit)} ±?`]);
  });
  for (const name of ['reaction', 'residual']) {
    if (!state[name]) continue;
    const force = Math.hypot(...[0, 1, 2].map((k) => state[name][3 * hit.nodes[0] + k]));
    if (force > 0) rows.push([name === 'reaction' ? 'held with' : 'out of balance', `${formatNumber(force)} N at its first node`]);
  }
  const list = element('dl');
  for (const [name, value] of rows) list.append(element('dt', {}, name), element('dd', {}, value));
  box.append(list);
}
