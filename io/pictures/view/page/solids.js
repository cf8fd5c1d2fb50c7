// SPDX-License-Identifier: BSD-3-Clause
// Boards and other rigid bodies, drawn as plates in place of their node, and a symbol for the ship, which is
// not a part of the gear.

class Solids {
  constructor(model) {
    Object.assign(this, {model, plates: null, hulls: null});
  }

  makePlates() {
    const {result, colours} = this.model, {plateDot, dotPart} = result, n = plateDot.length;
    const part = new Float32Array(3 * n), colour = new Float32Array(9 * n);
    plateDot.forEach((dot, t) => { part.fill(dotPart[dot], 3 * t, 3 * t + 3); for (let k = 0; k < 3; ++k) colour.set(colours.ofPart(dotPart[dot]), 9 * t + 3 * k); });
    this.plates = new L.BufferGeometry();
    setAttributes(this.plates, {position: [new Float32Array(9 * n), 3], part: [part, 1], partColour: [colour, 3], value: [new Float32Array(3 * n).fill(NONE), 1]});
    const own = {noValue: {value: new L.Vector3(...colours.body)}};
    this.model.add(this.plates, this.model.material('point', PLATE_VERTEX, PLATE_FRAGMENT, own), 1);
  }

  makeHulls(count) {
    const {section, eye} = this.model.shared.common;
    this.hulls = new L.BufferGeometry();
    setAttributes(this.hulls, {position: [new Float32Array(count), 3], plane: [new Float32Array(count), 3]});
    this.model.add(this.hulls, new L.RawShaderMaterial({glslVersion: L.GLSL3, vertexShader: SOLID_VERTEX, fragmentShader: SOLID_FRAGMENT, side: L.DoubleSide,
      uniforms: {section, eye, colour: {value: new L.Vector3(...this.model.colours.ship)}}}), 1);
  }

  move({plates, hulls}) {
    if (plates.length && !this.plates) this.makePlates();
    if (hulls.length && !this.hulls) this.makeHulls(hulls.length);
    for (const [shape, corners] of [[this.plates, plates], [this.hulls, hulls]]) {
      if (!shape) continue;
      shape.attributes.position.array.set(corners);
      shape.attributes.position.needsUpdate = true;
    }
    Object.assign(this, {corners: plates, hullCorners: hulls});
  }

  /** `valueAt`: of a single node. */
  paint(valueAt) {
    const {plateDot} = this.model.result;
    if (this.plates) putValues(this.plates.attributes.value, plateDot.length, (t) => valueAt(plateDot[t]), 3);
  }

  /** Corners of triangle t of the plates, or of the hull. */
  at(corners, t, mirrored) {
    const y0 = this.model.result.origin[1];
    return [0, 1, 2].map((c) => { const [x, y, z] = corners.subarray(9 * t + 3 * c, 9 * t + 3 * c + 3); return [x, mirrored ? -2 * y0 - y : y, z]; });
  }

  /** Corners of the plates, and of the hulls if `withShip`. */
  * places(withShip) {
    const {result, shown} = this.model;
    for (const mirrored of result.half ? [false, true] : [false]) {
      for (let t = 0; t < result.plateDot.length; ++t) if (shown[result.dotPart[result.plateDot[t]]]) yield* this.at(this.corners, t, mirrored);
      for (let t = 0; withShip && 9 * t < this.hullCorners.length; ++t) yield* this.at(this.hullCorners, t, mirrored);
    }
  }
}
