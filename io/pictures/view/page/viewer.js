// SPDX-License-Identifier: BSD-3-Clause
// The picture with its state: the frame, the field and the selection that it shows.

// pixels around the gear; distance between the gear and the legend
const MARGIN = {left: 40, right: 40, top: 40, bottom: 50}, GAP = 10;

/** Numbers that the programs of the graphics card share. */
function makeShared(colours) {
  const scale = (noValue) => ({range: {value: new L.Vector2(1, 0)}, isLog: {value: false}, noValue: {value: new L.Vector3(...noValue)}});
  return {
    common: {pixelsPerMetre: {value: 1}, eye: {value: new L.Vector3()}, right: {value: new L.Vector3()}, up: {value: new L.Vector3()},
      stops: {value: colours.stops.map((c) => new L.Vector3(...c))}, section: {value: new L.Vector4(0, 0, 0, 1e30)}, fill: {value: 0.45}},
    scales: {netting: scale(colours.noValue), rope: scale(colours.noValue), point: scale(colours.float)},
  };
}

class Viewer {
  constructor(style, results) {
    this.results = results;
    this.canvas = $('canvas');
    this.colours = new Colours(style);
    this.camera = new OrbitCamera(style.views);
    this.renderer = new L.WebGLRenderer({canvas: this.canvas, antialias: true, preserveDrawingBuffer: true});
    this.shared = makeShared(this.colours);
    this.models = results.map((result) => new GearModel(result, this.shared, this.colours));
    this.scene = new L.Scene();
    this.scene.add(...this.models.map((m) => m.group));
    this.frames = new Frames(this, results);
    this.fields = new Fields(this.models);
    this.panes = new Panes(this);
    this.selection = new Selection(this, $('selection'));
  }

  get model() { return this.models[this.frames.current.model]; }
  get result() { return this.model.result; }
  get second() { return this.fields.second; }

  async start() {
    await this.moveTo(this.frames.index);
    this.makeGrounds();
    this.plan = new PlanDrawing($('plan'), this);
    $('plan-box').hidden = this.plan.isEmpty;
    this.parts = new PartList(this, $('parts'));
    connectControls(this);
    listenToPointer(this);
    listenToKeys(this);
    this.applyVisibility();
    this.resize();
    this.setField(this.fields.choices[0].name);
    this.look('oblique');
    this.curves = new Curves(this, this.results, this.frames);
    this.frames.describe();
    new ResizeObserver(() => { this.resize(); if (!this.isTouched) this.fit(); this.redraw(); }).observe($('stage'));
  }

  // ---- what is shown

  /** Shows other results of one state, one or two, in the place of those before. The camera and the field stay, and what is hidden. */
  async replace(results) {
    const states = await Promise.all(results.map((result) => decodeState(result, 0)));
    const old = [...this.models], counts = [old[0].result.nCells, results[0].nCells], more = results.length !== old.length;
    const models = results.map((result, i) => (old[i] && old[i].result === result ? old[i] : new GearModel(result, this.shared, this.colours)));
    old[0].result.parts.forEach((part, i) => { if (!part.contact && !old[0].shown[i]) models.forEach((model) => model.showPart(part.name, false)); });
    this.results.splice(0, old.length, ...results);
    this.models.splice(0, old.length, ...models);
    this.place(0, states);
    this.scene.add(...models.map((m) => m.group));
    for (const model of old.filter((m) => !models.includes(m))) { this.plan.sheets.delete(model); model.dispose(); }
    this.fields = new Fields(this.models);
    this.makeGrounds();
    this.parts = new PartList(this, $('parts'));
    if (more) { listFields(this); listResults(this); this.resize(); }
    this.applyVisibility();
    if (counts[0] !== counts[1] || more) this.selection.set(null); else this.selection.describe();
    this.setField(this.field.name);
    if (!this.isTouched || more) this.fit();
  }

  /** The bed and the surface of each gear that is shown in a pane of its own. */
  makeGrounds() {
    for (const ground of this.grounds || []) ground.dispose();
    this.grounds = (this.second ? this.models : [this.model]).map((model) => new Ground(model, this.shared, this.scene));
  }

  /** Puts the nodes elsewhere, in metres, and leaves the colours as they are. */
  showPoints(points) {
    const {origin} = this.result;
    this.model.move(Float32Array.from(points, (v, i) => v - origin[i % 3]));
    this.draw();
  }

  async moveTo(index) {
    this.place(index, await Promise.all(this.frames.statesAt(index).map((state, i) => decodeState(this.results[i], state))));
  }

  place(index, states) {
    this.frames.index = index;
    this.models.forEach((model, i) => { Object.assign(model, {state: states[i], stateIndex: this.frames.statesAt(index)[i]}); model.move(states[i].points); });
  }

  async showFrame(index) {
    const before = this.model;
    await this.moveTo(Math.min(index, this.frames.all.length - 1));
    if (this.model.result.nCells !== before.result.nCells) this.selection.set(null);  // another mesh
    this.applyVisibility();
    this.repaint();
    this.frames.describe();
    this.curves.showFrame();
    this.selection.describe();
  }

  applyVisibility() {
    const mode = this.second ? $('overlay').value : 'one';
    this.models.forEach((model, i) => {
      model.group.visible = this.frames.isSweep ? i === this.frames.current.model : !this.second || mode === 'both' || mode === String(i);
      model.uniforms.usePlain.value = i === 1 && (mode === 'both' || (mode === 'beside' && this.field && this.fields.isOfPairs(this.field))) ? 1 : 0;
    });
  }

