// SPDX-License-Identifier: BSD-3-Clause
// The plan drawing: every panel as it lies in repose, coloured like the shape beside it. A click there selects here.

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
  constructor(canvas, result, onPick) {
    Object.assign(this, {canvas, result});
    placeOnSheet(result);
    this.corners = this.placeCorners();
    this.border = this.findBorder();
    canvas.addEventListener('click', (event) => {
      const box = canvas.getBoundingClientRect();
      onPick(this.pick(event.clientX - box.left, event.clientY - box.top));
    });
  }

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

  /** Sides that only one triangle has. */
  findBorder() {
    const sides = new Map(), c = this.corners;
    for (let t = 0; t < c.length / 6; ++t)
      for (let k = 0; k < 3; ++k) {
        const a = 6 * t + 2 * k, b = 6 * t + 2 * ((k + 1) % 3);
        const ends = [a, b].map((i) => `${c[i].toFixed(5)},${c[i + 1].toFixed(5)}`).sort().join(' ');
        sides.set(ends, sides.has(ends) ? null : [a, b]);
      }
    return [...sides.values()].filter((side) => side && Number.isFinite(c[side[0]]));
  }

  fit() {
    const ratio = window.devicePixelRatio || 1, box = this.canvas.getBoundingClientRect();
    this.canvas.width = Math.max(1, Math.round(box.width * ratio));
    this.canvas.height = Math.max(1, Math.round(box.height * ratio));
    let [x0, x1, y0, y1] = [Infinity, -Infinity, Infinity, -Infinity];
    for (let i = 0; i < this.corners.length; i += 2) {
      if (!Number.isFinite(this.corners[i])) continue;
      x0 = Math.min(x0, this.corners[i]); x1 = Math.max(x1, this.corners[i]);
      y0 = Math.min(y0, this.corners[i + 1]); y1 = Math.max(y1, this.corners[i + 1]);
    }
    const scale = 0.92 * Math.min(box.width / Math.max(x1 - x0, 1e-6), box.height / Math.max(y1 - y0, 1e-6));
    this.place = {scale, x: box.width / 2 - scale * (x0 + x1) / 2, y: box.height / 2 - scale * (y0 + y1) / 2, ratio};
  }

  at(i) {
    return [this.place.x + this.place.scale * this.corners[i], this.place.y + this.place.scale * this.corners[i + 1]];
  }

  draw(colourOfCell, shown, selection, ink) {
    this.fit();
    const g = this.canvas.getContext('2d');
    g.setTransform(this.place.ratio, 0, 0, this.place.ratio, 0, 0);
    g.clearRect(0, 0, this.canvas.width, this.canvas.height);
    for (let t = 0; t < this.result.triPart.length; ++t) {
      if (!Number.isFinite(this.corners[6 * t]) || !shown[this.result.triPart[t]]) continue;
      g.fillStyle = g.strokeStyle = colourOfCell(this.result.triCell[t], this.result.triPart[t]);
      this.trace(g, t);
      g.fill();
      g.lineWidth = 0.4;
      g.stroke();
    }
    g.strokeStyle = ink;
    g.lineWidth = 1.2;
    g.beginPath();
    for (const [a, b] of this.border) { g.moveTo(...this.at(a)); g.lineTo(...this.at(b)); }
    g.stroke();
    this.mark(g, selection);
  }

  trace(g, t) {
    g.beginPath();
    g.moveTo(...this.at(6 * t)); g.lineTo(...this.at(6 * t + 2)); g.lineTo(...this.at(6 * t + 4));
    g.closePath();
  }

  mark(g, selection) {
    if (!selection || selection.kind !== 'netting' || !Number.isFinite(this.corners[6 * selection.index])) return;
    this.trace(g, selection.index);
    g.lineWidth = 2;
    g.strokeStyle = '#ff3b30';
    g.stroke();
    const [x, y] = this.whereIs(selection);
    g.beginPath();
    g.arc(x, y, 6, 0, 2 * Math.PI);
    g.stroke();
  }

  whereIs(selection) {
    const corners = [0, 2, 4].map((k) => this.at(6 * selection.index + k));
    return [0, 1].map((axis) => corners.reduce((sum, c, k) => sum + selection.weights[k] * c[axis], 0));
  }

  /** The triangle under a point of the drawing. */
  pick(x, y) {
    for (let t = 0; t < this.result.triPart.length; ++t) {
      if (!Number.isFinite(this.corners[6 * t])) continue;
      const weights = barycentric([x, y], this.at(6 * t), this.at(6 * t + 2), this.at(6 * t + 4));
      if (weights) {
        const nodes = [0, 1, 2].map((k) => this.result.tri[3 * t + k]);
        return {kind: 'netting', index: t, part: this.result.triPart[t], cell: this.result.triCell[t], nodes, weights, mirrored: false};
      }
    }
    return null;
  }
}
