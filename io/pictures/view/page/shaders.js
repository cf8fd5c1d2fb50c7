// SPDX-License-Identifier: BSD-3-Clause
// Programs for the graphics card. Positions are in metres from the origin of the result.

const COMMON_VERTEX = `
precision highp float;
precision highp sampler2D;
uniform mat4 modelMatrix, viewMatrix, projectionMatrix;
uniform sampler2D partShown;
in float part;
bool isHidden() { return texelFetch(partShown, ivec2(int(part), 0), 0).r < 0.5; }
const vec4 kNowhere = vec4(2.0, 2.0, 2.0, 1.0);
`;

const COMMON_FRAGMENT = `
precision highp float;
uniform vec3 stops[9];
uniform vec2 range;
uniform bool isLog;
uniform vec3 noValue;
uniform vec4 section;
uniform vec3 plain;
uniform float usePlain;
out vec4 result;
vec3 colourOf(float value, vec3 partColour) {
  if (usePlain > 0.5) return plain;
  if (range.x > range.y) return partColour;
  if (isnan(value) || value < -1e37) return noValue;
  float place = isLog ? log(max(value, range.x) / range.x) / log(range.y / range.x) : (value - range.x) / (range.y - range.x);
  float at = clamp(place, 0.0, 1.0) * 8.0;
  int k = min(int(at), 7);
  return mix(stops[k], stops[k + 1], at - float(k));
}
void cut(vec3 world) { if (dot(world, section.xyz) > section.w) discard; }
`;

// Netting. Twines are the lines on which a twine coordinate is an integer. If they are closer than kCloseness
// pixels, only every second, fourth … twine is drawn; those that are about to be omitted fade out.
const NETTING_VERTEX = COMMON_VERTEX + `
in vec3 position;
in vec2 twines;
in float value, halfWidth;
in vec3 partColour;
out vec3 world, colourOfPart;
out vec2 uv;
out float shownValue, radius;
void main() {
  vec4 w = modelMatrix * vec4(position, 1.0);
  world = w.xyz; uv = twines; shownValue = value; radius = halfWidth; colourOfPart = partColour;
  gl_Position = isHidden() ? kNowhere : projectionMatrix * viewMatrix * w;
}`;

const NETTING_FRAGMENT = COMMON_FRAGMENT + `
uniform float pixelsPerMetre, fill;
uniform bool hasLines;
uniform vec3 eye;
in vec3 world, colourOfPart;
in vec2 uv;
in float shownValue, radius;
const float kCloseness = 5.0;
float twine(float u) {
  float perPixel = max(length(vec2(dFdx(u), dFdy(u))), 1e-9);
  float level = max(0.0, log2(perPixel * kCloseness));
  float spacing = exp2(floor(level)), n = round(u / spacing);
  float fade = mod(n, 2.0) < 0.5 ? 1.0 : 1.0 - fract(level);
  float pixels = abs(u - spacing * n) / perPixel, halfPixels = max(0.6, radius * pixelsPerMetre);
  return fade * clamp(halfPixels + 0.5 - pixels, 0.0, 1.0);
}
void main() {
  cut(world);
  vec3 normal = normalize(cross(dFdx(world), dFdy(world)));
  vec3 colour = colourOf(shownValue, colourOfPart);
  float light = 0.62 + 0.38 * abs(dot(normal, eye));
  if (hasLines) {
    float alpha = isnan(uv.x) || uv.x < -1e37 ? 0.0 : max(twine(uv.x), twine(uv.y));
    if (alpha < 0.1) discard;
    result = vec4(colour, alpha);
  } else {
    result = vec4(colour * light, fill);
  }
}`;

// Bars, drawn as ribbons that face the eye, with their true width but at least a few pixels wide.
const ROPE_VERTEX = COMMON_VERTEX + `
in vec2 corner;
in vec3 from, to;
in float value, halfWidth;
in vec3 partColour;
uniform vec3 eye;
uniform float pixelsPerMetre, leastPixels;
out vec3 world, colourOfPart;
out float shownValue, across;
void main() {
  vec3 a = (modelMatrix * vec4(from, 1.0)).xyz, b = (modelMatrix * vec4(to, 1.0)).xyz;
  float width = max(halfWidth, leastPixels / pixelsPerMetre);
  vec3 along = b - a, side = cross(along, eye);
  side = length(side) > 1e-9 ? normalize(side) : vec3(0.0);
  vec3 ahead = length(along) > 1e-9 ? normalize(along) : vec3(0.0);
  world = mix(a, b, corner.x) + side * corner.y * width + ahead * (corner.x - 0.5) * width;
  shownValue = value; across = corner.y; colourOfPart = partColour;
  gl_Position = isHidden() ? kNowhere : projectionMatrix * viewMatrix * vec4(world, 1.0);
}`;