  setField(name) {
    this.field = this.fields.find(name);
    $('field').value = this.field.name;
    this.repaint();
    this.parts.showContacts(Boolean(this.scales[2] && !this.scales[0] && !this.scales[1]));
  }

  repaint() {
    const log = $('log').checked;
    this.values = this.models.map((model) => this.fields.values(this.field, model));
    this.models.forEach((model, i) => model.paint(this.values[i], $('by-element').checked));
    this.scales = this.fields.scales(this.field, this.values[0], log);
    CELLS.forEach((c, i) => {
      const scale = this.scales[i], shared = this.shared.scales[c.kind];
      shared.isLog.value = Boolean(scale && scale.log);
      // The range (1, 0) stands for the colours of parts. If a kind of cells has no values, its range does
      // not matter.
      if (this.field.name === BY_PART) shared.range.value.set(1, 0);
      else shared.range.value.set(scale ? scale.lo : 0, scale ? scale.hi : 1);
    });
    drawLegend($('legend'), this.colours, this.field, this.scales);
    if (this.panes.areTwo) this.applyVisibility();
    this.redraw();
  }

  colourOnPlan(t) {
    const {result, corners} = this.model, values = this.values[this.frames.current.model], value = values && values[result.triCell[t]];
    if (this.field.name === BY_PART) return cssColour(this.colours.ofPart(result.triPart[t]));
    const shown = corners ? (corners[3 * t] + corners[3 * t + 1] + corners[3 * t + 2]) / 3 : value;
    return cssColour(Number.isFinite(shown) && this.scales[0] ? this.colours.at(this.scales[0].place(shown)) : this.colours.noValue);
  }

  // ---- the picture

  look(view) {
    this.camera.look(view);
    this.fit();
  }

  /** The gear fills the window, and does so until somebody moves it. */
  fit() {
    this.isTouched = false;
    this.panes.fit($('extent').value, $('legend'));
    this.draw();
  }

  resize() {
    // The viewer has the height of the window, minus the height of everything above it.
    $('app').style.setProperty('--above', `${Math.round($('app').getBoundingClientRect().top + window.scrollY)}px`);
    const box = $('stage').getBoundingClientRect();
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.renderer.setSize(Math.max(1, box.width), Math.max(1, box.height), false);
    this.panes.resize(box);
  }

  /** Paper has its own size, and a light ground. */
  printAs(isPrinting) {
    const {classList, dataset} = document.documentElement;
    if (isPrinting) this.theme = dataset.theme;
    classList.toggle('printing', isPrinting);
    dataset.theme = isPrinting ? 'light' : this.theme || '';
    this.resize();
    if (!this.isTouched) this.fit();
    this.drawNow();
  }

  /** Draws with the next frame of the screen; redraw() the plan, too, whose colours or parts are others now. */
  draw() {
    if (this.isDrawing) return;
    this.isDrawing = true;
    requestAnimationFrame(() => { this.isDrawing = false; this.drawNow(); });
  }

  redraw() {
    this.isPlanOld = true;
    this.draw();
  }

  drawNow() {
    const axes = this.camera.axes(), {pixelsPerMetre, eye, right, up} = this.shared.common, over = $('dimensions');
    pixelsPerMetre.value = this.camera.pixelsPerMetre * this.renderer.getPixelRatio();
    eye.value.set(...axes.eye); right.value.set(...axes.right); up.value.set(...axes.up);
    this.renderer.setClearColor(new L.Color(styleColour('--water')), 1);
    this.renderer.setScissorTest(this.panes.areTwo);
    over.replaceChildren();
    for (const pane of this.panes.list) this.panes.within(pane, () => this.drawPane(pane, this.panes.over(over, pane)));
    drawScaleBar($('scale'), this.camera.pixelsPerMetre, this.camera.width);
    if (this.isPlanOld || this.markedOnPlan !== this.selection.hit) this.drawPlan();
  }

  drawPane({index, model, left, width}, over) {
    const {areTwo, height} = this.panes, box = [left, 0, width, height];
    this.camera.apply();
    this.renderer.setViewport(...box);
    this.renderer.setScissor(...box);
    if (areTwo) this.models.forEach((m) => { m.group.visible = m === model; });
    this.grounds.forEach((ground, i) => { for (const name of ['bed', 'surface']) ground.show(name, $(name).checked && i === index); });
    this.renderer.render(this.scene, this.camera.camera);
    if ($('measures').checked) drawDimensions(over, model, this.camera);
    this.grounds[index].drawEdges(over, this.camera);
    if (!model.result.answer && !this.frames.isSweep) drawWorst(over, model, this.camera);
    if ($('holds').checked) drawHolds(over, model, this.camera, 90);
    if (!areTwo || index === paneOf(this.selection.hit)) this.selection.drawMarks(over, this.camera);
  }

  drawPlan() {
    this.isPlanOld = false;
    this.markedOnPlan = this.selection.hit;
    this.plan.draw();
  }

  pickAt(x, y) {
    const {x: a, y: b, z: c, w} = this.shared.common.section.value, pane = this.panes.at(x);
    const hit = this.panes.within(pane, () => pick(pane.model, this.camera, x - pane.left, y, (p) => a * p[0] + b * p[1] + c * p[2] > w));
    return hit && {...hit, pane: pane.index};
  }
}
