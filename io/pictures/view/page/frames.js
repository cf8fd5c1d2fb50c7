// SPDX-License-Identifier: BSD-3-Clause
// The slider over the times of a motion, the stages of a solve, or the results of a sweep, and the figures
// that it changes.

class Frames {
  constructor(viewer, results) {
    Object.assign(this, {viewer, results});
    this.isSweep = results.length > 2;
    this.all = this.isSweep ? results.map((r, i) => ({model: i, state: r.states.length - 1})) : results[0].states.map((_, state) => ({model: 0, state}));
    this.index = this.all.length - 1;
    $('time').hidden = this.all.length < 2;
    $('frame').max = String(this.all.length - 1);
    $('frame').addEventListener('input', () => viewer.showFrame(Number($('frame').value)));
    $('play').addEventListener('click', () => this.play());
  }

  get current() { return this.all[this.index]; }

  /** The state of each result that is shown with a frame. */
  statesAt(index) {
    const frame = this.all[index];
    return this.results.map((result, i) => (i === frame.model ? frame.state : Math.min(frame.state, result.states.length - 1)));
  }

  play() {
    const wasPlaying = Boolean(this.timer), n = this.all.length;
    clearInterval(this.timer);
    this.timer = null;
    $('play').textContent = wasPlaying ? 'Play' : 'Stop';
    if (!wasPlaying) this.timer = setInterval(() => this.viewer.showFrame((this.index + 1) % n), Math.max(40, 4000 / n));
  }

  label() {
    const result = this.results[this.current.model];
    if (this.isSweep) return result.varied || result.file;
    if (result.stages) return `${this.current.state + 1} of ${result.states.length}: ${result.stages[this.current.state]}`;
    return result.motion ? `${formatNumber(result.times[this.current.state])} s` : `state ${this.current.state + 1} of ${result.states.length}`;
  }

  describe() {
    $('when').textContent = this.label();
    $('frame').value = String(this.index);
    $('frame').setAttribute('aria-valuetext', this.label());
    for (const box of document.querySelectorAll('#keys [data-figure]')) this.fill(box);
  }

  /** A key figure at this frame, where it is known: of a sweep each result's own, of a motion from its series. */
  fill(box) {
    const result = this.results[this.current.model], name = box.dataset.figure;
    const series = result.series.find((s) => s.name === name || s.name === `gear/${name}`);
    const figure = result.figures.find((f) => f.name === name);
    if (this.isSweep && figure) box.textContent = figure.text;
    if (!this.isSweep && series && result.motion) box.textContent = shortText(series.values[this.current.state], series.unit);
  }
}
