// SPDX-License-Identifier: BSD-3-Clause
// Maps values to places on the colour map, and to the colours there. The colours come with the data and are
// those of the pictures of `netloft draw`.

class Scale {
  /** `ends`: {lo, hi, below, above}; `below`, `above`: there are values beyond. */
  constructor(ends, log) {
    Object.assign(this, ends);
    this.log = log && ends.lo > 0;
    if (!(this.hi > this.lo)) this.hi = this.lo + (Math.abs(this.lo) || 1);
  }
  place(value) {
    const at = this.log ? Math.log(Math.max(value, this.lo) / this.lo) / Math.log(this.hi / this.lo) : (value - this.lo) / (this.hi - this.lo);
    return Math.min(Math.max(at, 0), 1);
  }
  /** Round values within the ends. */
  ticks() {
    const ticks = [];
    if (!this.log) {
      const step = roundAbove((this.hi - this.lo) / 6);
      for (let k = Math.ceil(this.lo / step - 1e-9); k * step <= this.hi + 1e-9 * step; ++k) ticks.push(k * step);
      return ticks;
    }
    for (let power = Math.pow(10, Math.floor(Math.log10(this.lo))); power <= this.hi; power *= 10)
      for (const digit of this.hi < 100 * this.lo ? [1, 2, 5] : [1])
        if (digit * power >= this.lo * (1 - 1e-9) && digit * power <= this.hi * (1 + 1e-9)) ticks.push(digit * power);
    return ticks;
  }
}

class Colours {
  constructor(style) { Object.assign(this, style); }
  at(place) {
    const at = Math.min(Math.max(place, 0), 1) * (this.stops.length - 1), k = Math.min(Math.floor(at), this.stops.length - 2);
    return this.stops[k].map((a, i) => a + (at - k) * (this.stops[k + 1][i] - a));
  }
  ofPart(part) { return this.parts[part % this.parts.length]; }
}

function cssColour(rgb) {
  return `rgb(${rgb.map((c) => Math.round(255 * c)).join(',')})`;
}
