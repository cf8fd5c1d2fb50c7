// SPDX-License-Identifier: BSD-3-Clause
// A parallel projection that turns about a point. Lengths across the line of sight have the same scale
// everywhere.

const dot3 = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

class OrbitCamera {
  /** `views`: {name: {azimuth, elevation}} in degrees. */
  constructor(views) {
    this.camera = new Libraries.OrthographicCamera(-1, 1, 1, -1, -1e5, 1e5);
    this.views = views;
    this.target = [0, 0, 0];
    this.width = this.height = 1;
    this.pixelsPerMetre = 1;
    this.look('oblique');
  }
  look(name) {
    this.azimuth = this.views[name].azimuth * Math.PI / 180;
    this.elevation = this.views[name].elevation * Math.PI / 180;
  }
  /** Unit vectors to the right, upwards and towards the eye. */
  axes() {
    const ca = Math.cos(this.azimuth), sa = Math.sin(this.azimuth);
    const ce = Math.cos(this.elevation), se = Math.sin(this.elevation);
    return {right: [-sa, ca, 0], up: [-se * ca, -se * sa, ce], eye: [ce * ca, ce * sa, se]};
  }
  resize(width, height) {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
  }
  /** All points fill the window but for a margin [pixels] on each side: {left, right, top, bottom}. Returns the scale. */
  fit(points, margin, most = Infinity) {
    const {right, up, eye} = this.axes(), lo = [Infinity, Infinity, Infinity], hi = [-Infinity, -Infinity, -Infinity];
    for (const p of points)
      [right, up, eye].forEach((axis, i) => {
        const at = dot3(p, axis);
        lo[i] = Math.min(lo[i], at); hi[i] = Math.max(hi[i], at);
      });
    if (lo[0] > hi[0]) return this.pixelsPerMetre;
    const width = Math.max(50, this.width - margin.left - margin.right), height = Math.max(50, this.height - margin.top - margin.bottom);
    this.pixelsPerMetre = Math.min(most, width / Math.max(hi[0] - lo[0], 1e-3), height / Math.max(hi[1] - lo[1], 1e-3));
    const middle = [0, 1, 2].map((i) => (lo[i] + hi[i]) / 2);
    middle[0] -= (margin.left - margin.right) / 2 / this.pixelsPerMetre;
    middle[1] += (margin.top - margin.bottom) / 2 / this.pixelsPerMetre;
    this.target = [0, 1, 2].map((i) => middle[0] * right[i] + middle[1] * up[i] + middle[2] * eye[i]);
    return this.pixelsPerMetre;
  }
  turn(dx, dy) {
    this.azimuth -= dx;
    this.elevation = Math.min(Math.max(this.elevation + dy, -Math.PI / 2), Math.PI / 2);
  }
  pan(dx, dy) {
    const {right, up} = this.axes();
    this.target = this.target.map((t, i) => t + (-dx * right[i] + dy * up[i]) / this.pixelsPerMetre);
  }
  /** Zooms so that the point under (x, y) pixels stays where it is. */
  zoom(factor, x = this.width / 2, y = this.height / 2) {
    const wanted = Math.min(Math.max(this.pixelsPerMetre * factor, 1e-3), 1e6);
    const dx = x - this.width / 2, dy = y - this.height / 2;
    this.pan(-dx, -dy);
    this.pixelsPerMetre = wanted;
    this.pan(dx, dy);
  }
  apply() {
    const {up, eye} = this.axes(), c = this.camera, s = 2 * this.pixelsPerMetre;
    c.left = -this.width / s; c.right = this.width / s; c.top = this.height / s; c.bottom = -this.height / s;
    c.up.set(...up);
    c.position.set(...this.target.map((t, i) => t + eye[i]));
    c.lookAt(...this.target);
    c.updateProjectionMatrix();
    c.updateMatrixWorld();
  }
  /** Pixels from the upper left corner, and the distance towards the eye. */
  project(p) {
    const {right, up, eye} = this.axes(), d = p.map((v, i) => v - this.target[i]);
    return [this.width / 2 + dot3(d, right) * this.pixelsPerMetre, this.height / 2 - dot3(d, up) * this.pixelsPerMetre, dot3(d, eye)];
  }
}
