// SPDX-License-Identifier: BSD-3-Clause
// The page of a design: changing a number changes the shape. The design is the text of the files, which the
// server keeps.

const REST = 70;  // milliseconds after the last move of a slider; then the search for the equilibrium begins
const LONG_SEARCH = 1500;  // milliseconds after which a search can be stopped
const LONG_REST = 350;  // milliseconds after which picture, checks and plan are requested, too

class Designer {
  constructor(root) {
    this.server = new Server(root);
    this.shape = new Shape(this.server);
    this.times = [];  // time from the move of a slider to the picture of the equilibrium [ms]
    this.numbers = new NumberList($('number-list'), (...move) => this.moved(...move), (path) => this.shape.prepare(path));
    this.text = new TextPane(this.server, (file, text) => this.apply({file, text, goes_on: true}));
    this.questions = new Questions(this.server, (path, to) => this.apply({path, to}), (path) => { $('filter').value = path; this.numbers.filter(path); this.questions.choose(path); });
    this.parts = new PartsForm(this.server, (choices) => this.apply(choices, 'add'), (part) => this.apply({part}, 'remove'));
    this.shape.onPart = (part, place) => { if (!this.parts.take(part, place)) { this.numbers.open(part); this.text.scrollTo(part); } };
    this.connectButtons();
    this.connectPlan();
  }

  connectButtons() {
    const press = (id, work) => $(id).addEventListener('click', () => this.attempt(work));
    press('undo', async () => this.showState(await this.server.ask('undo')));
    press('redo', async () => this.showState(await this.server.ask('redo')));
    press('save-text', async () => { const state = await this.server.ask('save'); this.showState(state); this.say(state.written.length ? `written: ${state.written.join(', ')}` : 'there was nothing to write'); });
    press('save-as', async () => {
      const as = window.prompt('Name of the file, in the folder of the scene', 'my-trawl.toml');
      if (as) { const state = await this.server.ask('save', {as}); this.showState(state); this.say(`written: ${state.written.join(', ')}`); }
    });
    press('go-back', async () => { $('notice').hidden = true; this.showState(await this.server.ask('undo')); });
    press('ask-errors', async () => {
      $('errors-said').textContent = 'solving on other meshes …';
      try {
        const {figures, note} = await this.server.ask('errors');
        this.showReport(withErrors(this.shape.figures, figures));
        $('errors-said').textContent = `The error of the mesh ${note}`;
      } catch (error) { $('errors-said').textContent = error.message; }
    });
    press('keep-beside', async () => this.putBeside({...await this.server.ask('beside', {of: 'now'}), name: `as kept at ${new Date().toLocaleTimeString()}`}, 'kept'));
    $('beside').addEventListener('change', () => this.attempt(() => this.chooseBeside($('beside').value)));
    press('do-export', () => this.download($('export').value));
    press('stop', async () => { $('stop').hidden = true; await this.server.ask('stop'); });
    press('dismiss', async () => { $('notice').hidden = true; });
    $('set-form').addEventListener('submit', (event) => { event.preventDefault(); this.apply({set: $('set').value}); });
    document.addEventListener('keydown', (event) => {
      const isUndo = (event.ctrlKey || event.metaKey) && event.key.toLowerCase() === 'z';
      if (!isUndo || /^(TEXTAREA|INPUT)$/.test(document.activeElement.tagName) && document.activeElement.type !== 'range') return;
      event.preventDefault();
      $(event.shiftKey ? 'redo' : 'undo').click();
    });
  }

  /** Another gear beside this one: `choice` is nothing, the start, the one that was kept, or a file. */
  async chooseBeside(choice) {
    if (choice === '') return this.putBeside(null, '');
    if (choice === 'kept') return this.putBeside(this.kept, choice);
    const name = choice === 'start' ? 'the start' : choice;
    this.say(`${name} is being put beside this one …`);
    return this.putBeside({...await this.server.ask('beside', choice === 'start' ? {of: 'start'} : {file: choice}), name}, choice);
  }

  async putBeside(beside, choice) {
    if (choice === 'kept') this.kept = beside;
    if (![...$('beside').options].some((o) => o.value === choice)) $('beside').append(element('option', {value: choice}));
    const option = [...$('beside').options].find((o) => o.value === choice);
    if (beside) option.textContent = beside.name;
    $('beside').value = choice;
    this.beside = beside;
    this.showFigures(this.shape.figures, false);
    this.showReport(this.shape.figures);
    if (!this.shape.isFlat) await this.shape.showBeside(beside && structuredClone(beside.picture), beside && beside.name);
    if (beside) this.say(`${beside.name} is beside this one; differences are those from it`);
  }

