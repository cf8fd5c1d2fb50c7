// SPDX-License-Identifier: BSD-3-Clause
// What is drawn where: one picture, or two results beside each other, at one scale and seen from the same side.

const NOWHERE = [0, 0, 0];

class Panes {
  constructor(viewer) {
    Object.assign(this, {viewer, width: 1, height: 1, shifts: [NOWHERE, NOWHERE]});
  }

  get areTwo() { return Boolean(this.viewer.second) && $('overlay').value === 'beside'; }

  /** `shift`: where the middle of this gear is, from the middle of the first one, each from its origin [m]. */
  get list() {
    if (!this.areTwo) return [{index: 0, model: this.viewer.model, left: 0, width: this.width, shift: NOWHERE}];
    const width = this.width / 2;
    return this.viewer.models.map((model, index) => ({index, model, left: index * width, width, shift: this.shifts[index]}));
  }

  /** The picture under a place of the window. */
  at(x) { return this.list.reverse().find((pane) => x >= pane.left || pane.index === 0); }

  resize({width, height}) {
    Object.assign(this, {width: Math.max(1, width), height: Math.max(1, height)});
    this.viewer.camera.resize(this.list[0].width, height);
  }

  /** Does something while the camera looks at the gear of a pane. */
  within({shift}, work) {
    const {camera} = this.viewer, {target} = camera;
    camera.target = target.map((v, d) => v + shift[d]);
    try { return work(); } finally { camera.target = target; }
  }

  /** Every gear fills its pane, all at the scale of the largest. */
  fit(extent, legend) {
    const {camera} = this.viewer, panes = this.list;
    const all = panes.map((pane) => [...pane.model.places(extent)]), margins = panes.map((pane, i) => this.margin(all[i], pane.index === 0 && legend));
    const scale = Math.min(...all.map((points, i) => camera.fit(points, margins[i])));
    const targets = all.map((points, i) => { camera.fit(points, margins[i], scale); return camera.target; });
    if (this.areTwo) this.shifts = targets.map((target) => target.map((v, d) => v - targets[0][d]));
    [camera.target] = targets;
  }

  /** Beside or below the legend where that would cover the gear. */
  margin(points, legend) {
    const {camera} = this.viewer;
    if (!legend) return MARGIN;
    camera.fit(points, MARGIN);
    const [right, bottom] = [legend.offsetLeft + legend.offsetWidth, legend.offsetTop + legend.offsetHeight];
    if (!points.some((p) => { const [x, y] = camera.project(p); return x < right && y < bottom; })) return MARGIN;
    const [beside, below] = [{...MARGIN, left: right + GAP}, {...MARGIN, top: bottom + GAP}];
    return camera.fit(points, beside) > camera.fit(points, below) ? beside : below;
  }

  /** An element over the pane that hides what reaches beyond it, with the name of its result if there are two. */
  over(svg, {index, left, width}) {
    if (!this.areTwo) return svg;
    const own = svgElement('svg', {x: left, y: 0, width, height: this.height});
    svg.append(own);
    if (index) own.append(svgElement('path', {d: `M0 0v${this.height}`, class: 'dimension'}));
    const {varied, file} = this.viewer.results[index];
    own.append(svgElement('text', {x: width - 10, y: this.height - 14, 'text-anchor': 'end', class: 'dimension'}, varied || file));
    return own;
  }
}
