// SPDX-License-Identifier: BSD-3-Clause
// Curves: quantities over the frames, and the residual over the steps of the solve. A click shows the frame
// at that place.

/** {name, unit, x, y, over, log, goesTo}: what can be drawn; `goesTo`: points are frames. */
function curveChoices(results, isSweep) {
  const first = results[0], choices = [];
  if (isSweep) {
    const x = results.map((r, i) => (Number.isFinite(r.variedBy) ? r.variedBy : i)), over = Number.isFinite(first.variedBy) ? first.variedName : 'number of the result';
    for (const figure of first.figures) {
      const y = results.map((r) => (r.figures.find((f) => f.name === figure.name) || {value: NaN}).value);
      choices.push({name: figure.name, unit: figure.unit, x, y, over, goesTo: true});
    }
  } else {
    for (const series of first.series) choices.push({name: series.name, unit: series.unit, x: first.times, y: series.values, over: 'time [s]', goesTo: true});
  }
  const {residual} = first.convergence;
  if (residual.length > 1) choices.push({name: 'residual of the solve', unit: 'N', x: residual.map((_, i) => i), y: residual, over: 'accepted step', log: true});
  return choices;
}

class Curves {
  constructor(viewer, results, frames) {
    Object.assign(this, {viewer, frames, choices: curveChoices(results, frames.isSweep)});
    $('curve-box').hidden = this.choices.length === 0;
    if (!this.choices.length) return;
    const keys = [...document.querySelectorAll('#keys [data-figure]')].map((box) => box.dataset.figure);
    // the key figures at the top of the page come first
    const rank = (name) => (keys.indexOf(name.replace(/^gear\//, '')) + keys.length + 1) % (keys.length + 1);
    const inOrder = this.choices.map((c, i) => ({i, key: rank(c.name)})).sort((a, b) => a.key - b.key);
    $('quantity').replaceChildren(...inOrder.map(({i}) => element('option', {value: String(i)}, words(this.choices[i].name.replace(/^gear\//, '')))));
    $('quantity').addEventListener('change', () => this.draw());
    this.draw();
  }

  draw() {
    if (!this.choices.length) return;
    const choice = this.choices[Number($('quantity').value)], box = $('curve');
    box.replaceChildren();
    this.shown = choice;
    this.plot = new L.uPlot(this.options(choice, box), [choice.x, choice.y.map((v) => (Number.isFinite(v) && !(choice.log && v <= 0) ? v : null))], box);
    this.plot.over.addEventListener('click', () => { if (choice.goesTo && this.plot.cursor.idx !== null) this.viewer.showFrame(this.plot.cursor.idx); });
  }

  options(choice, box) {
    const ink = styleColour('--ink'), grid = {stroke: styleColour('--line'), width: 1}, ticks = {stroke: styleColour('--line'), width: 1, size: 4};
    const isPower = (v) => v > 0 && Math.abs(Math.log10(v) - Math.round(Math.log10(v))) < 1e-9;
    // A logarithmic axis has labels at powers of ten only, and not at all of them if there are many.
    const everyDecade = Math.max(1, Math.ceil(Math.log10(Math.max(...choice.y) / Math.min(...choice.y.filter((v) => v > 0))) / 5));
    const powers = (_, values) => values.map((v) => (isPower(v) && Math.round(Math.log10(v)) % everyDecade === 0 ? v : null));
    const axis = {stroke: ink, grid, ticks, font: '11px system-ui, sans-serif', labelFont: '12px system-ui, sans-serif'};
    return {
      width: Math.max(200, box.clientWidth), height: 190, legend: {show: false}, cursor: {y: false},
      scales: {x: {time: false}, y: {distr: choice.log ? 3 : 1}},
      axes: [{...axis, label: choice.over, labelSize: 18, size: 26, values: (_, values) => values.map((v) => formatNumber(v, 3))},
        {...axis, size: 56, label: unitText(choice.unit), labelSize: choice.unit === '1' ? 0 : 18,
          ...(choice.log ? {filter: powers, grid: {...grid, filter: powers}, ticks: {...ticks, filter: powers}} : {}),
          values: (_, values) => values.map((v) => (v === null ? '' : choice.log ? `1e${Math.round(Math.log10(v))}` : formatNumber(v, 3)))}],
      series: [{}, {stroke: styleColour('--curve'), width: 2, points: {show: choice.x.length < 40, size: 6}}],
      hooks: {draw: [(plot) => this.mark(plot)]},
    };
  }

  /** A line where the frame is. */
  mark(plot) {
    if (!this.shown.goesTo) return;
    const x = Math.round(plot.valToPos(this.shown.x[this.frames.index], 'x', true)), g = plot.ctx;
    g.save();
    g.strokeStyle = styleColour('--mark');
    g.lineWidth = 2;
    g.beginPath();
    g.moveTo(x, plot.bbox.top);
    g.lineTo(x, plot.bbox.top + plot.bbox.height);
    g.stroke();
    g.restore();
  }

  showFrame() {
    if (this.plot && this.shown.goesTo) this.plot.redraw(false);
  }
}
