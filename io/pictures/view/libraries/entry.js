// SPDX-License-Identifier: BSD-3-Clause
// Everything that the viewer uses of its libraries. Names that are not listed here are left out of the
// bundle.
export {
  BufferAttribute, BufferGeometry, Color, DataTexture, DoubleSide, GLSL3, Group, Mesh, OrthographicCamera, RawShaderMaterial, Scene, Vector2, Vector3, Vector4, WebGLRenderer,
} from 'three';
export {default as uPlot} from 'uplot';
