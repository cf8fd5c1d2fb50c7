// SPDX-License-Identifier: BSD-3-Clause
// One result as meshes of the renderer: netting (surface and twines), bars, single nodes; a half twice, mirrored.

const NONE = -1e38;
const L = Libraries;

function attribute(array, size) {
  return new L.BufferAttribute(array, size);
}

/** Every item of an array (`size` numbers) four times: for the corners of a square. */
function fourfold(array, size) {
  const out = new Float32Array(4 * array.length);
  for (let i = 0; i < array.length; i += size)
    for (let corner = 0; corner < 4; ++corner) for (let k = 0; k < size; ++k) out[4 * i + size * corner + k] = array[i + k];
  return out;
}

/** Sides of triangles that no other triangle of the part has: the outlines of its panels. */
function outline(result) {
  const sides = new Map(), n = result.nPoints;
  for (let t = 0; t < result.triPart.length; ++t)
    for (let k = 0; k < 3; ++k) {
      const a = result.tri[3 * t + k], b = result.tri[3 * t + (k + 1) % 3];
      const key = (result.triPart[t] * n + Math.min(a, b)) * n + Math.max(a, b);
      sides.set(key, sides.has(key) ? null : {a, b, part: result.triPart[t], cell: result.triCell[t]});
    }
  const border = [...sides.values()].filter(Boolean);
  return {nodes: Uint32Array.from(border.flatMap((s) => [s.a, s.b])), parts: border.map((s) => s.part), cells: border.map((s) => s.cell)};
}

class GearModel {
  constructor(result, shared) {
    this.result = result;
    this.shown = new Uint8Array(Math.max(1, result.parts.length)).fill(255);
    this.texture = new L.DataTexture(new Uint8Array(4 * this.shown.length).fill(255), this.shown.length, 1);
    this.texture.needsUpdate = true;
    this.uniforms = {...shared, partShown: {value: this.texture}, plain: {value: new L.Vector3(0.9, 0.5, 0.1)}, usePlain: {value: 0}};
    this.group = new L.Group();
    this.makeNetting();
    this.makeRopes();
    this.makeOutline();
    this.makeBalls();
    // Contact with a bed is not a thing to look at, unless somebody asks for it.
    result.parts.forEach((p, i) => { if (p.contact) this.show(i, false); });
  }

