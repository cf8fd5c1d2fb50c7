// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <string>

namespace netloft::io {

/// Red, green and blue from 0 to 1.
using Colour = std::array<float, 3>;

/// Viridis (S. van der Walt and N. Smith, matplotlib, CC0) from 0 to 1: its brightness rises evenly, so that
/// it survives colour blindness and grey printing. The same stops are in ../view/page/colours.js.
Colour colour_at(double place);

/// One of eight colours that colour-blind readers tell apart (M. Okabe and K. Ito, 2008); then they repeat.
Colour colour_of_part(std::uint32_t part);

/// "#21908d"
std::string hex(const Colour& colour);

/// From values to places on the colour map; a logarithmic one spans four decades at most.
class ColourScale {
 public:
  ColourScale(double lo, double hi, bool logarithmic);
  double place(double value) const;
  double value(double place) const;
  bool is_logarithmic() const { return logarithmic_; }

 private:
  bool logarithmic_;
  double lo_, hi_;
};

}  // namespace netloft::io