  showFigures(figures, isGhost) { showKeyFigures(comparedWith(figures, this.beside), isGhost); }

  showReport(figures) {
    $('compared-with').textContent = this.beside ? this.beside.name : 'at the start';
    showReport(comparedWith(figures, this.beside));
  }

  /** Gives a file to the browser, which writes it where it writes downloads. */
  async download(kind) {
    const file = kind === 'svg' ? {name: `${$('title').textContent.replace(/\.toml$/, '')}.svg`, data: (await this.server.ask('plan')).svg} : await this.exported(kind);
    if (!file.data.length) throw new Error('there is no plan to export');
    const url = URL.createObjectURL(new Blob([file.data])), link = element('a', {href: url, download: file.name});
    link.click();
    setTimeout(() => URL.revokeObjectURL(url), 10000);
    this.say(`${file.name} is given to the browser`);
  }

  async exported(kind) {
    const {name, base64} = await this.server.ask('export', {as: kind});
    return {name, data: Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))};
  }

  /** A click on the plan opens the part whose name is nearest. */
  connectPlan() {
    $('pane-plan').addEventListener('click', (event) => {
      let best = null;
      for (const text of $('pane-plan').querySelectorAll('text')) {
        const name = text.textContent.split(':')[0].trim(), box = text.getBoundingClientRect();
        if (![...this.numbers.rows.keys()].some((path) => path.split('.')[1] === name) && !this.partNames().includes(name)) continue;
        const away = Math.hypot(event.clientX - box.left - box.width / 2, event.clientY - box.top - box.height / 2);
        if (!best || away < best.away) best = {name, away};
      }
      if (best) this.shape.onPart(best.name);
    });
  }

  partNames() { return this.shape.viewer ? this.shape.viewer.result.parts.map((p) => p.name) : []; }

  say(text) { $('said').textContent = text; }

  async attempt(work) {
    try { await work(); } catch (error) { this.say(error.message); }
  }

  // ---- changes

  /** A slider moves: the ghost at once, the equilibrium when it rests. */
  moved(path, value, isMoving) {
    this.moving = {path, value, at: performance.now()};
    if (!isMoving) this.questions.choose(path);
    this.shape.ghost(path, value).then((figures) => { if (figures && this.moving && this.moving.value === value) this.showFigures(figures, true); });
    clearTimeout(this.rest);
    const goesOn = this.gesture === path;
    this.rest = setTimeout(() => { this.rest = null; this.gesture = isMoving ? path : null; this.apply({path, to: value, goes_on: goesOn}); }, isMoving ? REST : 0);
  }

  async apply(change, request = 'apply') {
    await this.attempt(async () => {
      this.begun = this.moving ? this.moving.at : performance.now();
      const state = await this.server.ask(request, change);
      this.wanted = state.revision;
      this.showState(state);
    });
  }

  showState(state) {
    Object.assign(this, {revision: Math.max(this.revision || 0, state.revision)});
    $('title').textContent = document.title = state.file;
    $('undo').disabled = !state.can_undo;
    $('redo').disabled = !state.can_redo;
    $('saved').textContent = state.saved ? 'saved' : 'not saved';
    this.numbers.show(state.numbers);
    this.text.show(state.files, state.file);
    // The outcome of this text may have arrived before the answer to its change.
    const isKnown = this.failure && this.failure.revision >= state.revision;
    this.text.mark(isKnown ? this.failure.messages : state.messages);
    if (this.shape.figures.length) this.questions.show(this.shape.figures, state.numbers);
    this.list = state.numbers;
  }

  // ---- answers

  /** A search that takes long can be stopped; one that does not return ends with its process. */
  offerStop() {
    clearTimeout(this.stopTimer);
    this.stopTimer = setTimeout(() => { $('stop').hidden = false; }, LONG_SEARCH);
  }

  async solved(outcome) {
    clearTimeout(this.stopTimer);
    $('stop').hidden = true;
    if (outcome.revision < (this.wanted || 0)) return;
    if (outcome.status === 'converged') await this.takeShape(outcome);
    else this.takeFailure(outcome);
    clearTimeout(this.longRest);
    this.longRest = setTimeout(() => this.attempt(() => this.followUp(outcome)), this.shape.viewer || this.shape.isFlat ? LONG_REST : 0);
  }

  async takeShape(outcome, clearsNotice = true) {
    await this.shape.take(outcome);
    if (this.begun) { this.times.push(performance.now() - this.begun); this.begun = null; }
    this.moving = null;
    this.showFigures(outcome.figures, false);
    this.showReport(outcome.figures);
    if (this.list) this.questions.show(outcome.figures, this.list);
    const ms = Math.round(1000 * (outcome.seconds.reading + outcome.seconds.solving));
    this.say(`equilibrium found in ${ms} ms`);
    if (outcome.jump) this.warn(`The gear jumped: it is ${formatNumber(outcome.jump.off, 3)} m from where the slider's tangent led. ${outcome.jump.why}.`);
    else if (clearsNotice) $('notice').hidden = true;
    const held = document.activeElement && document.activeElement.closest && document.activeElement.closest('.one-number');
    if (held) this.shape.prepare(held.dataset.path);
    document.documentElement.dataset.revision = String(outcome.revision);
  }

  /** A run of the text from its sketch has ended; its equilibrium is the one that the saved file has. */
  async confirmed(outcome) {
    if (this.rest || outcome.revision < (this.wanted || 0)) return;
    if (outcome.status !== 'converged') {
      this.warn(`A run of this text from its sketch finds no equilibrium: ${outcome.sentence}. The shape shown was reached from its neighbour.`);
      return;
    }
    const said = $('said').textContent, {jump} = outcome;
    await this.takeShape({...outcome, jump: null}, false);
    this.say(`${said}; a run of the text finds ${jump ? 'another one, which is shown' : 'the same'}`);
    if (jump) this.warn(`A run of this text from its sketch finds another equilibrium, up to ${formatNumber(jump.off, 3)} m away, which is shown now. ${jump.why}.`);
    document.documentElement.dataset.confirmed = String(outcome.revision);
    if (!this.shape.isFlat && jump) await this.shape.showPicture(await this.server.ask('picture'));
  }

  takeFailure(outcome) {
    this.moving = null;
    this.shape.setGrey(true);
    this.showFigures(this.shape.figures, false);
    const error = outcome.messages.find((m) => m.severity === 'error');
    this.warn(error ? `${error.message}${error.hint ? `; ${error.hint}` : ''}` : `${outcome.status}: ${outcome.sentence}${outcome.at_fault ? ` (at ${outcome.at_fault})` : ''}. The last shape is kept, in grey.`);
    showMessages($('checks'), outcome.messages, (set) => this.apply({set}));
    this.say(outcome.status);
    this.failure = outcome;
    this.text.mark(outcome.messages);
    document.documentElement.dataset.revision = String(outcome.revision);
  }

  warn(text) {
    $('notice-text').textContent = text;
    $('notice').hidden = false;
  }

  /** What may come a little later: the colours of the picture, the checks, the plan, the materials. */
  async followUp(outcome) {
    if (outcome.revision < this.revision) return;
    const {svg} = await this.server.ask('plan');
    this.showPlan(svg);
    showMessages($('checks'), outcome.messages.length && outcome.status === 'wrong input' ? outcome.messages : (await this.server.ask('check')).messages, (set) => this.apply({set}));
    if (outcome.status !== 'converged') return;
    if (!this.shape.isFlat) await this.shape.showPicture(await this.server.ask('picture'));
    this.showMaterials(await this.server.ask('report'));
    this.list = (await this.server.ask('state')).numbers;
    this.numbers.show(this.list);
    await this.parts.refresh();
    document.documentElement.dataset.ready = 'yes';
  }

  showPlan(svg) {
    if (!svg) return;
    const drawn = new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement;
    if (drawn.nodeName !== 'svg') return;
    drawn.setAttribute('role', 'img');
    drawn.setAttribute('aria-label', 'The plan');
    $('pane-plan').replaceChildren(document.adoptNode(drawn));
  }

  /** Tables that the program has made, in which all texts are escaped. */
  showMaterials({summary, deck, materials}) {
    $('materials').replaceChildren(...new DOMParser().parseFromString(summary + deck + materials, 'text/html').body.childNodes);
  }

  async start() {
    const state = await this.server.ask('state');
    this.showState(state);
    this.server.listen(state.event, {
      solving: () => { this.say('seeking the equilibrium …'); this.offerStop(); },
      solved: (outcome) => this.attempt(() => this.solved(outcome)),
      confirmed: (outcome) => this.attempt(() => this.confirmed(outcome)),
      ended: ({sentence}) => this.warn(`${sentence}. The next change starts another solver.`),
      changed: (changed) => { this.showState(changed); this.say('a file was changed by another program and read again'); },
      progress: ({done, of}) => { $('answer').textContent = `working: ${done} of ${of}`; },
    }, () => this.warn('The program has ended. What was not saved is lost; start netloft design again.'));
    if (state.outcome) await this.solved(state.outcome);
    if (state.beside) await this.chooseBeside(state.beside);
  }
}

window.netloftDesigner = new Designer(window.location.pathname);
window.netloftDesigner.start().catch((error) => { $('status').textContent = `The page cannot be shown: ${error.message}.`; $('status').hidden = false; });
