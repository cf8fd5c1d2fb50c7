// SPDX-License-Identifier: BSD-3-Clause
// The plan drawing: every panel without tension, in the colours of the shape beside it. A click in the plan
// also selects the element in the shape.

/** Panels without a place on a plan lie in a row, to the scale of half their stretched width, as plans are drawn. */
function placeOnSheet(result) {
  let next = 0;
  const boxes = new Map();
  for (let t = 0; t < result.triPart.length; ++t)
    for (let k = 0; k < 3; ++k) {
      const U = result.triUV[6 * t + 2 * k], V = result.triUV[6 * t + 2 * k + 1];
      if (!Number.isFinite(U)) continue;
      const box = boxes.get(result.triPart[t]) || [Infinity, -Infinity, Infinity];
      boxes.set(result.triPart[t], [Math.min(box[0], U), Math.max(box[1], U), Math.min(box[2], V)]);
    }
  for (const [part, [lo, hi, top]] of boxes) {
    const of = result.parts[part];
    if (of.sheet) continue;
    const bar = of.bar || 1;
    of.sheet = [next - lo * bar, -2 * bar * top, bar, 0, 0, 2 * bar];
    next += (hi - lo) * bar * 1.15;
  }
}

class PlanDrawing {
  constructor(canvas, viewer) {
    Object.assign(this, {canvas, viewer, sheets: new Map()});
    this.take(viewer.model);
    new ResizeObserver(() => viewer.redraw()).observe(canvas);
    canvas.addEventListener('click', (event) => {
      const box = canvas.getBoundingClientRect();
      viewer.selection.set(this.pick(event.clientX - box.left, event.clientY - box.top), event.shiftKey);
    });
  }

  /** Draws that model from now on: the results of a sweep may have different meshes. */
  take(model) {
    Object.assign(this, {model, result: model.result});
    if (!this.sheets.has(model)) this.sheets.set(model, this.makeSheet());
    Object.assign(this, this.sheets.get(model));
  }

  makeSheet() {
    placeOnSheet(this.result);
    this.corners = this.placeCorners();
    return {corners: this.corners, border: this.findBorder(), names: this.findNames()};
  }

  get isEmpty() { return this.border.length === 0; }

  /** x, y of all corners of triangles on the sheet [m]; NaN off a panel. */
  placeCorners() {
    const {triUV, triPart, parts} = this.result, corners = new Float64Array(triUV.length);
    for (let t = 0; t < triPart.length; ++t) {
      const s = parts[triPart[t]].sheet;
      for (let k = 0; k < 3; ++k) {
        const U = triUV[6 * t + 2 * k], V = triUV[6 * t + 2 * k + 1];
        corners[6 * t + 2 * k] = s ? s[0] + U * s[2] + V * s[4] : NaN;
        corners[6 * t + 2 * k + 1] = s ? s[1] + U * s[3] + V * s[5] : NaN;
      }
    }
    return corners;
  }

  isKnown(t) { return Number.isFinite(this.corners[6 * t]); }

  /** Sides that only one triangle has. */
  findBorder() {
    const sides = new Map();
    const corner = (i) => `${Math.round(1e4 * this.corners[i])} ${Math.round(1e4 * this.corners[i + 1])}`;
    for (let t = 0; t < this.result.triPart.length; ++t) {
      if (!this.isKnown(t)) continue;
      for (let k = 0; k < 3; ++k) {
        const a = 6 * t + 2 * k, b = 6 * t + 2 * ((k + 1) % 3), key = [corner(a), corner(b)].sort().join(' ') + this.result.triPart[t];
        sides.set(key, sides.has(key) ? null : [a, b]);
      }
    }
    return [...sides.values()].filter(Boolean);
  }

  /** Where names of panels stand: in the middle of each. */
  findNames() {
    const boxes = new Map();
    for (let i = 0; i < this.corners.length; i += 2) {
      if (!Number.isFinite(this.corners[i])) continue;
      const part = this.result.triPart[Math.floor(i / 6)], [x, y] = [this.corners[i], this.corners[i + 1]];
      const box = boxes.get(part) || {x: 0, y: 0, n: 0, lo: [x, y], hi: [x, y]};
      boxes.set(part, {x: box.x + x, y: box.y + y, n: box.n + 1, lo: [Math.min(box.lo[0], x), Math.min(box.lo[1], y)], hi: [Math.max(box.hi[0], x), Math.max(box.hi[1], y)]});
    }
    return [...boxes].map(([part, {x, y, n, lo, hi}]) => ({name: this.result.parts[part].name, x: x / n, y: y / n, lo, hi}));
  }

