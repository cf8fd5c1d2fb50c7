// SPDX-License-Identifier: BSD-3-Clause
// Controls, keyboard, curves; and how the page begins.

Viewer.prototype.makeControls = function () {
  this.makeFieldControls();
  this.makeViewControls();
  this.makePartList();
  this.makePointer();
  this.makeKeyboard();
  this.makeFrames();
  this.makeCurves();
};

Viewer.prototype.makeFieldControls = function () {
  $('field').replaceChildren(...this.fieldChoices().map((f) => element('option', {value: f.name}, f.label)));
  $('field').addEventListener('change', () => this.setField($('field').value));
  $('log').addEventListener('change', () => this.repaint());
  for (const id of ['bed', 'surface', 'measures']) $(id).addEventListener('change', () => this.draw());
  $('bed').disabled = !this.result.bed;
  $('bed').checked = Boolean(this.result.bed);
  $('overlay-row').hidden = !this.second;
  if (this.second) {
    $('overlay').replaceChildren(element('option', {value: 'both'}, 'both, the second in one colour'), ...this.results.map((r, i) => element('option', {value: String(i)}, r.file)));
    $('overlay').addEventListener('change', () => { this.applyVisibility(); this.draw(); });
    this.applyVisibility();
  }
  const cut = () => {
    const axis = SECTIONS[$('section').value];
    $('cut').disabled = !axis;
    const corners = this.model.box(), k = axis ? axis.indexOf(1) : 0;
    const [lo, hi] = [Math.min(...corners.map((c) => c[k])), Math.max(...corners.map((c) => c[k]))];
    const at = lo + (hi - lo) * Number($('cut').value) / 100;
    this.shared.section.value.set(...(axis || [0, 0, 0]), axis ? at + 1e-9 : 1e30);
    this.draw();
  };
  $('section').addEventListener('change', cut);
  $('cut').addEventListener('input', cut);
};

Viewer.prototype.makeViewControls = function () {
  for (const name of Object.keys(VIEWS)) $(`view-${name}`).addEventListener('click', () => this.look(name));
  $('extent').addEventListener('change', () => this.look('oblique'));
  $('print').addEventListener('click', () => window.print());
  $('theme').addEventListener('click', () => {
    const root = document.documentElement, isDark = getComputedStyle(root).getPropertyValue('--is-dark').trim() === '1';
    root.dataset.theme = isDark ? 'light' : 'dark';
    if (this.drawCurve) this.drawCurve();
    this.draw();
  });
};

Viewer.prototype.makePartList = function () {
  const list = $('parts');
  const refresh = () => { list.querySelectorAll('input').forEach((box, part) => this.models.forEach((m) => m.show(part, box.checked))); this.draw(); };
  list.replaceChildren(...this.result.parts.map((part, i) => {
    const row = element('li'), label = element('label'), box = element('input', {type: 'checkbox'}), only = element('button', {type: 'button', 'aria-label': `show ${part.name} only`}, 'only');
    box.checked = Boolean(this.models[0].shown[i]);
    box.addEventListener('change', refresh);
    only.addEventListener('click', () => {
      const boxes = [...list.querySelectorAll('input')], alone = boxes.every((b, k) => b.checked === (k === i));
      boxes.forEach((b, k) => { b.checked = alone || k === i; });
      refresh();
    });
    const patch = element('span', {class: 'patch', 'aria-hidden': 'true'});
    patch.style.background = cssColour(partColour(i));
    label.append(box, patch, element('span', {}, part.name));
    row.append(label, only);
    return row;
  }));
};

Viewer.prototype.makePointer = function () {
  let last = null, moved = 0;
  const at = (event) => { const box = this.canvas.getBoundingClientRect(); return [event.clientX - box.left, event.clientY - box.top]; };
  this.canvas.addEventListener('pointerdown', (event) => { last = at(event); moved = 0; this.canvas.setPointerCapture(event.pointerId); });
  this.canvas.addEventListener('pointermove', (event) => {
    if (!last) return;
    const now = at(event), dx = now[0] - last[0], dy = now[1] - last[1];
    moved += Math.abs(dx) + Math.abs(dy);
    last = now;
    if (event.buttons & 2 || event.shiftKey) this.camera.pan(dx, dy); else this.camera.turn(0.008 * dx, 0.008 * dy);
    this.draw();
  });
  this.canvas.addEventListener('pointerup', (event) => {
    if (last && moved < 4 && event.button === 0) this.select(this.pickAt(...at(event)));
    last = null;
  });
  this.canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  this.canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    this.camera.zoom(Math.exp(-0.0015 * event.deltaY), ...at(event));
    this.draw();
  }, {passive: false});
};

Viewer.prototype.makeKeyboard = function () {
  const turn = 0.08;
  const keys = {
    ArrowLeft: () => this.camera.turn(-turn, 0), ArrowRight: () => this.camera.turn(turn, 0),
    ArrowUp: () => this.camera.turn(0, turn), ArrowDown: () => this.camera.turn(0, -turn),
    '+': () => this.camera.zoom(1.2), '=': () => this.camera.zoom(1.2), '-': () => this.camera.zoom(1 / 1.2),
    1: () => this.look('side'), 2: () => this.look('top'), 3: () => this.look('front'), 4: () => this.look('oblique'),
    n: () => this.step(1), p: () => this.step(-1), Escape: () => this.select(null),
  };
  this.canvas.addEventListener('keydown', (event) => {
    const pans = {ArrowLeft: [30, 0], ArrowRight: [-30, 0], ArrowUp: [0, 30], ArrowDown: [0, -30]};
    if (event.shiftKey && pans[event.key]) this.camera.pan(...pans[event.key]);
    else if (keys[event.key] && !event.ctrlKey && !event.metaKey) keys[event.key]();
    else return;
    event.preventDefault();
    this.draw();
  });
};

