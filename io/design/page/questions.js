// SPDX-License-Identifier: BSD-3-Clause
// Questions about the design: which numbers a figure depends on, how figures change over a number, and which
// value of a number reaches a target.

const POINTS_OF_SWEEP = 11;

class Questions {
  /** `onSet(path, value)` moves a number. */
  constructor(server, onSet, onPath) {
    Object.assign(this, {server, onSet, onPath});
    const ask = (id, work) => $(id).addEventListener('click', async () => {
      $('answer').textContent = 'working …';
      $('curve-of-sweep').replaceChildren();
      try { await work(); } catch (error) { $('answer').textContent = error.message; }
    });
    ask('ask-influences', () => this.influences());
    ask('ask-sweep', () => this.sweep());
    ask('ask-reach', () => this.reach());
    ask('ask-range', () => this.range());
    $('moved').addEventListener('change', () => this.suggest());
  }

  show(figures, numbers) {
    this.figures = figures;
    this.numbers = numbers;
    this.fill($('figure'), [...figures].sort((a, b) => b.key - a.key).map((f) => [f.name, words(f.name)]));
    this.fill($('moved'), numbers.map((n) => [n.path, n.path]));
    if ($('also').options.length !== numbers.length) $('also').replaceChildren(...numbers.map((n) => element('option', {value: n.path}, n.path)));
    if ($('from').value === '') this.suggest();
  }

  /** The number that was moved last is the one that is asked about. */
  choose(path) {
    if (![...$('moved').options].some((option) => option.value === path)) return;
    $('moved').value = path;
    this.suggest();
  }

  fill(select, pairs) {
    const chosen = select.value, key = pairs.map(([value]) => value).join('\n');
    if (select.dataset.key === key) return;
    select.dataset.key = key;
    select.replaceChildren(...pairs.map(([value, text]) => element('option', {value}, text)));
    if (pairs.some(([value]) => value === chosen)) select.value = chosen;
  }

  suggest() {
    const number = (this.numbers || []).find((n) => n.path === $('moved').value);
    if (!number) return;
    const {min, max} = rangeOf(number);
    $('from').value = String(tidy(number.value + 0.4 * (min - number.value)));
    $('to').value = String(tidy(number.value + 0.4 * (max - number.value)));
  }

  figure() { return this.figures.find((f) => f.name === $('figure').value); }

  async influences() {
    const {figure, ranked, without} = await this.server.ask('influences', {figure: $('figure').value}), {unit} = this.figure();
    const table = element('table'), head = element('tr');
    for (const text of ['number', 'value', `${words(figure)} for one percent more`]) head.append(element('th', {scope: 'col'}, text));
    table.append(head, ...ranked.slice(0, 15).map((r) => {
      const row = element('tr'), cell = element('td'), button = element('button', {type: 'button'}, r.path);
      button.addEventListener('click', () => this.onPath(r.path));
      cell.append(button);
      row.append(cell, element('td', {class: 'number'}, `${formatNumber(r.value)} ${r.unit}`), element('td', {class: 'number'}, withUnit(r.per_percent, unit)));
      return row;
    }));
    $('answer').replaceChildren(table, element('p', {class: 'pale'}, without.length ? `Numbers without derivatives: ${without.length}.` : ''));
  }

  async sweep() {
    const path = $('moved').value, figure = this.figure();
    const found = await this.server.ask('sweep', {path, from: Number($('from').value), to: Number($('to').value), points: POINTS_OF_SWEEP});
    const y = found.figures[figure.name], missing = y.filter((v) => v === null).length;
    $('answer').textContent = `${words(figure.name)} over ${path}${missing ? `; ${missing} of ${y.length} values have no equilibrium` : ''}`;
    const ink = styleColour('--ink'), axis = {stroke: ink, grid: {stroke: styleColour('--line'), width: 1}, font: '11px system-ui, sans-serif', labelFont: '12px system-ui, sans-serif'};
    const box = $('curve-of-sweep');
    this.plot = new L.uPlot({width: Math.max(260, box.clientWidth), height: 240, legend: {show: false}, scales: {x: {time: false}},
      axes: [{...axis, label: `${path}${found.unit ? ` [${found.unit}]` : ''}`, values: (_, v) => v.map((x) => formatNumber(x, 3))},
        {...axis, size: 62, label: `${words(figure.name)} ${unitText(figure.unit) ? `[${unitText(figure.unit)}]` : ''}`, values: (_, v) => v.map((x) => formatNumber(x, 3))}],
      series: [{}, {stroke: styleColour('--curve'), width: 2, points: {show: true, size: 6}}]}, [found.values, y], box);
  }

  async range() {
    const path = $('moved').value, {unit, down, up} = await this.server.ask('range', {path});
    $('answer').replaceChildren(...[['down to', down], ['up to', up]].map(([text, end]) => element('p', {}, `${path} ${text} ${formatNumber(end.value)} ${unit}: ${end.why}.`)));
  }

  async reach() {
    const paths = [...new Set([$('moved').value, ...[...$('also').selectedOptions].map((o) => o.value)])];
    const found = await this.server.ask('reach', {figure: $('figure').value, target: Number($('target').value), paths});
    $('answer').textContent = `${found.numbers.map((n) => `${n.path} = ${formatNumber(n.value, 6)} ${n.unit}`.trim()).join(', ')} gives ${words(found.figure)} = ${withUnit(found.reached, this.figure().unit)}; it is set.`;
    for (const {path, value} of found.numbers) await this.onSet(path, value);
  }
}
