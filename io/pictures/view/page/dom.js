// SPDX-License-Identifier: BSD-3-Clause
// Elements of the page. Texts of a result are inserted as text, never as markup.

const SVG = 'http://www.w3.org/2000/svg';
const $ = (id) => document.getElementById(id);

function filled(node, attributes, text) {
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.textContent = text;
  return node;
}

function element(name, attributes = {}, text = '') {
  return filled(document.createElement(name), attributes, text);
}

function svgElement(name, attributes, text = '') {
  return filled(document.createElementNS(SVG, name), attributes, text);
}

/** A colour of the page's style: '--ink'. */
function styleColour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}