const ROPE_FRAGMENT = COMMON_FRAGMENT + `
in vec3 world, colourOfPart;
in float shownValue, across;
void main() {
  cut(world);
  result = vec4(colourOf(shownValue, colourOfPart) * (0.55 + 0.45 * sqrt(max(0.0, 1.0 - across * across))), 1.0);
}`;

// Floats and other elements on single nodes, drawn as spheres.
const BALL_VERTEX = COMMON_VERTEX + `
in vec2 corner;
in vec3 centre;
in float value, halfWidth;
in vec3 partColour;
uniform vec3 right, up;
uniform float pixelsPerMetre, leastPixels;
out vec3 world, colourOfPart;
out vec2 onDisc;
out float shownValue;
void main() {
  float radius = max(halfWidth, leastPixels / pixelsPerMetre);
  world = (modelMatrix * vec4(centre, 1.0)).xyz + (right * corner.x + up * corner.y) * radius;
  onDisc = corner; shownValue = value; colourOfPart = partColour;
  gl_Position = isHidden() ? kNowhere : projectionMatrix * viewMatrix * vec4(world, 1.0);
}`;

const BALL_FRAGMENT = COMMON_FRAGMENT + `
in vec3 world, colourOfPart;
in vec2 onDisc;
in float shownValue;
void main() {
  cut(world);
  float r = dot(onDisc, onDisc);
  if (r > 1.0) discard;
  result = vec4(colourOf(shownValue, colourOfPart) * (0.45 + 0.55 * sqrt(1.0 - r)), 1.0);
}`;

// Plates of rigid bodies: drawn like netting, but solid.
const PLATE_VERTEX = COMMON_VERTEX + `
in vec3 position;
in float value;
in vec3 partColour;
out vec3 world, colourOfPart;
out float shownValue;
void main() {
  vec4 w = modelMatrix * vec4(position, 1.0);
  world = w.xyz; shownValue = value; colourOfPart = partColour;
  gl_Position = isHidden() ? kNowhere : projectionMatrix * viewMatrix * w;
}`;

const PLATE_FRAGMENT = COMMON_FRAGMENT + `
uniform vec3 eye;
in vec3 world, colourOfPart;
in float shownValue;
void main() {
  cut(world);
  vec3 normal = normalize(cross(dFdx(world), dFdy(world)));
  result = vec4(colourOf(shownValue, colourOfPart) * (0.62 + 0.38 * abs(dot(normal, eye))), 1.0);
}`;

// Solids that are not parts of the gear: the catch, the ship.
const SOLID_VERTEX = `
precision highp float;
uniform mat4 modelMatrix, viewMatrix, projectionMatrix;
in vec3 position, plane;
out vec3 world, facing;  // facing: the normal of parts that are lit like a plane; zero for others
void main() {
  vec4 w = modelMatrix * vec4(position, 1.0);
  world = w.xyz; facing = plane;
  gl_Position = projectionMatrix * viewMatrix * w;
}`;

const SOLID_FRAGMENT = `
precision highp float;
uniform vec3 colour, eye;
uniform vec4 section;
in vec3 world, facing;
out vec4 result;
void main() {
  if (dot(world, section.xyz) > section.w) discard;
  vec3 normal = dot(facing, facing) > 0.5 ? facing : normalize(cross(dFdx(world), dFdy(world)));
  result = vec4(colour * (0.62 + 0.38 * abs(dot(normal, eye))), 1.0);
}`;

// The bed and the water surface, with a grid of whole metres.
const GROUND_VERTEX = `
precision highp float;
uniform mat4 modelMatrix, viewMatrix, projectionMatrix;
in vec3 position;
out vec3 world;
void main() { world = position; gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0); }`;

const GROUND_FRAGMENT = `
precision highp float;
uniform vec3 colour, offset;
uniform float pixelsPerMetre, opacity;
in vec3 world;
out vec4 result;
float line(float x, float step) {
  float d = abs(x / step - round(x / step)) * step, pixel = max(fwidth(x), 1e-9);
  return clamp(1.2 - d / pixel, 0.0, 1.0) * clamp(step / pixel / 8.0 - 0.5, 0.0, 1.0);
}
void main() {
  vec2 at = world.xy + offset.xy;
  float grid = max(max(line(at.x, 1.0), line(at.y, 1.0)) * 0.5, max(line(at.x, 10.0), line(at.y, 10.0)));
  result = vec4(colour, opacity * (0.25 + 0.75 * grid));
}`;
