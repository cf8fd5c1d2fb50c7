// SPDX-License-Identifier: BSD-3-Clause
// The choices of colouring: fields of the results, the part, and the distance between two results.

const BY_PART = 'part', BY_MOVE = 'move';
const LABELS = {water_force: 'force of the water', normal_force: 'force of the bed', contact: 'contact of knots'};

class Fields {
  constructor(models) {
    this.models = models;
    this.second = models.length === 2 ? models[1] : null;
    this.choices = this.list();
  }

  get first() { return this.models[0]; }

  list() {
    const own = this.first.result.fields.filter((f) => !f.total).map((f) => ({...f, label: LABELS[f.name] || words(f.name)}));
    const choices = [...own, {name: BY_PART, label: 'part', units: ['1', '1', '1'], doc: 'the part of the gear'}];
    if (!this.second) return choices;
    const changes = own.filter((f) => this.second.result.fields.some((g) => g.name === f.name))
      .map((f) => ({name: `change of ${f.name}`, of: f.name, label: `change of ${f.label}`, units: f.units, doc: `in the second result less in the first: ${f.doc}`}));
    return [{name: BY_MOVE, label: 'distance between the two', units: ['m', 'm', 'm'], doc: 'how far a place moved from the first result to the second'}, ...choices, ...changes];
  }

  find(name) { return this.choices.find((f) => f.name === name) || this.choices[0]; }

  /** Whether its values compare the cells of the first result with those of the second. */
  isOfPairs(field) { return field.name === BY_MOVE || Boolean(field.of); }

  /** Values by cell of a model; null: by part. */
  values(field, model) {
    if (field.name === BY_PART) return null;
    if (field.name === BY_MOVE) return this.overPairs((pair) => this.distance(pair));
    if (field.of) return this.overPairs((pair, cell) => this.stored(field.of, this.second)[pair.cell] - this.stored(field.of, this.first)[cell]);
    return this.stored(field.name, model);
  }

  stored(name, model) {
    const at = model.result.fields.findIndex((f) => f.name === name);
    return at < 0 ? new Float32Array(0) : model.state.fields[at];
  }

  overPairs(valueOf) {
    this.pairs = this.pairs || pairCells(this.first.result, this.second.result);
    return Float32Array.from(this.pairs, (pair, cell) => (pair ? valueOf(pair, cell) : NaN));
  }

  /** The mean over the corners of a cell. */
  distance({nodes, others}) {
    const a = this.first, b = this.second, place = (model, {nodes: of, weights}, d) =>
      of.reduce((sum, n, i) => sum + weights[i] * (model.points[3 * n + d] + model.result.origin[d]), 0);
    return nodes.reduce((sum, node, i) => sum + Math.hypot(...[0, 1, 2].map((d) => place(a, {nodes: [node], weights: [1]}, d) - place(b, others[i], d))), 0) / nodes.length;
  }

  /** Scales of netting, ropes and single nodes, the same for all states and all results; null where there are no values. */
  scales(field, values, log) {
    if (field.name === BY_PART) return [null, null, null];
    if (field.name === BY_MOVE) return this.oneScale(values);
    if (!field.linear) return CELLS.map((c) => this.scaleOfValues(field, values, c));
    return CELLS.map((_, kind) => {
      const all = this.models.map((m) => m.result.fields.find((f) => f.name === field.name)).map((f) => f && f[log ? 'log' : 'linear'][kind]).filter(Boolean);
      if (!all.length) return null;
      const join = (pick, of) => of(...all.map(pick));
      return new Scale({lo: join((s) => s.lo, Math.min), hi: join((s) => s.hi, Math.max), below: all.some((s) => s.below), above: all.some((s) => s.above)}, log);
    });
  }

  /** A distance is a distance, of whatever kind the cell is. */
  oneScale(values) {
    const hi = values.reduce((most, v) => (v > most ? v : most), 0), scale = new Scale({lo: 0, hi}, false);
    return CELLS.map((c) => (this.first.result[c.cells].some((cell) => Number.isFinite(values[cell])) ? scale : null));
  }

  /** Of what is found here: from the least to the largest value; a change is as far below zero as above. */
  scaleOfValues(field, values, c) {
    let lo = Infinity, hi = -Infinity;
    for (const cell of this.first.result[c.cells]) if (Number.isFinite(values[cell])) { lo = Math.min(lo, values[cell]); hi = Math.max(hi, values[cell]); }
    if (lo > hi) return null;
    const most = Math.max(Math.abs(lo), Math.abs(hi));
    return field.of ? new Scale({lo: -most, hi: most}, false) : new Scale({lo: 0, hi}, false);
  }
}
