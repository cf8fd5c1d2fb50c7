// SPDX-License-Identifier: BSD-3-Clause
// The texts of the files of the design, with their errors marked.

const REST_OF_KEYS = 10;  // milliseconds between a key press and the check of the text; further key presses
                          // restart it

class TextPane {
  /** `onEdit(file, text)` is called when a text without errors of syntax has been written. */
  constructor(server, onEdit) {
    Object.assign(this, {server, onEdit, files: [], messages: []});
    $('text').addEventListener('input', () => this.changed());
    $('text').addEventListener('scroll', () => this.scroll());
    $('file').addEventListener('change', () => this.showFile());
    for (const [one, other] of [['plan', 'text'], ['text', 'plan']]) {
      $(`tab-${one}`).addEventListener('click', () => this.choose(one, other));
      $(`tab-${one}`).addEventListener('keydown', (event) => { if (/^Arrow(Left|Right)$/.test(event.key)) { this.choose(other, one); $(`tab-${other}`).focus(); } });
    }
  }

  choose(one, other) {
    for (const [name, isChosen] of [[one, true], [other, false]]) {
      $(`tab-${name}`).setAttribute('aria-selected', String(isChosen));
      $(`tab-${name}`).tabIndex = isChosen ? 0 : -1;
      $(`pane-${name}`).hidden = !isChosen;
    }
  }

  show(files, main) {
    const names = files.map((f) => f.name), chosen = $('file').value;
    if (names.join('\n') !== this.files.map((f) => f.name).join('\n')) {
      $('file').replaceChildren(...names.map((name) => element('option', {value: name}, name)));
      $('file').value = names.includes(chosen) ? chosen : main;
    }
    this.files = files;
    // While the user types, the text is not replaced, because the server has accepted or refused it already.
    if (document.activeElement !== $('text') || !this.isWriting) this.showFile();
  }

  showFile() {
    const file = this.files.find((f) => f.name === $('file').value);
    if (file && $('text').value !== file.text) $('text').value = file.text;
    this.number();
  }

  /** Numbers of the lines; wrong ones are marked. */
  number() {
    const wrong = new Set(this.messages.filter((m) => m.severity === 'error' && m.file === $('file').value).map((m) => m.line));
    const count = $('text').value.split('\n').length, lines = [];
    for (let i = 1; i <= count; ++i) lines.push(element('span', wrong.has(i) ? {class: 'wrong'} : {}, `${wrong.has(i) ? '✕ ' : ''}${i}\n`));
    $('lines').replaceChildren(...lines);
    this.underline();
    this.scroll();
  }

  scroll() {
    $('lines').scrollTop = $('marks').scrollTop = $('text').scrollTop;
    $('marks').scrollLeft = $('text').scrollLeft;
  }

  /** Underlines what the messages about this file are about, on a sheet that lies under the text. */
  underline() {
    const here = this.messages.filter((m) => m.file === $('file').value && m.line > 0).sort((a, b) => a.line - b.line || a.column - b.column);
    const lines = $('text').value.split('\n'), parts = [];
    for (const [i, line] of lines.entries()) {
      const letters = Array.from(line);  // columns count characters
      let at = 0;
      for (const m of here.filter((one) => one.line === i + 1)) {
        const begin = Math.min(Math.max(at, m.column - 1), Math.max(at, letters.length - 1)), end = Math.min(letters.length, begin + Math.max(1, m.length));
        parts.push(letters.slice(at, begin).join(''), element('span', {class: m.severity === 'error' ? 'fault' : 'doubt', title: m.message}, letters.slice(begin, end).join('') || ' '));
        at = end;
      }
      parts.push(letters.slice(at).join('') + '\n');
    }
    $('marks').replaceChildren(...parts);
  }

  mark(messages) {
    this.messages = messages;
    this.number();
    const errors = messages.filter((m) => m.severity === 'error');
    if (errors.length) showMessages($('text-errors'), errors); else $('text-errors').replaceChildren();
  }

  changed() {
    this.isWriting = true;
    clearTimeout(this.timer);
    this.number();
    this.timer = setTimeout(() => this.check(), REST_OF_KEYS);
  }

  async check() {
    const file = $('file').value, text = $('text').value;
    try {
      const {messages} = await this.server.ask('check', {file, text});
      if (text !== $('text').value) return;
      this.mark(messages);
      if (!messages.some((m) => m.severity === 'error')) await this.onEdit(file, text);
    } finally {
      this.isWriting = false;
    }
  }

  /** Shows the table of a part in the text, if an own file has it. */
  scrollTo(part) {
    const {value} = $('text'), at = value.split('\n').findIndex((line) => line.startsWith('[') && line.includes(`.${part}]`));
    if (at >= 0) $('text').scrollTop = 18 * Math.max(0, at - 2);
  }
}
