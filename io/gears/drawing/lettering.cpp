// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/drawing/lettering.hpp"

#include <algorithm>
#include <sstream>

namespace netloft::gears {

namespace {

constexpr double kMeanLetter =
    0.58;  // mean width of a letter of Noto Sans relative to its size; most other fonts are narrower
constexpr double kRim = 4;      // least distance of texts from the edge of the drawing
constexpr double kBetween = 4;  // texts on one line that are closer than this look like one text
// Largest number of texts whose places are stored. With so many texts, a sheet is full, and further texts
// find no free place.
constexpr std::size_t kMostAvoided = 2000;

double size_of(std::size_t line) { return line == 0 ? Lettering::kNormal : Lettering::kSmall; }

}  // namespace

double Lettering::length_of(const std::string& text, double size) {
  // Bytes that continue a UTF-8 character do not count as letters.
  const auto letters = std::count_if(text.begin(), text.end(),
                                     [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; });
  return kMeanLetter * size * static_cast<double>(letters);
}

Lettering::Area Lettering::area_of(formats::PicturePoint at, const std::string& text, double size,
                                   formats::Anchor anchor) {
  const double length = length_of(text, size);
  const double left = at.x - (anchor == formats::Anchor::end      ? length
                              : anchor == formats::Anchor::middle ? length / 2
                                                                  : 0);
  return {left, left + length, at.y - 0.75 * size, at.y + 0.22 * size};
}

Lettering::Area Lettering::area_of(const TextBlock& block, std::size_t line) {
  const formats::PicturePoint at{block.at.x, block.at.y + kLeading * static_cast<double>(line)};
  return area_of(at, block.lines[line], size_of(line), block.anchor);
}

void Lettering::write(formats::PicturePoint at, const std::string& text, double size, const char* colour,
                      formats::Anchor anchor) {
  const Area area = area_of(at, text, size, anchor);
  at.x += std::min(0.0, width_ - kRim - area.right);
  at.x += std::max(0.0, kRim - area.left);
  if (taken_.size() < kMostAvoided) taken_.push_back(area_of(at, text, size, anchor));
  drawing_.text(at, text, size, colour, anchor);
}

void Lettering::write(const TextBlock& block, const char* colour) {
  for (std::size_t i = 0; i < block.lines.size(); ++i)
    write({block.at.x, block.at.y + kLeading * static_cast<double>(i)}, block.lines[i], size_of(i), colour,
          block.anchor);
}

double Lettering::overlap(const TextBlock& block) const {
  double sum = 0;
  for (std::size_t i = 0; i < block.lines.size(); ++i) {
    const Area own = area_of(block, i);
    const double height = own.bottom - own.top;
    sum += height * (std::max(0.0, kRim - own.left) + std::max(0.0, own.right - width_ + kRim));
    for (const Area& other : taken_) {
      const double across = std::min(own.right, other.right) - std::max(own.left, other.left) + kBetween;
      const double down = std::min(own.bottom, other.bottom) - std::max(own.top, other.top);
      if (across > 0 && down > 0) sum += across * down;
    }
  }
  return sum;
}

std::vector<std::string> broken_into_lines(const std::string& text, double size, double longest) {
  std::vector<std::string> lines{""};
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (lines.back().empty() || Lettering::length_of(longer, size) <= longest)
      lines.back() = longer;
    else
      lines.push_back(word);
  }
  return lines;
}

}  // namespace netloft::gears
