// SPDX-License-Identifier: BSD-3-Clause
// One result as meshes of the renderer: netting (surface and twines), bars, single nodes, the catch, solids;
// half a gear is shown twice, once mirrored.

const ALONG = [0, -1, 1, -1, 0, 1, 1, 1], AROUND = [-1, -1, 1, -1, -1, 1, 1, 1];  // corners of a ribbon, of a disc

class GearModel {
  constructor(result, shared, colours) {
    Object.assign(this, {result, shared, colours});
    this.shown = new Uint8Array(Math.max(1, result.parts.length)).fill(255);
    this.texture = new L.DataTexture(new Uint8Array(4 * this.shown.length).fill(255), this.shown.length, 1);
    this.texture.needsUpdate = true;
    this.uniforms = {partShown: {value: this.texture}, plain: {value: new L.Vector3(0.5, 0.53, 0.56)}, usePlain: {value: 0}};
    this.group = new L.Group();
    this.makeNetting();
    this.makeRopes();
    this.makeOutline();
    this.makeBalls();
    if (result.catch) this.makeCatch();
    this.solids = new Solids(this);
    this.drawn = new Set();  // parts with elements; water that the gear slows has none
    for (const c of CELLS) for (const part of result[c.parts]) this.drawn.add(part);
    // Elements of contact with the bed are hidden unless they are selected.
    result.parts.forEach((p, i) => { if (p.contact || !this.drawn.has(i)) this.show(i, false); });
  }

  material(kind, vertexShader, fragmentShader, more = {}, options = {}) {
    return new L.RawShaderMaterial({glslVersion: L.GLSL3, vertexShader, fragmentShader, side: L.DoubleSide,
      uniforms: {...this.shared.common, ...this.shared.scales[kind], ...this.uniforms, ...more}, ...options});
  }

  /** Adds a mesh, and its mirror image if one half was modelled. */
  add(geometry, material, order) {
    for (const sign of this.result.half ? [1, -1] : [1]) {
      const mesh = new L.Mesh(geometry, material);
      mesh.scale.y = sign;
      mesh.position.y = sign < 0 ? -2 * this.result.origin[1] : 0;
      mesh.frustumCulled = false;
      mesh.renderOrder = order;
      this.group.add(mesh);
    }
  }

  dispose() {
    this.group.traverse((mesh) => { if (mesh.geometry) { mesh.geometry.dispose(); mesh.material.dispose(); } });
    this.group.removeFromParent();
    this.texture.dispose();
  }

  makeNetting() {
    const {tri, triUV, triPart, parts} = this.result, n = tri.length / 3;
    this.netting = new L.BufferGeometry();
    const twines = new Float32Array(6 * n), part = new Float32Array(3 * n), radius = new Float32Array(3 * n), colour = new Float32Array(9 * n);
    for (let t = 0; t < n; ++t) {
      const of = parts[triPart[t]], a = of.axes, rgb = this.colours.ofPart(triPart[t]);
      let known = Boolean(a);
      for (let k = 0; k < 6; ++k) known = known && Number.isFinite(triUV[6 * t + k]);
      for (let k = 0; k < 3; ++k) {
        const U = triUV[6 * t + 2 * k], V = triUV[6 * t + 2 * k + 1];
        twines[6 * t + 2 * k] = known ? a[0] * U + a[1] * V : NONE;
        twines[6 * t + 2 * k + 1] = known ? a[2] * U + a[3] * V : NONE;
        part[3 * t + k] = triPart[t];
        radius[3 * t + k] = (of.diameter || 0.002) / 2;
        colour.set(rgb, 9 * t + 3 * k);
      }
    }
    setAttributes(this.netting, {position: [new Float32Array(9 * n), 3], twines: [twines, 2], part: [part, 1],
      halfWidth: [radius, 1], value: [new Float32Array(3 * n).fill(NONE), 1], partColour: [colour, 3]});
    // Twines have soft edges: as many samples of a pixel are covered as the twine covers of the pixel.
    this.add(this.netting, this.material('netting', NETTING_VERTEX, NETTING_FRAGMENT, {hasLines: {value: true}}, {alphaToCoverage: true}), 1);
    this.add(this.netting, this.material('netting', NETTING_VERTEX, NETTING_FRAGMENT, {hasLines: {value: false}}, {transparent: true, depthWrite: false}), 3);
  }

