// SPDX-License-Identifier: BSD-3-Clause
// The list of parts. Each part can be hidden, or shown alone.

class PartList {
  constructor(viewer, list) {
    Object.assign(this, {viewer, list});
    const {parts} = viewer.models[0].result;
    list.replaceChildren(...parts.map((part, i) => this.row(part, i)));
    this.boxes = [...list.querySelectorAll('input')];
  }

  row(part, i) {
    const row = element('li'), label = element('label'), box = element('input', {type: 'checkbox'});
    const only = element('button', {type: 'button', 'aria-label': `show ${part.name} only`}, 'only');
    box.checked = Boolean(this.viewer.models[0].shown[i]);
    box.addEventListener('change', () => this.apply());
    only.addEventListener('click', () => this.isolate(i));
    const patch = element('span', {class: 'patch', 'aria-hidden': 'true'});
    patch.style.background = cssColour(this.viewer.colours.ofPart(i));
    label.append(box, patch, element('span', {}, part.name));
    row.append(label, only);
    row.hidden = !this.viewer.models[0].drawn.has(i);
    return row;
  }

  /** Shows one part alone; all if it is alone already. */
  isolate(i) {
    const alone = this.boxes.every((box, k) => box.checked === (k === i));
    this.boxes.forEach((box, k) => { box.checked = alone || k === i; });
    this.apply();
  }

  apply() {
    const {parts} = this.viewer.models[0].result;
    this.boxes.forEach((box, i) => this.viewer.models.forEach((model) => model.showPart(parts[i].name, box.checked)));
    this.viewer.redraw();
  }

  /** Where a part touches a bed is shown while that is what is coloured. */
  showContacts(on) {
    const {parts} = this.viewer.models[0].result;
    this.boxes.forEach((box, i) => { if (parts[i].contact) box.checked = on; });
    this.apply();
  }
}
