// SPDX-License-Identifier: BSD-3-Clause
// Parts that are added and removed. Kinds, fields and choices are those of the program; a click in the picture
// chooses for the field that was touched last.

const isNumber = (field) => field.of === 'metres' || field.of === 'count';
const isPicked = (field) => ['points', 'ropes', 'edges'].includes(field.of);
const plainName = (part) => part.replace(/^(starboard|port)-/, '');

class PartsForm {
  /** `onAdd(choices)` and `onRemove(part)` change the gear. */
  constructor(server, onAdd, onRemove) {
    Object.assign(this, {server, templates: [], points: [], armed: null, key: ''});
    $('add-kind').addEventListener('change', () => this.showFields());
    $('add-form').addEventListener('submit', (event) => { event.preventDefault(); onAdd({kind: this.kind.kind, ...this.choices()}); });
    $('remove-form').addEventListener('submit', (event) => { event.preventDefault(); onRemove($('remove-part').value); });
    document.addEventListener('focusin', ({target}) => { if (target.id !== 'canvas') this.arm(this.kind && this.kind.fields.find((f) => isPicked(f) && target.id === `add-${f.name}`)); });
  }

  get kind() { return this.templates.find((t) => t.kind === $('add-kind').value); }

  /** Asks what can be added and removed now. */
  async refresh() {
    const {templates, parts, points} = await this.server.ask('parts');
    Object.assign(this, {templates, points});
    this.fill($('add-kind'), templates.map((t) => t.kind));
    this.fill($('remove-part'), parts);
    $('add-form').hidden = $('remove-form').hidden = !parts.length;
    const key = JSON.stringify(templates);
    if (key !== this.key) { this.key = key; this.showFields(); }
  }

  fill(select, values) {
    const {value} = select;
    select.replaceChildren(...values.map((v) => element('option', {value: v}, v)));
    if (values.includes(value)) select.value = value;
  }

  showFields() {
    const before = this.choices();
    $('add-kind').title = this.kind.doc;
    $('add-fields').replaceChildren(...this.kind.fields.flatMap((field) => {
      const id = `add-${field.name}`, input = isNumber(field) ? element('input', {id, type: 'number', min: '0', step: 'any', placeholder: 'as it fits'}) : element('select', {id});
      if (!isNumber(field)) this.fill(input, field.choices);
      const wanted = before[field.name] || field.usual;
      if (isNumber(field) || field.choices.includes(wanted)) input.value = wanted;
      return [element('label', {for: id}, field.of === 'metres' ? `${field.words} [m]` : field.words), input];
    }));
    this.arm(null);
  }

  /** What the fields have now; empty ones are left to the program. */
  choices() {
    const inputs = [...$('add-fields').querySelectorAll('input, select')].filter((input) => input.value !== '');
    return Object.fromEntries(inputs.map((input) => [input.id.slice(4), input.value]));
  }

  arm(field) {
    this.armed = field || null;
    $('add-hint').textContent = this.armed ? `A click in the picture chooses “${field.words}”.` : '';
  }

  /** A part was selected, at a place of its gear; returns whether a field has taken it. */
  take(part, place) {
    const name = plainName(part), removed = [...$('remove-part').options].find((o) => o.value.endsWith(`.${name}`));
    if (removed) $('remove-part').value = removed.value;
    const choice = this.armed && this.choiceFor(this.armed, name, place);
    if (!choice || !this.armed.choices.includes(choice)) return false;
    $(`add-${this.armed.name}`).value = choice;
    const fields = this.kind.fields.filter(isPicked);
    this.arm(fields[fields.indexOf(this.armed) + 1]);
    return true;
  }

  choiceFor(field, name, place) {
    if (field.of === 'ropes') return name;
    const near = place && this.nearest(place, field.of === 'points' ? '' : `${name}.`);
    if (field.of === 'points' || !near) return near;
    const end = near.slice(name.length + 1).startsWith('aft') ? 'aft' : 'fore';
    return field.choices.find((edge) => edge === `${name}.${end}`) || field.choices.find((edge) => edge.startsWith(`${name}.`));
  }

  /** The name of the nearest point whose name begins in this way. */
  nearest(place, begin) {
    const away = ({at}) => Math.hypot(...at.map((v, d) => v - place[d]));
    return this.points.filter((p) => p.name.startsWith(begin)).reduce((best, p) => (best && away(best) <= away(p) ? best : p), null)?.name;
  }
}