  material(vertexShader, fragmentShader, more = {}, options = {}) {
    return new L.RawShaderMaterial({glslVersion: L.GLSL3, vertexShader, fragmentShader, side: L.DoubleSide,
      uniforms: {...this.uniforms, ...more}, ...options});
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

  makeNetting() {
    const {tri, triUV, triPart, parts} = this.result, n = tri.length / 3;
    this.netting = new L.BufferGeometry();
    const twines = new Float32Array(6 * n), part = new Float32Array(3 * n), radius = new Float32Array(3 * n), colour = new Float32Array(9 * n);
    for (let t = 0; t < n; ++t) {
      const of = parts[triPart[t]], a = of.axes, rgb = partColour(triPart[t]);
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
    this.setAttributes(this.netting, {position: [new Float32Array(9 * n), 3], twines: [twines, 2], part: [part, 1],
      halfWidth: [radius, 1], value: [new Float32Array(3 * n).fill(NONE), 1], partColour: [colour, 3]});
    const surface = {hasLines: {value: false}}, lines = {hasLines: {value: true}};
    this.add(this.netting, this.material(NETTING_VERTEX, NETTING_FRAGMENT, lines), 1);
    this.add(this.netting, this.material(NETTING_VERTEX, NETTING_FRAGMENT, surface, {transparent: true, depthWrite: false}), 3);
  }

  setAttributes(geometry, attributes) {
    for (const [name, [array, size]] of Object.entries(attributes)) geometry.setAttribute(name, attribute(array, size));
  }

  /** n squares with four corners each. Not instances of one: software renderers draw those one after another. */
  squares(corners, n, attributes) {
    const geometry = new L.BufferGeometry(), index = new Uint32Array(6 * n), corner = new Float32Array(8 * n);
    for (let i = 0; i < n; ++i) {
      index.set([0, 1, 2, 2, 1, 3].map((k) => 4 * i + k), 6 * i);
      corner.set(corners, 8 * i);
    }
    geometry.setIndex(attribute(index, 1));
    geometry.setAttribute('corner', attribute(corner, 2));
    for (const [name, [array, size]] of Object.entries(attributes)) geometry.setAttribute(name, attribute(fourfold(array, size), size));
    return geometry;
  }

  /** Attributes of bars or dots that never change. */
  ofParts(partOf, fallback) {
    const n = partOf.length, part = new Float32Array(n), radius = new Float32Array(n), colour = new Float32Array(3 * n);
    for (let i = 0; i < n; ++i) {
      part[i] = partOf[i];
      radius[i] = (this.result.parts[partOf[i]].diameter || fallback) / 2;
      colour.set(partColour(partOf[i]), 3 * i);
    }
    return {part: [part, 1], halfWidth: [radius, 1], partColour: [colour, 3], value: [new Float32Array(n).fill(NONE), 1]};
  }

  makeRopes() {
    const n = this.result.bar.length / 2;
    this.ropes = this.squares([0, -1, 1, -1, 0, 1, 1, 1], n,
      {from: [new Float32Array(3 * n), 3], to: [new Float32Array(3 * n), 3], ...this.ofParts(this.result.barPart, 0.01)});
    this.add(this.ropes, this.material(ROPE_VERTEX, ROPE_FRAGMENT, {leastPixels: {value: 1.5}}), 2);
  }

  /** Thin lines round every panel, so that netting is seen where it is gathered to nothing. */
  makeOutline() {
    this.border = outline(this.result);
    const n = this.border.parts.length, same = this.ofParts(this.border.parts, 0);
    same.halfWidth[0].fill(0);
    this.edges = this.squares([0, -1, 1, -1, 0, 1, 1, 1], n, {from: [new Float32Array(3 * n), 3], to: [new Float32Array(3 * n), 3], ...same});
    this.add(this.edges, this.material(ROPE_VERTEX, ROPE_FRAGMENT, {leastPixels: {value: 0.6}}), 2);
  }

  makeBalls() {
    const n = this.result.dot.length;
    this.balls = this.squares([-1, -1, 1, -1, -1, 1, 1, 1], n, {centre: [new Float32Array(3 * n), 3], ...this.ofParts(this.result.dotPart, 0)});
    this.add(this.balls, this.material(BALL_VERTEX, BALL_FRAGMENT, {leastPixels: {value: 3}}), 2);
  }

  /** Moves everything to where the nodes of a state are. */
  move(points) {
    this.points = points;
    const {tri, bar, dot} = this.result;
    this.gather(this.netting.attributes.position, tri, points, 0, 1, 1);
    this.gather(this.ropes.attributes.from, bar, points, 0, 2, 4);
    this.gather(this.ropes.attributes.to, bar, points, 1, 2, 4);
    this.gather(this.edges.attributes.from, this.border.nodes, points, 0, 2, 4);
    this.gather(this.edges.attributes.to, this.border.nodes, points, 1, 2, 4);
    this.gather(this.balls.attributes.centre, dot, points, 0, 1, 4);
  }

  gather(into, nodes, points, first, step, times) {
    const out = into.array;
    for (let i = first, k = 0; i < nodes.length; i += step) {
      const node = 3 * nodes[i];
      for (let copy = 0; copy < times; ++copy) { out[k++] = points[node]; out[k++] = points[node + 1]; out[k++] = points[node + 2]; }
    }
    into.needsUpdate = true;
  }

  /** Colours by one value per cell; null: by part. */
  paint(values) {
    const {triCell, barCell, dotCell} = this.result;
    const put = (target, cells, times) => {
      const out = target.array;
      for (let i = 0; i < cells.length; ++i) {
        const v = values ? values[cells[i]] : 0;
        for (let k = 0; k < times; ++k) out[times * i + k] = Number.isFinite(v) ? v : NONE;
      }
      target.needsUpdate = true;
    };
    put(this.netting.attributes.value, triCell, 3);
    put(this.ropes.attributes.value, barCell, 4);
    put(this.edges.attributes.value, this.border.cells, 4);
    put(this.balls.attributes.value, dotCell, 4);
  }

  show(part, on) {
    this.shown[part] = on ? 255 : 0;
    for (let p = 0; p < this.shown.length; ++p) this.texture.image.data[4 * p] = this.shown[p];
    this.texture.needsUpdate = true;
  }

  /** Corners of the box around the nodes of shown parts, the mirrored half included. */
  box(isCounted = () => true) {
    const lo = [1e30, 1e30, 1e30], hi = [-1e30, -1e30, -1e30];
    const take = (nodes, partOf, times) => {
      for (let i = 0; i < nodes.length; ++i) {
        const part = partOf[Math.floor(i / times)];
        if (!this.shown[part] || !isCounted(part)) continue;
        for (let k = 0; k < 3; ++k) {
          const x = this.points[3 * nodes[i] + k];
          lo[k] = Math.min(lo[k], x); hi[k] = Math.max(hi[k], x);
        }
      }
    };
    take(this.result.tri, this.result.triPart, 3);
    take(this.result.bar, this.result.barPart, 2);
    if (lo[0] > hi[0]) return isCounted(-1) ? [[-1, -1, -1], [1, 1, 1]] : this.box();
    if (this.result.half) {
      const plane = -this.result.origin[1], reach = Math.max(hi[1] - plane, plane - lo[1]);
      lo[1] = plane - reach; hi[1] = plane + reach;
    }
    const corners = [];
    for (const x of [lo[0], hi[0]]) for (const y of [lo[1], hi[1]]) for (const z of [lo[2], hi[2]]) corners.push([x, y, z]);
    return corners;
  }
}

/** A plane of the bed or the surface around the gear. */
function makeGround(corners, heightAt, origin, colour, pixelsPerMetre, opacity) {
  const xs = corners.map((c) => c[0]), ys = corners.map((c) => c[1]);
  const size = Math.max(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys), 1);
  const [x0, x1] = [Math.min(...xs) - size, Math.max(...xs) + size], [y0, y1] = [Math.min(...ys) - size, Math.max(...ys) + size];
  const at = (x, y) => [x, y, heightAt(x + origin[0], y + origin[1]) - origin[2]];
  const geometry = new L.BufferGeometry();
  geometry.setAttribute('position', attribute(new Float32Array([at(x0, y0), at(x1, y0), at(x0, y1), at(x0, y1), at(x1, y0), at(x1, y1)].flat()), 3));
  const mesh = new L.Mesh(geometry, new L.RawShaderMaterial({glslVersion: L.GLSL3, vertexShader: GROUND_VERTEX, fragmentShader: GROUND_FRAGMENT,
    uniforms: {colour: {value: new L.Vector3(...colour)}, offset: {value: new L.Vector3(...origin)}, pixelsPerMetre, opacity: {value: opacity}},
    transparent: true, depthWrite: false, side: L.DoubleSide}));
  mesh.frustumCulled = false;
  mesh.renderOrder = 0;
  return mesh;
}
