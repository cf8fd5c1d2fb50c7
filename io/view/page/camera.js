// SPDX-License-Identifier: BSD-3-Clause
// A parallel projection that turns about a point: lengths across the line of sight are to scale everywhere.

const VIEWS = {
  side: {azimuth: -90, elevation: 0},
  top: {azimuth: -90, elevation: 90},
  front: {azimuth: 180, elevation: 0},
  oblique: {azimuth: -140, elevation: 25},
};

class OrbitCamera {
  constructor() {
    this.camera = new Libraries.OrthographicCamera(-1, 1, 1, -1, -1e5, 1e5);
    this.target = [0, 0, 0];
    this.width = this.height = 1;
    this.pixelsPerMetre = 1;
    this.look('oblique');
  }
  look(name) {
    this.azimuth = VIEWS[name].azimuth * Math.PI / 180;
    this.elevation = VIEWS[name].elevation * Math.PI / 180;
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
  /** The extent of points (3 numbers each) on the screen fills it but for a margin. */
  fit(boxCorners) {
    const {right, up, eye} = this.axes();
    const range = (axis) => {
      const all = boxCorners.map((p) => p[0] * axis[0] + p[1] * axis[1] + p[2] * axis[2]);
      return [Math.min(...all), Math.max(...all)];
    };
    const [r, u, e] = [right, up, eye].map(range);
    const middle = [r, u, e].map(([lo, hi]) => (lo + hi) / 2);
    this.target = [0, 1, 2].map((i) => middle[0] * right[i] + middle[1] * up[i] + middle[2] * eye[i]);
    this.pixelsPerMetre = 0.86 * Math.min(this.width / Math.max(r[1] - r[0], 1e-3), this.height / Math.max(u[1] - u[0], 1e-3));
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
    const {right, up, eye} = this.axes();
    const d = p.map((v, i) => v - this.target[i]);
    const along = (axis) => d[0] * axis[0] + d[1] * axis[1] + d[2] * axis[2];
    return [this.width / 2 + along(right) * this.pixelsPerMetre, this.height / 2 - along(up) * this.pixelsPerMetre, along(eye)];
  }
}
