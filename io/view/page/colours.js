// SPDX-License-Identifier: BSD-3-Clause
// Colours of fields: viridis, whose brightness rises evenly, so that it survives colour blindness and grey printing
// (S. van der Walt and N. Smith, matplotlib, CC0). Colours of parts: M. Okabe and K. Ito, Color Universal Design, 2008.

const VIRIDIS = ['#440154', '#472c7a', '#3b518b', '#2c718e', '#21908d', '#27ad81', '#5cc863', '#aadc32', '#fde725'];
const PART_COLOURS = ['#56b4e9', '#e69f00', '#009e73', '#f0e442', '#0072b2', '#d55e00', '#cc79a7', '#999999'];

function rgbOf(hex) {
  return [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255);
}

const STOPS = VIRIDIS.map(rgbOf);

function colourAt(place) {
  const at = Math.min(Math.max(place, 0), 1) * (STOPS.length - 1);
  const k = Math.min(Math.floor(at), STOPS.length - 2);
  return STOPS[k].map((a, i) => a + (at - k) * (STOPS[k + 1][i] - a));
}

function cssColour(rgb) {
  return `rgb(${rgb.map((c) => Math.round(255 * c)).join(',')})`;
}

function partColour(part) {
  return rgbOf(PART_COLOURS[part % PART_COLOURS.length]);
}

/** From values to places on the colour map; `log` for values over several decades. */
class Scale {
  constructor(lo, hi, log) {
    this.log = log && hi > 0;
    this.hi = hi;
    this.lo = this.log ? Math.max(lo, hi * 1e-4) : lo;
    if (!(this.hi > this.lo)) this.hi = this.lo + (Math.abs(this.lo) || 1);
  }
  place(value) {
    if (this.log) return Math.log(Math.max(value, this.lo) / this.lo) / Math.log(this.hi / this.lo);
    return (value - this.lo) / (this.hi - this.lo);
  }
  value(place) {
    return this.log ? this.lo * Math.pow(this.hi / this.lo, place) : this.lo + place * (this.hi - this.lo);
  }
}

/** A number for people: four digits, without an exponent where it stays readable. */
function formatNumber(value, digits = 4) {
  if (!Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  return size >= 1e6 || size < 1e-3 ? value.toExponential(digits - 1) : String(Number(value.toPrecision(digits)));
}

function unitText(unit) {
  return unit === '1' ? '' : unit.replace('m2', 'm²').replace('m3', 'm³');
}

function withUnit(value, unit) {
  const suffix = unitText(unit);
  return suffix ? `${formatNumber(value)} ${suffix}` : formatNumber(value);
}
