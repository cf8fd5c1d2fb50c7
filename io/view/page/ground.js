// SPDX-License-Identifier: BSD-3-Clause
// The bed and the surface: planes with a grid of whole metres around the gear.

const GROUND_COLOURS = {bed: [0.62, 0.53, 0.36], surface: [0.35, 0.6, 0.85]};
const EDGE_ON = 0.02;  // radians

class Ground {
  constructor(model, shared, scene) {
    const {bed} = model.result;
    this.planes = {surface: this.plane(model, shared, () => 0, GROUND_COLOURS.surface)};
    if (bed) this.planes.bed = this.plane(model, shared, (x, y) => bed.slopeX * x + bed.slopeY * y - bed.depth, GROUND_COLOURS.bed);
    scene.add(...Object.values(this.planes));
  }

  plane(model, shared, heightAt, colour) {
    const {origin} = model.result, lo = [Infinity, Infinity], hi = [-Infinity, -Infinity];
    for (const p of model.places(true)) for (let k = 0; k < 2; ++k) { lo[k] = Math.min(lo[k], p[k]); hi[k] = Math.max(hi[k], p[k]); }
    const size = Math.max(hi[0] - lo[0], hi[1] - lo[1], 1), [x0, y0, x1, y1] = [lo[0] - size, lo[1] - size, hi[0] + size, hi[1] + size];
    const at = (x, y) => [x, y, heightAt(x + origin[0], y + origin[1]) - origin[2]];
    const geometry = new L.BufferGeometry();
    setAttributes(geometry, {position: [new Float32Array([at(x0, y0), at(x1, y0), at(x0, y1), at(x0, y1), at(x1, y0), at(x1, y1)].flat()), 3]});
    const mesh = new L.Mesh(geometry, new L.RawShaderMaterial({glslVersion: L.GLSL3, vertexShader: GROUND_VERTEX, fragmentShader: GROUND_FRAGMENT,
      uniforms: {colour: {value: new L.Vector3(...colour)}, offset: {value: new L.Vector3(...origin)}, pixelsPerMetre: shared.common.pixelsPerMetre, opacity: {value: 0.45}},
      transparent: true, depthWrite: false, side: L.DoubleSide}));
    mesh.frustumCulled = false;
    mesh.renderOrder = 0;
    mesh.corners = [at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1)];
    return mesh;
  }

  /** Seen from its edge a plane is a line. */
  drawEdges(svg, camera) {
    if (Math.abs(camera.elevation) > EDGE_ON) return;
    for (const [name, plane] of Object.entries(this.planes)) {
      if (!plane.visible) continue;
      const outline = plane.corners.map((c) => camera.project(c)).map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`);
      svg.append(svgElement('path', {d: `M${outline.join('L')}Z`, class: name}));
    }
  }

  show(name, on) {
    if (this.planes[name]) this.planes[name].visible = on;
  }
}
