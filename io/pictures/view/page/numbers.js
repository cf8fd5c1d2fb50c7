// SPDX-License-Identifier: BSD-3-Clause
// Numbers, units and names in the form in which people read them.

/** Four digits, without an exponent where it stays readable. */
function formatNumber(value, digits = 4) {
  if (!Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  const rounded = Number(value.toPrecision(digits));
  return size >= 1e6 || size < 1e-3 ? rounded.toExponential() : String(rounded);
}

function unitText(unit) {
  return unit === '1' ? '' : unit.replace('m2', 'm²').replace('m3', 'm³');
}

function withUnit(value, unit) {
  const suffix = unitText(unit);
  return suffix ? `${formatNumber(value)} ${suffix}` : formatNumber(value);
}

/** Three digits, thousands of newtons as kN: as the boxes on top of the page have them. */
function shortText(value, unit) {
  const [number, of] = unit === 'N' && Math.abs(value) >= 1000 ? [value / 1000, 'kN'] : [value, unitText(unit)];
  return of ? `${formatNumber(number, 3)} ${of}` : formatNumber(number, 3);
}

/** 'half_angle' and 'mouth/headline_height' as people say them. */
function words(name) {
  return name.replaceAll('_', ' ').replaceAll('/', ', ');
}

/** 1, 2 or 5 times a power of ten: the largest that is not above `most`. */
function roundBelow(most) {
  const power = Math.pow(10, Math.floor(Math.log10(most)));
  return (most >= 5 * power ? 5 : most >= 2 * power ? 2 : 1) * power;
}

function roundAbove(least) {
  const power = Math.pow(10, Math.floor(Math.log10(least)));
  return [1, 2, 5, 10].map((digit) => digit * power).find((round) => round >= least * (1 - 1e-9));
}