  /** Attributes of bars or dots that never change. */
  ofParts(partOf, fallback) {
    const n = partOf.length, part = new Float32Array(n), radius = new Float32Array(n), colour = new Float32Array(3 * n);
    for (let i = 0; i < n; ++i) {
      part[i] = partOf[i];
      radius[i] = (this.result.parts[partOf[i]].diameter || fallback) / 2;
      colour.set(this.colours.ofPart(partOf[i]), 3 * i);
    }
    return {part: [part, 1], halfWidth: [radius, 1], partColour: [colour, 3], value: [new Float32Array(n).fill(NONE), 1]};
  }

  ribbons(partOf, fallback) {
    const n = partOf.length;
    return squares(ALONG, n, {from: [new Float32Array(3 * n), 3], to: [new Float32Array(3 * n), 3], ...this.ofParts(partOf, fallback)});
  }

  makeRopes() {
    this.ropes = this.ribbons(this.result.barPart, 0.01);
    this.add(this.ropes, this.material('rope', ROPE_VERTEX, ROPE_FRAGMENT, {leastPixels: {value: 1.5}}), 2);
  }

  /** Thin lines round every panel, so that netting is seen where it is gathered to nothing. */
  makeOutline() {
    this.border = outline(this.result);
    this.edges = this.ribbons(this.border.parts, 0);
    this.edges.attributes.halfWidth.array.fill(0);
    this.add(this.edges, this.material('netting', ROPE_VERTEX, ROPE_FRAGMENT, {leastPixels: {value: 0.6}}), 2);
  }

  makeBalls() {
    const n = this.result.dot.length;
    this.balls = squares(AROUND, n, {centre: [new Float32Array(3 * n), 3], ...this.ofParts(this.result.dotPart, 0)});
    // The plate of a body is drawn in place of the node at its origin.
    for (const i of this.result.plateDot) this.balls.attributes.corner.array.fill(0, 8 * i, 8 * i + 8);
    this.add(this.balls, this.material('point', BALL_VERTEX, BALL_FRAGMENT, {leastPixels: {value: 3}}), 2);
  }

  /** The netting that the catch presses on, from inside, and its front, closed to the middle of its rim. */
  makeCatch() {
    const {triangles, rim} = this.result.catch;
    this.catchBody = new L.BufferGeometry();
    const size = 9 * triangles.length + 9 * rim.length / 2;
    setAttributes(this.catchBody, {position: [new Float32Array(size), 3], plane: [new Float32Array(size), 3]});
    const {section, eye} = this.shared.common;
    this.add(this.catchBody, new L.RawShaderMaterial({glslVersion: L.GLSL3, vertexShader: SOLID_VERTEX, fragmentShader: SOLID_FRAGMENT, side: L.DoubleSide,
      uniforms: {section, eye, colour: {value: new L.Vector3(...this.colours.catch)}}, polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 2}), 0);
  }

  moveCatch(points) {
    const {triangles, rim} = this.result.catch, {tri} = this.result, into = this.catchBody.attributes.position, out = into.array;
    const at = (node) => points.subarray(3 * node, 3 * node + 3), middle = [0, 0, 0];
    let k = 0;
    for (const t of triangles) for (let c = 0; c < 3; ++c, k += 3) out.set(at(tri[3 * t + c]), k);
    for (const node of rim) for (let d = 0; d < 3; ++d) middle[d] += at(node)[d] / rim.length;
    if (this.result.half) middle[1] = -this.result.origin[1];
    const front = k;
    for (let i = 0; i < rim.length; i += 2, k += 9) { out.set(at(rim[i]), k); out.set(at(rim[i + 1]), k + 3); out.set(middle, k + 6); }
    into.needsUpdate = true;
    this.flatten(front);
  }

