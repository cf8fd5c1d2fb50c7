// SPDX-License-Identifier: BSD-3-Clause
// All that the viewer uses of its libraries; what is not named here is left out of the bundle.
export {
  BufferAttribute, BufferGeometry, Color, DataTexture, DoubleSide, GLSL3, Group, Mesh, OrthographicCamera, RawShaderMaterial, Scene, Vector2, Vector3, Vector4, WebGLRenderer,
} from 'three';
export {default as uPlot} from 'uplot';
