// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/palette.hpp"

#include <algorithm>
#include <map>
#include <span>

namespace netloft::pictures {

namespace {

using Rgb = Palette::Rgb;
constexpr std::size_t kMostColours = 256;

/// A colour of the picture, and the number of pixels with this colour.
struct Counted {
  Rgb colour;
  std::size_t pixels;
};

using Box = std::span<Counted>;

std::vector<Counted> count_colours(const Image& image) {
  std::map<Rgb, std::size_t> counts;
  for (std::size_t i = 0; i + 2 < image.bytes.size(); i += 3)
    ++counts[{image.bytes[i], image.bytes[i + 1], image.bytes[i + 2]}];
  std::vector<Counted> all;
  for (const auto& [colour, pixels] : counts) all.push_back({colour, pixels});
  return all;
}

std::size_t pixels_in(Box box) {
  std::size_t sum = 0;
  for (const auto& one : box) sum += one.pixels;
  return sum;
}

/// The colour axis along which a box is longest, and its length along this axis.
std::pair<std::size_t, int> longest_side(Box box) {
  std::pair<std::size_t, int> longest{0, -1};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [lo, hi] =
        std::minmax_element(box.begin(), box.end(),
                            [k](const Counted& a, const Counted& b) { return a.colour[k] < b.colour[k]; });
    const int length = hi->colour[k] - lo->colour[k];
    if (length > longest.second) longest = {k, length};
  }
  return longest;
}

/// The index at which to cut a box. About half of its pixels are then on either side, and neither side is
/// empty.
std::size_t median_of(Box box) {
  const std::size_t half = pixels_in(box) / 2;
  std::size_t sum = 0, at = 0;
  while (at + 1 < box.size() && sum + box[at].pixels <= half) sum += box[at++].pixels;
  return std::max<std::size_t>(at, 1);
}

/// The benefit of dividing a box.
double worth(Box box) {
  return box.size() < 2 ? 0 : longest_side(box).second * static_cast<double>(pixels_in(box));
}

Rgb mean_of(Box box) {
  std::array<double, 3> sum{};
  for (const auto& one : box)
    for (std::size_t k = 0; k < 3; ++k) sum[k] += one.colour[k] * static_cast<double>(one.pixels);
  Rgb mean;
  for (std::size_t k = 0; k < 3; ++k)
    mean[k] = static_cast<std::uint8_t>(sum[k] / static_cast<double>(pixels_in(box)) + 0.5);
  return mean;
}

std::vector<Box> divide(std::vector<Counted>& colours) {
  std::vector<std::pair<double, Box>> boxes{{worth(colours), colours}};
  while (boxes.size() < kMostColours) {
    const auto most = std::max_element(boxes.begin(), boxes.end(),
                                       [](const auto& a, const auto& b) { return a.first < b.first; });
    if (most->first <= 0) break;
    const Box box = most->second;
    const std::size_t k = longest_side(box).first;
    std::sort(box.begin(), box.end(), [k](const Counted& a, const Counted& b) {
      return a.colour[k] != b.colour[k] ? a.colour[k] < b.colour[k] : a.colour < b.colour;
    });
    const std::size_t cut = median_of(box);
    *most = {worth(box.first(cut)), box.first(cut)};
    boxes.emplace_back(worth(box.subspan(cut)), box.subspan(cut));
  }
  std::vector<Box> plain;
  for (const auto& [gain, box] : boxes) plain.push_back(box);
  return plain;
}

}  // namespace

Palette palette_of(const Image& image) {
  auto colours = count_colours(image);
  Palette palette;
  std::map<Rgb, std::uint8_t> number;
  if (!colours.empty())
    for (const Box box : divide(colours)) {
      for (const auto& one : box) number[one.colour] = static_cast<std::uint8_t>(palette.colours.size());
      palette.colours.push_back(mean_of(box));
    }
  for (std::size_t i = 0; i + 2 < image.bytes.size(); i += 3)
    palette.pixels.push_back(number[{image.bytes[i], image.bytes[i + 1], image.bytes[i + 2]}]);
  return palette;
}

}  // namespace netloft::pictures