  /** The front is lit as a plane: its rim follows the sides of triangles, up and down. */
  flatten(front) {
    const {position: {array: p}, plane} = this.catchBody.attributes, sum = [0, 0, 0];
    for (let k = front; k < p.length; k += 9) {
      const a = [0, 1, 2].map((d) => p[k + d] - p[k + 6 + d]), b = [0, 1, 2].map((d) => p[k + 3 + d] - p[k + 6 + d]);
      const n = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]], sign = Math.sign(dot3(n, sum)) || 1;
      for (let d = 0; d < 3; ++d) sum[d] += sign * n[d];
    }
    if (this.result.half) sum[1] = 0;
    const size = Math.hypot(...sum);
    for (let k = front; k < p.length && size > 0; k += 3) plane.array.set(sum.map((v) => v / size), k);
    plane.needsUpdate = true;
  }

  /** Moves everything to where the nodes of a state are. */
  move(points) {
    this.points = points;
    const {tri, bar, dot} = this.result;
    gather(this.netting.attributes.position, tri, points, 0, 1, 1);
    gather(this.ropes.attributes.from, bar, points, 0, 2, 4);
    gather(this.ropes.attributes.to, bar, points, 1, 2, 4);
    gather(this.edges.attributes.from, this.border.nodes, points, 0, 2, 4);
    gather(this.edges.attributes.to, this.border.nodes, points, 1, 2, 4);
    gather(this.balls.attributes.centre, dot, points, 0, 1, 4);
    if (this.catchBody) this.moveCatch(points);
    this.solids.move(this.state);
  }

  /** Colours by one value per cell; null: by part. `byElement`: netting in the value of each triangle. */
  paint(values, byElement) {
    const {triCell, barCell, dotCell} = this.result;
    const ofCells = (cells) => (i) => (values ? values[cells[i]] : NaN);
    this.corners = values && !byElement ? valuesAtCorners(this.result, values) : null;
    if (this.corners) putValues(this.netting.attributes.value, this.corners.length, (i) => this.corners[i], 1);
    else putValues(this.netting.attributes.value, triCell.length, ofCells(triCell), 3);
    putValues(this.ropes.attributes.value, barCell.length, ofCells(barCell), 4);
    putValues(this.edges.attributes.value, this.border.cells.length, ofCells(this.border.cells), 4);
    putValues(this.balls.attributes.value, dotCell.length, ofCells(dotCell), 4);
    this.solids.paint(ofCells(dotCell));
  }

  /** Parts of that name: results that are shown together may number theirs differently. */
  showPart(name, on) {
    this.result.parts.forEach((part, i) => { if (part.name === name) this.show(i, on); });
  }

  show(part, on) {
    this.shown[part] = on ? 255 : 0;
    for (let p = 0; p < this.shown.length; ++p) this.texture.image.data[4 * p] = this.shown[p];
    this.texture.needsUpdate = true;
  }

  /** A node, or its mirror image. */
  at(node, mirrored = false) {
    const y = this.points[3 * node + 1];
    return [this.points[3 * node], mirrored ? -2 * this.result.origin[1] - y : y, this.points[3 * node + 2]];
  }

  /** The places of all nodes of shown parts, the mirrored half included: 'netting', 'boards', too, or 'all', also if there is no netting. */
  * places(extent) {
    const wanted = this.result.triPart.some((part) => this.shown[part]) ? extent : 'all';
    if (wanted !== 'netting') yield* this.solids.places(wanted === 'all');
    for (const c of wanted === 'all' ? CELLS : CELLS.slice(0, 1)) {
      const nodes = this.result[c.nodes], parts = this.result[c.parts];
      for (let i = 0; i < nodes.length; ++i) {
        if (!this.shown[parts[Math.floor(i / c.of)]]) continue;
        yield this.at(nodes[i]);
        if (this.result.half) yield this.at(nodes[i], true);
      }
    }
  }
}