  fit() {
    const box = this.canvas.getBoundingClientRect();
    const lo = [Infinity, Infinity], hi = [-Infinity, -Infinity];
    this.corners.forEach((v, i) => { if (Number.isFinite(v)) { lo[i % 2] = Math.min(lo[i % 2], v); hi[i % 2] = Math.max(hi[i % 2], v); } });
    // A long, narrow plan is turned by a right angle, so that it fills the box. The fore end is then to the
    // left, as in the view from the side.
    this.lies = hi[1] - lo[1] > hi[0] - lo[0];
    const [wide, high] = this.lies ? [1, 0] : [0, 1];
    const scale = 0.94 * Math.min(box.width / Math.max(hi[wide] - lo[wide], 1e-6), box.height / Math.max(hi[high] - lo[high], 1e-6));
    const middle = [0, 1].map((axis) => (lo[axis] + hi[axis]) / 2);
    this.place = ([x, y]) => {
      const [dx, dy] = [scale * (x - middle[0]), scale * (y - middle[1])];
      return this.lies ? [box.width / 2 + dy, box.height / 2 + dx] : [box.width / 2 + dx, box.height / 2 + dy];
    };
  }

  /** Clears the canvas, as large as it is shown. */
  begin() {
    const g = this.canvas.getContext('2d'), box = this.canvas.getBoundingClientRect(), ratio = window.devicePixelRatio || 1;
    this.canvas.width = Math.max(1, Math.round(box.width * ratio));
    this.canvas.height = Math.max(1, Math.round(box.height * ratio));
    g.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.fit();
    return g;
  }

  at(i) { return this.place([this.corners[i], this.corners[i + 1]]); }

  draw() {
    this.take(this.viewer.model);
    if (this.isEmpty) return;
    const g = this.begin(), {model} = this, {selection} = this.viewer, ink = styleColour('--ink');
    for (let t = 0; t < this.result.triPart.length; ++t) {
      if (!this.isKnown(t) || !model.shown[this.result.triPart[t]]) continue;
      g.fillStyle = g.strokeStyle = this.viewer.colourOnPlan(t);
      this.trace(g, t);
      g.fill();
      g.lineWidth = 0.4;
      g.stroke();
    }
    this.drawBorder(g, ink);
    this.drawNames(g, ink);
    this.mark(g, selection.hit);
  }

  drawBorder(g, ink) {
    g.strokeStyle = ink;
    g.lineWidth = 1.2;
    g.beginPath();
    for (const [a, b] of this.border) { g.moveTo(...this.at(a)); g.lineTo(...this.at(b)); }
    g.stroke();
  }

  drawNames(g, ink) {
    g.font = '11px system-ui, sans-serif';
    g.textAlign = 'center';
    g.lineWidth = 3;
    for (const {name, x, y, lo, hi} of this.names) {
      const [px, py] = this.place([x, y]), [a, b] = [this.place(lo), this.place(hi)];
      // a name that does not fit is shown in the list of parts, or after a click
      if (g.measureText(name).width > Math.abs(a[0] - b[0])) continue;
      g.strokeStyle = styleColour('--paper');
      g.strokeText(name, px, py + 4);
      g.fillStyle = ink;
      g.fillText(name, px, py + 4);
    }
  }

  trace(g, t) {
    g.beginPath();
    g.moveTo(...this.at(6 * t)); g.lineTo(...this.at(6 * t + 2)); g.lineTo(...this.at(6 * t + 4));
    g.closePath();
  }

  mark(g, hit) {
    if (!hit || paneOf(hit) || hit.kind !== 'netting' || !this.isKnown(hit.index)) return;
    this.trace(g, hit.index);
    g.lineWidth = 2;
    g.strokeStyle = styleColour('--mark');
    g.stroke();
    g.beginPath();
    g.arc(...this.whereIs(hit), 6, 0, 2 * Math.PI);
    g.stroke();
  }

  whereIs(hit) {
    const corners = [0, 2, 4].map((k) => this.at(6 * hit.index + k));
    return [0, 1].map((axis) => corners.reduce((sum, c, k) => sum + hit.weights[k] * c[axis], 0));
  }

  /** The triangle under a point of the drawing. */
  pick(x, y) {
    this.fit();
    for (let t = 0; t < this.result.triPart.length; ++t) {
      const weights = this.isKnown(t) ? barycentric([x, y], this.at(6 * t), this.at(6 * t + 2), this.at(6 * t + 4)) : null;
      if (weights) return {kind: 'netting', index: t, part: this.result.triPart[t], cell: this.result.triCell[t], nodes: nodesOfElement(this.result, 'netting', t), weights, mirrored: false};
    }
    return null;
  }
}
