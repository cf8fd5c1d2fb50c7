// SPDX-License-Identifier: BSD-3-Clause
// The three kinds of cells of a result: netting, bars of ropes, and elements on single nodes.

const CELLS = [
  {kind: 'netting', of: 3, nodes: 'tri', cells: 'triCell', parts: 'triPart', words: 'netting'},
  {kind: 'rope', of: 2, nodes: 'bar', cells: 'barCell', parts: 'barPart', words: 'ropes'},
  {kind: 'point', of: 1, nodes: 'dot', cells: 'dotCell', parts: 'dotPart', words: 'single nodes'},
];

function cellsOf(kind) {
  return CELLS.find((c) => c.kind === kind);
}

/** The nodes of element `index` of a kind. */
function nodesOfElement(result, kind, index) {
  const c = cellsOf(kind);
  return Array.from(result[c.nodes].subarray(c.of * index, c.of * index + c.of));
}

/** Element `place` of all elements of a result, counted kind by kind: {kind, index}. */
function elementAt(result, place) {
  for (const c of CELLS) {
    const n = result[c.parts].length;
    if (place < n) return {kind: c.kind, index: place};
    place -= n;
  }
  return null;
}

/** The inverse of elementAt. */
function placeOfElement(result, {kind, index}) {
  return CELLS.slice(0, CELLS.indexOf(cellsOf(kind))).reduce((sum, c) => sum + result[c.parts].length, index);
}

/** Sides of triangles that no other triangle of the part has: the outlines of its panels. */
function outline(result) {
  const sides = new Map(), n = result.nPoints;
  for (let t = 0; t < result.triPart.length; ++t)
    for (let k = 0; k < 3; ++k) {
      const a = result.tri[3 * t + k], b = result.tri[3 * t + (k + 1) % 3];
      const key = (result.triPart[t] * n + Math.min(a, b)) * n + Math.max(a, b);
      sides.set(key, sides.has(key) ? null : {a, b, part: result.triPart[t], cell: result.triCell[t]});
    }
  const border = [...sides.values()].filter(Boolean);
  return {nodes: Uint32Array.from(border.flatMap((s) => [s.a, s.b])), parts: border.map((s) => s.part), cells: border.map((s) => s.cell)};
}

/**
 * Values at the corners of triangles: means over the triangles of a part that share the node. A field is constant in each
 * triangle; where some are slack and their neighbours taut, the mean is what the netting bears.
 */
function valuesAtCorners(result, byCell) {
  const {tri, triPart, triCell} = result, n = triPart.length, sums = new Map(), out = new Float32Array(3 * n);
  const key = (t, k) => triPart[t] * result.nPoints + tri[3 * t + k];
  for (let t = 0; t < n; ++t) {
    const value = byCell[triCell[t]];
    if (!Number.isFinite(value)) continue;
    for (let k = 0; k < 3; ++k) {
      const sum = sums.get(key(t, k));
      if (sum) { sum.value += value; ++sum.count; } else sums.set(key(t, k), {value, count: 1});
    }
  }
  for (let t = 0; t < n; ++t)
    for (let k = 0; k < 3; ++k) {
      const sum = sums.get(key(t, k));
      out[3 * t + k] = sum && Number.isFinite(byCell[triCell[t]]) ? sum.value / sum.count : NaN;
    }
  return out;
}