Viewer.prototype.makeFrames = function () {
  const n = this.frames.length;
  $('time').hidden = n < 2;
  $('frame').max = String(n - 1);
  $('frame').addEventListener('input', () => this.showFrame(Number($('frame').value)));
  $('play').addEventListener('click', () => {
    const wasPlaying = Boolean(this.timer);
    clearInterval(this.timer);
    this.timer = null;
    $('play').textContent = wasPlaying ? 'Play' : 'Stop';
    if (!wasPlaying) this.timer = setInterval(() => this.showFrame((this.frame + 1) % n), Math.max(40, 4000 / n));
  });
  this.describeFrame();
};

/** Curves: quantities over the frames, and the residual over the iterations of the solve. */
Viewer.prototype.curveChoices = function () {
  const r = this.results[0], choices = [];
  const log = r.convergence;
  if (this.isSweep) {
    for (const figure of r.figures) {
      const values = this.results.map((one) => (one.figures.find((f) => f.name === figure.name) || {value: NaN}).value);
      choices.push({name: figure.name, unit: figure.unit, x: values.map((_, i) => i), y: values, over: 'number of the result'});
    }
  } else for (const series of r.series) choices.push({name: series.name, unit: series.unit, x: r.times, y: series.values, over: 'time [s]'});
  if (log && log.residual.length > 1)
    choices.push({name: 'residual of the solve', unit: 'N', x: log.residual.map((_, i) => i), y: log.residual, over: 'accepted step', log: true});
  return choices;
};

Viewer.prototype.makeCurves = function () {
  const choices = this.curveChoices();
  $('curve-box').hidden = choices.length === 0;
  if (!choices.length) return;
  $('quantity').replaceChildren(...choices.map((c, i) => element('option', {value: String(i)}, c.name.replaceAll('_', ' ').replaceAll('/', ', '))));
  const draw = this.drawCurve = () => { this.curve = makeCurve($('curve'), choices[Number($('quantity').value)], (i) => { if (this.frames.length > 1) this.showFrame(Math.min(i, this.frames.length - 1)); }); this.describeFrame(); };
  $('quantity').addEventListener('change', draw);
  draw();
};

function makeCurve(box, choice, onClick) {
  box.replaceChildren();
  const ink = getComputedStyle(document.documentElement).getPropertyValue('--ink').trim();
  const isPower = (v) => Math.abs(Math.log10(v) - Math.round(Math.log10(v))) < 1e-9;
  const numbers = (_, values) => values.map((v) => (v === null ? '' : formatNumber(v, 3)));
  const powers = (_, values) => values.map((v) => (v > 0 && isPower(v) ? v.toExponential(0) : ''));
  let marked = null;
  const axis = {stroke: ink, grid: {stroke: 'rgba(128,128,128,0.3)'}, ticks: {stroke: ink}, values: numbers};
  const plot = new L.uPlot({
    width: Math.max(200, box.clientWidth), height: 180, legend: {show: false},
    scales: {x: {time: false}, y: {distr: choice.log ? 3 : 1}},
    axes: [{...axis, label: choice.over}, {...axis, size: 64, values: choice.log ? powers : numbers, label: choice.unit === '1' ? '' : choice.unit}],
    series: [{}, {stroke: '#2c8fc9', width: 2, points: {show: choice.x.length < 40}}],
    hooks: {draw: [(u) => {
      if (marked === null || choice.log) return;
      const x = Math.round(u.valToPos(marked, 'x', true));
      u.ctx.save(); u.ctx.strokeStyle = '#d55e00'; u.ctx.lineWidth = 2; u.ctx.beginPath();
      u.ctx.moveTo(x, u.bbox.top); u.ctx.lineTo(x, u.bbox.top + u.bbox.height); u.ctx.stroke(); u.ctx.restore();
    }]},
  }, [choice.x, choice.y.map((v) => (Number.isFinite(v) && !(choice.log && v <= 0) ? v : null))], box);
  plot.over.addEventListener('click', () => { if (plot.cursor.idx !== null && !choice.log) onClick(plot.cursor.idx); });
  return {mark: (x) => { marked = x; plot.redraw(false); }};
}

/** A page without WebGL keeps its report and its pictures, and says why there is no more. */
function stayStatic(reason) {
  $('status').textContent = `${reason} The report and the pictures below do not need it.`;
  $('status').hidden = false;
  $('app').hidden = true;
  document.documentElement.dataset.ready = 'static';
}

async function begin() {
  const data = JSON.parse($('data').textContent);
  const results = await Promise.all(data.results.map(decodeResult));
  $('app').hidden = false;
  let viewer;
  try {
    viewer = new Viewer(results);
  } catch (error) {
    stayStatic('This browser does not draw in three dimensions (WebGL is switched off or missing).');
    return;
  }
  await viewer.start();
  window.netloftViewer = viewer;
  $('pictures').hidden = true;
  viewer.drawNow();
  document.documentElement.dataset.ready = 'yes';
}

begin().catch((error) => stayStatic(`The page cannot be shown: ${error.message}.`));
