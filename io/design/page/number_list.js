// SPDX-License-Identifier: BSD-3-Clause
// The numbers of the scene as sliders and fields, grouped by the tables of the file.

const REACH_OF_SLIDER = 0.5;  // range of a slider on either side of the number, as a fraction of the number
const STEPS_OF_SLIDER = 400;  // about one step per pixel

/** The table of a number: "panels.top-wing" of panels.top-wing.fore[0].meshes. */
function tableOf(path) {
  const steps = path.match(/(?:[^.[\]"]|"[^"]*")+|\[\d+\]/g) || [path];
  return steps.length > 2 ? `${steps[0]}${steps[1].startsWith('[') ? '' : '.'}${steps[1]}` : steps[0];
}

/** The ends and the step of the slider of a number. */
function rangeOf(number) {
  const size = Math.abs(number.value) || 1, least = number.least ?? -Infinity, largest = number.largest ?? Infinity;
  const reach = number.whole ? Math.max(1, Math.round(REACH_OF_SLIDER * size)) : REACH_OF_SLIDER * size;
  const step = number.whole ? 1 : roundBelow(2 * reach / STEPS_OF_SLIDER);
  const lo = Math.max(least, number.value - reach), hi = Math.min(largest, number.value + reach);
  return {min: Math.ceil(lo / step - 1e-9) * step, max: Math.floor(hi / step + 1e-9) * step, step};
}

/** A number without the digits that a slider's arithmetic adds. */
function tidy(value) {
  return Number(value.toPrecision(12));
}

class NumberList {
  /** `onMove(path, value, isMoving)` is called when somebody moves a number, `onTouch(path)` before. */
  constructor(box, onMove, onTouch) {
    Object.assign(this, {box, onMove, onTouch, rows: new Map(), start: new Map()});
    $('filter').addEventListener('input', () => this.filter($('filter').value));
    $('all-numbers').addEventListener('click', () => { $('filter').value = ''; this.filter(''); });
  }

  /** Shows these numbers. Sliders that are there stay, so that one that is held is not lost. */
  show(numbers) {
    const paths = numbers.map((n) => n.path).join('\n');
    this.numbers = numbers;
    if (paths === this.paths) { numbers.forEach((n) => this.update(n)); return; }
    this.paths = paths;
    this.rows.clear();
    const tables = new Map();
    for (const number of numbers) {
      const table = tableOf(number.path);
      if (!tables.has(table)) tables.set(table, []);
      tables.get(table).push(number);
    }
    this.box.replaceChildren(...[...tables].map(([table, some]) => this.table(table, some)));
    this.filter($('filter').value);
  }

  table(name, numbers) {
    const details = element('details', {'data-table': name});
    details.append(element('summary', {}, name), ...numbers.map((n) => this.row(n, name)));
    return details;
  }

  row(number, table) {
    const row = element('div', {class: 'one-number', 'data-path': number.path}), id = `number-${number.path}`;
    const short = number.path === table ? table : number.path.slice(table.length).replace(/^\./, '');
    const label = element('label', {for: id, title: `${number.path}, ${number.file || ''}:${number.line}`}, short);
    const field = element('input', {type: 'number', id, step: 'any'});
    const slider = element('input', {type: 'range', 'aria-label': `${number.path}${number.unit ? `, in ${number.unit}` : ''}`});
    row.append(label, field, element('span', {class: 'unit'}, number.unit), slider);
    if (number.doc) row.append(element('span', {class: 'doc'}, number.doc));
    this.rows.set(number.path, {row, field, slider, number});
    if (!this.start.has(number.path)) this.start.set(number.path, number.value);
    for (const act of ['pointerdown', 'focus']) slider.addEventListener(act, () => this.onTouch(number.path));
    slider.addEventListener('input', () => this.moved(number.path, tidy(Number(slider.value)), true));
    slider.addEventListener('change', () => this.moved(number.path, tidy(Number(slider.value)), false));
    field.addEventListener('change', () => { if (field.value !== '') this.moved(number.path, Number(field.value), false); });
    this.update(number);
    return row;
  }

  moved(path, value, isMoving) {
    const {field, slider, row} = this.rows.get(path);
    if (document.activeElement !== field) field.value = String(value);
    if (document.activeElement !== slider) slider.value = String(value);
    row.classList.toggle('moved', value !== this.start.get(path));
    this.onMove(path, value, isMoving);
  }

  /** Takes over the value of the text, unless somebody moves that number now. */
  update(number) {
    const of = this.rows.get(number.path);
    if (!of) return;
    of.number = number;
    of.row.classList.toggle('moved', number.value !== this.start.get(number.path));
    const isHeld = document.activeElement === of.slider;
    if (!isHeld || Number(of.slider.min) > number.value || Number(of.slider.max) < number.value) {
      const range = rangeOf(number);
      for (const [name, value] of Object.entries(range)) of.slider.setAttribute(name, String(tidy(value)));
      of.slider.disabled = !(range.max > range.min);
      if (!isHeld) of.slider.value = String(number.value);
    }
    if (document.activeElement !== of.field) of.field.value = String(number.value);
  }

  value(path) {
    const of = this.rows.get(path);
    return of && of.number.value;
  }

  /** Shows the numbers whose path has all these words. */
  filter(text) {
    const wanted = text.toLowerCase().split(/\s+/).filter(Boolean);
    for (const details of this.box.children) {
      let count = 0;
      for (const row of details.querySelectorAll('.one-number')) {
        row.hidden = !wanted.every((word) => row.dataset.path.toLowerCase().includes(word));
        if (!row.hidden) ++count;
      }
      details.hidden = count === 0;
      if (wanted.length && count) details.open = true;
    }
    $('all-numbers').hidden = wanted.length === 0;
  }

  /** Opens the tables of a part, and shows them alone. */
  open(part) {
    const name = part.replace(/^(starboard|port)-/, ''), has = [...this.rows.keys()].some((path) => path.includes(name));
    $('filter').value = has ? name : '';
    this.filter($('filter').value);
    if (has) this.box.querySelector('details:not([hidden])').scrollIntoView({block: 'nearest'});
  }
}
