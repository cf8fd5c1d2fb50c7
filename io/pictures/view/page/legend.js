// SPDX-License-Identifier: BSD-3-Clause
// The legend of colours, with a bar for each kind of cells that has the field, and the scale of lengths.

const BAR = 230;  // pixels

function legendBar(colours, scale, unit) {
  const svg = svgElement('svg', {width: BAR + 44, height: 32, role: 'img', 'aria-label': `colours from ${withUnit(scale.lo, unit)} to ${withUnit(scale.hi, unit)}`});
  for (let i = 0; i < 58; ++i) svg.append(svgElement('rect', {x: 22 + BAR * i / 58, y: 0, width: BAR / 58 + 0.6, height: 12, fill: cssColour(colours.at(i / 57))}));
  if (scale.below) svg.append(svgElement('text', {x: 16, y: 11, 'text-anchor': 'end'}, '<'));
  if (scale.above) svg.append(svgElement('text', {x: 28 + BAR, y: 11}, '>'));
  for (const tick of scale.ticks()) {
    const x = 22 + BAR * scale.place(tick);
    svg.append(svgElement('path', {d: `M${x} 12v4`}), svgElement('text', {x, y: 28, 'text-anchor': 'middle'}, formatNumber(tick, 3)));
  }
  return svg;
}

function drawLegend(box, colours, field, scales) {
  const shown = CELLS.map((c, i) => ({scale: scales[i], unit: field.units[i], words: c.words})).filter((s, i) => s.scale && scales.indexOf(s.scale) === i);
  box.replaceChildren(element('strong', {}, field.label));
  box.title = field.doc;
  for (const {scale, unit, words: what} of shown) {
    const text = [shown.length > 1 ? what : '', unitText(unit) ? `[${unitText(unit)}]` : '', scale.log ? 'logarithmic' : ''].filter(Boolean).join(' ');
    if (text) box.append(element('span', {}, text));
    box.append(legendBar(colours, scale, unit));
  }
}

/** A round length of about a sixth of the picture. */
function drawScaleBar(box, pixelsPerMetre, width) {
  const metres = roundBelow(width / 6 / pixelsPerMetre), pixels = metres * pixelsPerMetre;
  const svg = svgElement('svg', {width: Math.ceil(pixels) + 2, height: 10, 'aria-hidden': 'true'});
  svg.append(svgElement('path', {d: `M1 1v8M1 5h${pixels}m0-4v8`, stroke: 'currentColor', 'stroke-width': 2, fill: 'none'}));
  box.replaceChildren(svg, element('span', {}, metres >= 1 ? `${metres} m` : `${formatNumber(1000 * metres)} mm`));
}
