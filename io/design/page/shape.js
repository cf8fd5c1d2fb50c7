// SPDX-License-Identifier: BSD-3-Clause
// The shape in the picture: the last equilibrium, or the shape that a tangent predicts from it for another
// value of a number.

class Shape {
  constructor(server) {
    Object.assign(this, {server, viewer: null, points: null, figures: [], tangents: new Map(), timesOfGhosts: [], beside: [], turn: Promise.resolve()});
  }

  /** Pictures are replaced one after another. */
  inTurn(work) {
    this.turn = this.turn.catch(() => {}).then(work);
    return this.turn;
  }

  /** The viewer, once there is a picture; null without WebGL. */
  showPicture(data) { return this.inTurn(() => this.takePicture(data)); }

  /** Shows another gear beside this one, `name` below it; null: none. */
  showBeside(picture, name) {
    return this.inTurn(async () => {
      this.beside = picture ? [Object.assign(await decodeResult(picture.results[0]), {file: name})] : [];
      if (!this.viewer) return;
      await this.viewer.replace([this.viewer.results[0], ...this.beside]);
      this.putBeside();
      if (this.points) this.show(this.points);
    });
  }

  putBeside() {
    if (!this.beside.length) return;
    $('overlay').value = 'beside';
    $('overlay').dispatchEvent(new Event('change'));
  }

  async takePicture(data) {
    const results = [Object.assign(await decodeResult(data.results[0]), {file: 'this one'}), ...this.beside];
    if (this.viewer) { await this.viewer.replace(results); return; }
    $('app').hidden = false;
    try {
      this.viewer = new Viewer(data.style, results);
    } catch (error) {
      $('app').hidden = true;
      $('status').textContent = 'This browser does not draw in three dimensions (WebGL is switched off or missing). The plan, the numbers and the report do not need it.';
      $('status').hidden = false;
      this.isFlat = true;
      return;
    }
    await this.viewer.start();
    this.putBeside();
    this.viewer.drawNow();
    window.netloftViewer = this.viewer;
    this.viewer.canvas.addEventListener('selected', (event) => { if (event.detail && this.onPart) this.onPart(event.detail, this.placeSelected()); });
  }

  /** Where the selected element is, on the starboard side [m]. */
  placeSelected() {
    const {hit, model} = this.viewer.selection, {origin} = model.result;
    return placeOfHit(model, {...hit, mirrored: false}).map((v, d) => v + origin[d]);
  }

  /** Takes over an equilibrium. */
  async take(outcome) {
    this.points = await decodeArray(outcome.points);
    this.figures = outcome.figures;
    this.tangents.clear();
    this.fitsPicture = outcome.same_mesh;
    this.setGrey(false);
    this.show(this.points);
  }

  show(points) {
    if (this.viewer && points.length === 3 * this.viewer.result.nPoints) this.viewer.showPoints(points);
  }

  /** What did not converge leaves the last shape, in grey. */
  setGrey(isGrey) {
    if (!this.viewer) return;
    this.viewer.model.uniforms.usePlain.value = isGrey ? 1 : 0;
    this.viewer.draw();
  }

  /** Asks for the tangent of a number, once for each equilibrium. */
  prepare(path) {
    if (!this.points) return Promise.resolve(null);
    if (!this.tangents.has(path)) this.tangents.set(path, this.ask(path, this.points));
    return this.tangents.get(path);
  }

  async ask(path, points) {
    try {
      const found = await this.server.ask('jvp', {path});
      if (found.motion) found.motion = await decodeArray(found.motion);
      // If a new equilibrium has arrived in the meantime, this tangent does not belong to it.
      return points === this.points ? found : null;
    } catch (error) {
      return null;
    }
  }

  /** Shows where the tangent leads: the ghost. Returns its figures; null without a tangent. */
  async ghost(path, value) {
    const tangent = await this.prepare(path);
    if (!tangent || !tangent.motion) return null;
    const begin = performance.now(), by = value - tangent.value, {points} = this, {motion} = tangent;
    const moved = new Float32Array(points.length);
    for (let i = 0; i < points.length; ++i) moved[i] = points[i] + by * motion[i];
    this.show(moved);
    if (this.viewer) this.viewer.drawNow();
    this.timesOfGhosts.push(performance.now() - begin);
    return this.figures.map((f) => ({...f, value: f.value === null ? null : f.value + by * (tangent.slopes[f.name] ?? NaN)}));
  }
}
