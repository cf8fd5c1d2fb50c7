// SPDX-License-Identifier: BSD-3-Clause
// The controls above the picture.

const SECTIONS = {x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1]};

function connectControls(viewer) {
  for (const name of Object.keys(viewer.camera.views)) $(`view-${name}`).addEventListener('click', () => viewer.look(name));
  connectColours(viewer);
  connectSection(viewer);
  connectOverlay(viewer);
  for (const id of ['bed', 'surface', 'measures', 'holds']) $(id).addEventListener('change', () => viewer.draw());
  if (!viewer.result.plateDot.length) $('extent').querySelector('[value=boards]').remove();
  $('extent').addEventListener('change', () => viewer.fit());
  $('bed').disabled = !viewer.result.ground.heights;
  $('bed').checked = Boolean(viewer.result.ground.heights);
  $('print').addEventListener('click', () => window.print());
  window.addEventListener('beforeprint', () => viewer.printAs(true));
  window.addEventListener('afterprint', () => viewer.printAs(false));
  $('save').addEventListener('click', () => savePicture(viewer));
  $('theme').addEventListener('click', () => {
    document.documentElement.dataset.theme = styleColour('--is-dark') === '1' ? 'light' : 'dark';
    if (viewer.curves) viewer.curves.draw();
    viewer.redraw();
  });
}

function listFields(viewer) {
  $('field').replaceChildren(...viewer.fields.choices.map((f) => element('option', {value: f.name}, f.label)));
}

function connectColours(viewer) {
  listFields(viewer);
  $('field').addEventListener('change', () => viewer.setField($('field').value));
  for (const id of ['log', 'by-element']) $(id).addEventListener('change', () => viewer.repaint());
}

function connectSection(viewer) {
  const cut = () => {
    const axis = SECTIONS[$('section').value], k = axis ? axis.indexOf(1) : 0;
    $('cut').disabled = !axis;
    let [lo, hi] = [Infinity, -Infinity];
    for (const p of viewer.model.places('netting')) { lo = Math.min(lo, p[k]); hi = Math.max(hi, p[k]); }
    viewer.shared.common.section.value.set(...(axis || [0, 0, 0]), axis ? lo + (hi - lo) * Number($('cut').value) / 100 + 1e-9 : 1e30);
    viewer.draw();
  };
  $('section').addEventListener('change', cut);
  $('cut').addEventListener('input', cut);
}

/** How two results are shown. */
function listResults(viewer) {
  $('overlay-row').hidden = !viewer.second;
  const ways = [['both', 'both, the second in grey'], ['beside', 'beside each other'], ...viewer.results.map((r, i) => [String(i), r.varied || r.file])];
  $('overlay').replaceChildren(...(viewer.second ? ways : []).map(([value, text]) => element('option', {value}, text)));
}

function connectOverlay(viewer) {
  listResults(viewer);
  $('overlay').addEventListener('change', () => { viewer.applyVisibility(); viewer.resize(); viewer.fit(); });
}

/** The picture as it is on the screen, with legend, dimensions and scale, as a PNG file. */
async function savePicture(viewer) {
  viewer.drawNow();
  const ratio = viewer.renderer.getPixelRatio(), out = element('canvas', {width: viewer.canvas.width, height: viewer.canvas.height}), g = out.getContext('2d');
  g.drawImage(viewer.canvas, 0, 0);
  g.scale(ratio, ratio);
  const stage = $('stage').getBoundingClientRect();
  for (const svg of document.querySelectorAll('#stage > svg, #legend svg, #scale svg')) {
    const box = svg.getBoundingClientRect();
    await drawSvg(g, svg, box.left - stage.left, box.top - stage.top, box.width, box.height);
  }
  g.fillStyle = styleColour('--ink');
  g.font = '13px system-ui, sans-serif';
  for (const text of $('stage').querySelectorAll('#legend strong, #legend span, #scale span')) {
    const box = text.getBoundingClientRect();
    g.fillText(text.textContent, box.left - stage.left, box.bottom - stage.top - 4);
  }
  const link = element('a', {download: `${viewer.result.title}.png`, href: out.toDataURL('image/png')});
  link.click();
}

/** An SVG element of the page as part of a picture; what the style sheet says of it is written into it. */
function drawSvg(g, svg, x, y, width, height) {
  const copy = svg.cloneNode(true), from = svg.querySelectorAll('*'), to = copy.querySelectorAll('*');
  from.forEach((node, i) => {
    const style = getComputedStyle(node);
    for (const name of ['fill', 'stroke', 'stroke-width', 'font-size', 'paint-order']) to[i].setAttribute(name, style.getPropertyValue(name));
    to[i].setAttribute('font-family', 'system-ui, sans-serif');
  });
  copy.setAttribute('xmlns', SVG);
  copy.setAttribute('width', width);
  copy.setAttribute('height', height);
  copy.setAttribute('color', styleColour('--ink'));
  return new Promise((done) => {
    const image = new Image();
    image.onload = () => { g.drawImage(image, x, y, width, height); done(); };
    image.onerror = done;
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(new XMLSerializer().serializeToString(copy))}`;
  });
}
