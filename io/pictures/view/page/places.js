// SPDX-License-Identifier: BSD-3-Clause
// The same place in two results of one gear, even if their meshes differ.

/** Triangles of netting by part, in a grid over the plan, and nodes by part and number. */
class Places {
  constructor(result) {
    this.result = result;
    this.byNumber = new Map();
    for (let n = 0; n < result.nPoints; ++n) this.byNumber.set(this.key(result, n), n);
    this.boxes = new Map();
    for (let t = 0; t < result.triPart.length; ++t) this.enter(t);
  }

  key(result, node) { return `${result.parts[result.nodePart[node]].name} ${result.nodeNumber[node]}`; }

  cornersOf(t) { return [0, 1, 2].map((k) => [this.result.triUV[6 * t + 2 * k], this.result.triUV[6 * t + 2 * k + 1]]); }

  enter(t) {
    const corners = this.cornersOf(t), name = this.result.parts[this.result.triPart[t]].name;
    if (!corners.flat().every(Number.isFinite)) return;
    const [u, v] = [0, 1].map((k) => corners.map((c) => Math.floor(c[k] / Places.GRID)));
    for (let i = Math.min(...u); i <= Math.max(...u); ++i)
      for (let j = Math.min(...v); j <= Math.max(...v); ++j) {
        const box = `${name} ${i} ${j}`;
        if (!this.boxes.has(box)) this.boxes.set(box, []);
        this.boxes.get(box).push(t);
      }
  }

  /** Nodes and weights of a place on a panel; null: the panel is not there, or does not reach so far. */
  onPanel(name, U, V) {
    const near = this.boxes.get(`${name} ${Math.floor(U / Places.GRID)} ${Math.floor(V / Places.GRID)}`) || [];
    for (const t of near) {
      const weights = barycentric([U, V], ...this.cornersOf(t));
      if (weights) return {nodes: [0, 1, 2].map((k) => this.result.tri[3 * t + k]), weights, cell: this.result.triCell[t]};
    }
    return null;
  }

  /** The node of the same part and number, if both results have as many nodes. */
  sameNode(result, node) {
    const found = result.nPoints === this.result.nPoints ? this.byNumber.get(this.key(result, node)) : undefined;
    return found === undefined ? null : {nodes: [found], weights: [1]};
  }
}
Places.GRID = 8;  // meshes

/** The same cells of two results: for every cell of the first its place in the second, or null. */
function pairCells(first, second) {
  const places = new Places(second), pairs = new Array(first.nCells).fill(null), isSame = first.nPoints === second.nPoints && first.nCells === second.nCells;
  for (const c of CELLS)
    first[c.cells].forEach((cell, i) => {
      const nodes = nodesOfElement(first, c.kind, i);
      const others = nodes.map((node, k) => isSame ? places.sameNode(first, node)
        : c.kind === 'netting' ? places.onPanel(first.parts[first[c.parts][i]].name, first.triUV[6 * i + 2 * k], first.triUV[6 * i + 2 * k + 1]) : null);
      if (others.every(Boolean)) pairs[cell] = {nodes, others, cell: isSame ? cell : others[0].cell};
    });
  return pairs;
}
