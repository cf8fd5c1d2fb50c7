// SPDX-License-Identifier: BSD-3-Clause
// The numbers of the page: base64 of deflated, byte-shuffled arrays, little-endian.

const KINDS = {f32: Float32Array, u32: Uint32Array};

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

async function inflate(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Puts bytes that were stored by their place in a number (all first ones, all second ones …) in order again. */
function unshuffle(bytes, width) {
  const n = bytes.length / width;
  const out = new Uint8Array(bytes.length);
  for (let k = 0; k < width; ++k) for (let i = 0; i < n; ++i) out[i * width + k] = bytes[k * n + i];
  return out;
}

async function decodeArray(packed) {
  const Kind = KINDS[packed.t];
  if (packed.n === 0) return new Kind(0);
  const bytes = unshuffle(await inflate(bytesOf(packed.d)), Kind.BYTES_PER_ELEMENT);
  if (bytes.length !== packed.n * Kind.BYTES_PER_ELEMENT) throw new Error('the page is damaged: an array has a wrong length');
  return new Kind(bytes.buffer);
}

/** Unpacks some members of an object, which are arrays then. */
async function decodeMembers(object, names) {
  const arrays = await Promise.all(names.map((name) => decodeArray(object[name])));
  names.forEach((name, i) => { object[name] = arrays[i]; });
}

const MESH_ARRAYS = ['tri', 'triUV', 'triPart', 'triCell', 'bar', 'barPart', 'barCell', 'dot', 'dotPart', 'dotCell',
                     'nodePart', 'nodeNumber', 'plateDot'];

/** Unpacks the mesh of a result; states are unpacked when they are shown. */
async function decodeResult(result) {
  await decodeMembers(result, MESH_ARRAYS);
  if (result.catch) await decodeMembers(result.catch, ['triangles', 'rim']);
  return result;
}

async function decodeState(result, index) {
  const state = result.states[index];
  if (!state.ready) {
    state.ready = (async () => {
      await decodeMembers(state, ['points', 'plates', 'hulls', 'residual', 'reaction'].filter((name) => state[name]));
      state.fields = await Promise.all(state.fields.map(decodeArray));
      return state;
    })();
  }
  return state.ready;
}
