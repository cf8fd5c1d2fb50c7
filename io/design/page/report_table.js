// SPDX-License-Identifier: BSD-3-Clause
// The report: key figures as cards, all figures with their differences from the start, and the checks.

function differenceText(figure) {
  if (!Number.isFinite(figure.value) || !Number.isFinite(figure.start)) return '';
  const by = figure.value - figure.start, share = Math.abs(figure.start) > 0 ? 100 * by / Math.abs(figure.start) : NaN;
  if (Math.abs(by) <= 1e-7 * Math.abs(figure.start)) return 'no difference';
  const sign = by > 0 ? '+' : '';
  return `${sign}${shortText(by, figure.unit)}${Number.isFinite(share) ? ` (${sign}${formatNumber(share, 2)} %)` : ''}`;
}

function showKeyFigures(figures, isGhost) {
  $('keys').replaceChildren(...figures.filter((f) => f.key).map((f) => {
    const card = element('div', isGhost ? {class: 'ghost'} : {}), value = element('dd', {}, (isGhost ? '≈ ' : '') + shortText(f.value ?? NaN, f.unit));
    card.dataset.figure = f.name;
    value.append(element('small', {}, differenceText(f)));
    card.append(element('dt', {title: f.doc}, words(f.name.replace(/^mouth\//, ''))), value);
    return card;
  }));
}

const errorText = (error, unit) => (Number.isFinite(error) ? `± ${formatNumber(Math.abs(error), 2)} ${unitText(unit)}` : '');

function showReport(figures) {
  $('report').tBodies[0].replaceChildren(...figures.map((f) => {
    const row = element('tr', {}), by = Number.isFinite(f.value) && Number.isFinite(f.start) ? f.value - f.start : NaN;
    const share = Math.abs(f.start) > 0 ? 100 * by / Math.abs(f.start) : NaN;
    row.append(element('th', {scope: 'row', title: f.doc}, words(f.name)));
    for (const text of [withUnit(f.value ?? NaN, f.unit), errorText(f.error, f.unit), errorText(f.mesh_error, f.unit), withUnit(f.start ?? NaN, f.unit),
      by ? withUnit(by, f.unit) : '', by && Number.isFinite(share) ? formatNumber(share, 3) : '']) row.append(element('td', {class: 'number'}, text));
    return row;
  }));
}

/** Figures that are compared with those of the gear beside this one, not with the start. */
function comparedWith(figures, beside) {
  if (!beside) return figures;
  const values = new Map(beside.figures.map((f) => [f.name, f.value]));
  return figures.map((f) => ({...f, start: values.get(f.name) ?? null}));
}

/** Figures with the errors of the mesh that belong to them. */
function withErrors(figures, found) {
  const errors = new Map(found.map((f) => [f.name, f.mesh_error]));
  return figures.map((f) => ({...f, mesh_error: errors.get(f.name)}));
}

/** Messages as a list; those with a cure that is a change get a button that makes it. */
function showMessages(list, messages, onChange) {
  list.replaceChildren(...messages.map((m) => {
    const item = element('li', {class: m.severity === 'error' ? 'error-message' : 'warning-message'}, `${m.file ? `${m.file}:${m.line}:${m.column}: ` : ''}${m.severity}: ${m.message}`);
    if (m.hint) item.append(element('div', {class: 'pale'}, m.hint));
    for (const change of onChange ? m.changes : []) {
      const button = element('button', {type: 'button'}, `Set ${change}`);
      button.addEventListener('click', () => onChange(change));
      item.append(button);
    }
    return item;
  }));
  if (!messages.length) list.append(element('li', {}, 'There is nothing to remark.'));
}
