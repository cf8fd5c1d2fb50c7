// SPDX-License-Identifier: BSD-3-Clause
// What is written over the picture: legend, scale bar, dimension lines. All of it as text, never as markup.

const SVG = 'http://www.w3.org/2000/svg';

function element(name, attributes = {}, text = '') {
  const node = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.textContent = text;
  return node;
}

function svgElement(name, attributes, text = '') {
  const node = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.textContent = text;
  return node;
}

function drawLegend(box, title, scale, unit) {
  box.replaceChildren(element('strong', {}, title));
  if (!scale) return;
  const svg = svgElement('svg', {width: 240, height: 34, role: 'img', 'aria-label': `colours from ${withUnit(scale.lo, unit)} to ${withUnit(scale.hi, unit)}`});
  for (let i = 0; i < 60; ++i) svg.append(svgElement('rect', {x: 4 * i, y: 0, width: 4.5, height: 12, fill: cssColour(colourAt(i / 59))}));
  [0, 1 / 3, 2 / 3, 1].forEach((place, i) => {
    const anchor = i === 0 ? 'start' : i === 3 ? 'end' : 'middle';
    svg.append(svgElement('text', {x: 240 * place, y: 28, 'text-anchor': anchor}, (i === 0 && scale.isCutBelow ? '< ' : '') + formatNumber(scale.value(place), 3)));
  });
  box.append(svg, element('span', {}, unitText(unit) + (scale.log ? ' (logarithmic)' : '')));
}

/** A round length of about a sixth of the picture. */
function drawScaleBar(box, pixelsPerMetre, width) {
  const wanted = width / 6 / pixelsPerMetre, power = Math.pow(10, Math.floor(Math.log10(wanted)));
  const metres = [5, 2, 1].find((n) => wanted >= n * power) * power, pixels = metres * pixelsPerMetre;
  const svg = svgElement('svg', {width: Math.ceil(pixels) + 2, height: 10, 'aria-hidden': 'true'});
  svg.append(svgElement('path', {d: `M1 1v8M1 5h${pixels}m0-4v8`, stroke: 'currentColor', 'stroke-width': 2, fill: 'none'}));
  box.replaceChildren(svg, element('span', {}, metres >= 1 ? `${metres} m` : `${formatNumber(1000 * metres)} mm`));
}

/** Nodes of a rope from its start to its end; null if there is no such part. */
function ropeNodes(result, name) {
  const part = name ? result.parts.findIndex((p) => p.name === name) : -1, nodes = [];
  for (let i = 0; i < result.barPart.length; ++i)
    if (result.barPart[i] === part) {
      if (!nodes.length) nodes.push(result.bar[2 * i]);
      nodes.push(result.bar[2 * i + 1]);
    }
  return nodes.length ? nodes : null;
}

/** Ends of the dimension lines of a gear: height of the headline, spread of both wing tips. */
function dimensions(model) {
  const {result, points} = model, lines = [];
  const at = (node) => [points[3 * node], points[3 * node + 1], points[3 * node + 2]];
  const mirror = (p) => [p[0], -2 * result.origin[1] - p[1], p[2]];
  const headline = ropeNodes(result, result.headline), footrope = ropeNodes(result, result.footrope);
  const middle = (nodes) => at(nodes[result.half ? 0 : Math.floor(nodes.length / 2)]);
  const spread = (nodes, words) => {
    const end = at(nodes[nodes.length - 1]), other = result.half ? mirror(end) : at(nodes[0]);
    lines.push({a: other, b: end, words, length: Math.hypot(...end.map((v, i) => v - other[i]))});
  };
  if (headline && (result.bed || footrope)) {
    const top = middle(headline), bed = result.bed;
    const foot = bed ? bed.slopeX * (top[0] + result.origin[0]) + bed.slopeY * (top[1] + result.origin[1]) - bed.depth - result.origin[2] : middle(footrope)[2];
    lines.push({a: top, b: [top[0], top[1], foot], words: 'headline height', length: top[2] - foot});
  }
  if (headline) spread(headline, 'upper wing spread');
  if (footrope) spread(footrope, 'lower wing spread');
  return lines;
}

function drawDimensions(svg, model, camera) {
  svg.replaceChildren();
  for (const line of dimensions(model)) {
    const a = camera.project(line.a), b = camera.project(line.b);
    if (Math.hypot(a[0] - b[0], a[1] - b[1]) < 12) continue;
    svg.append(svgElement('path', {d: `M${a[0]} ${a[1]}L${b[0]} ${b[1]}`, class: 'dimension'}));
    for (const end of [a, b]) svg.append(svgElement('circle', {cx: end[0], cy: end[1], r: 3, class: 'dimension'}));
    svg.append(svgElement('text', {x: (a[0] + b[0]) / 2 + 6, y: (a[1] + b[1]) / 2 - 6, class: 'dimension'}, `${line.words} ${formatNumber(line.length, 3)} m`));
  }
}
