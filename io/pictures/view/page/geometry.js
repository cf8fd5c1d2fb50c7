// SPDX-License-Identifier: BSD-3-Clause
// Arrays in the form that the renderer needs.

const L = Libraries;
const NONE = -1e38;  // means "no value" for the graphics card, which may not support NaN

function setAttributes(geometry, attributes) {
  for (const [name, [array, size]] of Object.entries(attributes)) geometry.setAttribute(name, new L.BufferAttribute(array, size));
}

/** Every item of an array (`size` numbers) four times: for the corners of a square. */
function fourfold(array, size) {
  const out = new Float32Array(4 * array.length);
  for (let i = 0; i < array.length; i += size)
    for (let corner = 0; corner < 4; ++corner) for (let k = 0; k < size; ++k) out[4 * i + size * corner + k] = array[i + k];
  return out;
}

/** n squares with four corners each. Not instances of one: software renderers draw those one after another. */
function squares(corners, n, attributes) {
  const geometry = new L.BufferGeometry(), index = new Uint32Array(6 * n), corner = new Float32Array(8 * n);
  for (let i = 0; i < n; ++i) {
    index.set([4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 2, 4 * i + 1, 4 * i + 3], 6 * i);
    corner.set(corners, 8 * i);
  }
  geometry.setIndex(new L.BufferAttribute(index, 1));
  setAttributes(geometry, {corner: [corner, 2]});
  for (const [name, [array, size]] of Object.entries(attributes)) setAttributes(geometry, {[name]: [fourfold(array, size), size]});
  return geometry;
}

/** Copies the positions of every `step`th node from `first` on into an attribute, each `times` times. */
function gather(into, nodes, points, first, step, times) {
  const out = into.array;
  for (let i = first, k = 0; i < nodes.length; i += step) {
    const node = 3 * nodes[i];
    for (let copy = 0; copy < times; ++copy) { out[k++] = points[node]; out[k++] = points[node + 1]; out[k++] = points[node + 2]; }
  }
  into.needsUpdate = true;
}

/** Copies values into an attribute, each `times` times; what is not known becomes NONE. */
function putValues(into, count, valueAt, times) {
  const out = into.array;
  for (let i = 0; i < count; ++i) {
    const v = valueAt(i);
    for (let k = 0; k < times; ++k) out[times * i + k] = Number.isFinite(v) ? v : NONE;
  }
  into.needsUpdate = true;
}
