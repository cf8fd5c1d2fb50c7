// SPDX-License-Identifier: BSD-3-Clause
// The bed and the surface around the gear, with lines at whole metres.

const GROUND_COLOURS = {bed: [0.62, 0.53, 0.36], surface: [0.35, 0.6, 0.85]};
const EDGE_ON = 0.02;  // radians

/** Height of the bed at a place, from the grid of heights around the gear. */
function bedHeight({x, y, places, heights}, px, py) {
  const along = (range, p) => { const at = (places - 1) * (p - range[0]) / (range[1] - range[0]), k = Math.min(Math.max(Math.floor(at), 0), places - 2); return [k, at - k]; };
  const [i, s] = along(x, px), [j, t] = along(y, py), h = (a, b) => heights[a * places + b];
  return (1 - s) * ((1 - t) * h(i, j) + t * h(i, j + 1)) + s * ((1 - t) * h(i + 1, j) + t * h(i + 1, j + 1));
}

class Ground {
  constructor(model, shared, scene) {
    const {ground} = model.result;
    this.planes = {surface: this.plane(model, shared, 2, () => 0, GROUND_COLOURS.surface)};
    if (ground.heights) this.planes.bed = this.plane(model, shared, ground.places, (i, j) => ground.heights[i * ground.places + j], GROUND_COLOURS.bed);
    scene.add(...Object.values(this.planes));
  }

  dispose() {
    for (const mesh of Object.values(this.planes)) { mesh.geometry.dispose(); mesh.material.dispose(); mesh.removeFromParent(); }
  }

  /** A grid of heights over the region around the gear. */
  plane(model, shared, places, heightAt, colour) {
    const {origin, ground: {x, y}} = model.result, n = places - 1;
    const at = (i, j) => [x[0] + (x[1] - x[0]) * i / n - origin[0], y[0] + (y[1] - y[0]) * j / n - origin[1], heightAt(i, j) - origin[2]];
    const corners = [];
    for (let i = 0; i < n; ++i) for (let j = 0; j < n; ++j) corners.push(...[[0, 0], [1, 0], [0, 1], [0, 1], [1, 0], [1, 1]].flatMap(([a, b]) => at(i + a, j + b)));
    const geometry = new L.BufferGeometry();
    setAttributes(geometry, {position: [new Float32Array(corners), 3]});
    const mesh = new L.Mesh(geometry, new L.RawShaderMaterial({glslVersion: L.GLSL3, vertexShader: GROUND_VERTEX, fragmentShader: GROUND_FRAGMENT,
      uniforms: {colour: {value: new L.Vector3(...colour)}, offset: {value: new L.Vector3(...origin)}, pixelsPerMetre: shared.common.pixelsPerMetre, opacity: {value: 0.45}},
      transparent: true, depthWrite: false, side: L.DoubleSide}));
    mesh.frustumCulled = false;
    mesh.renderOrder = 0;
    mesh.corners = n === 1 ? [at(0, 0), at(1, 0), at(1, 1), at(0, 1)] : [];
    return mesh;
  }

  /** Seen from its edge a plane is a line. */
  drawEdges(svg, camera) {
    if (Math.abs(camera.elevation) > EDGE_ON) return;
    for (const [name, plane] of Object.entries(this.planes)) {
      if (!plane.visible || !plane.corners.length) continue;
      const outline = plane.corners.map((c) => camera.project(c)).map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`);
      svg.append(svgElement('path', {d: `M${outline.join('L')}Z`, class: name}));
    }
  }

  show(name, on) {
    if (this.planes[name]) this.planes[name].visible = on;
  }
}
