// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/drawn_text.hpp"

#include "io/pictures/picture/font_file.hpp"

#include <stb/stb_truetype.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace netloft::pictures {

namespace {

const stbtt_fontinfo& font() {
  static const stbtt_fontinfo info = [] {
    stbtt_fontinfo opened{};
    stbtt_InitFont(&opened, kFontFile, 0);
    return opened;
  }();
  return info;
}

/// Pixels per unit of the font.
float scale_of(double size) { return stbtt_ScaleForMappingEmToPixels(&font(), static_cast<float>(size)); }

/// The characters of a UTF-8 text; U+FFFD for invalid bytes.
std::vector<int> characters(const std::string& text) {
  std::vector<int> all;
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i++]);
    const int more = first < 0x80 ? 0 : first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : first >= 0xc0 ? 1 : -1;
    int code = more <= 0 ? first : first & (0x3f >> more);
    int read = 0;
    for (; read < more && i < text.size() && (static_cast<unsigned char>(text[i]) & 0xc0) == 0x80; ++read)
      code = code << 6 | (static_cast<unsigned char>(text[i++]) & 0x3f);
    all.push_back(more < 0 || read < more ? 0xfffd : code);
  }
  return all;
}

float pixels_to_next(int character, float scale) {
  int advance = 0, bearing = 0;
  stbtt_GetCodepointHMetrics(&font(), character, &advance, &bearing);
  return scale * static_cast<float>(advance);
}

void blend(Image& image, long x, long y, const Colour& colour, float opacity) {
  if (x < 0 || y < 0 || x >= static_cast<long>(image.width) || y >= static_cast<long>(image.height)) return;
  const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
  Colour mixed = image.at(column, row);
  for (std::size_t k = 0; k < 3; ++k) mixed[k] += opacity * (colour[k] - mixed[k]);
  image.set(column, row, mixed);
}

/// Writes one letter at (x, y). Its position along the line is exact to a fraction of a pixel.
void write_letter(Image& image, double x, double y, int character, float scale, const Colour& colour) {
  const double whole = std::floor(x);
  const auto shift = static_cast<float>(x - whole);
  std::array<int, 4> box{};
  stbtt_GetCodepointBitmapBoxSubpixel(&font(), character, scale, scale, shift, 0, &box[0], &box[1], &box[2],
                                      &box[3]);
  const int width = box[2] - box[0], height = box[3] - box[1];
  if (width <= 0 || height <= 0) return;
  std::vector<unsigned char> cover(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  stbtt_MakeCodepointBitmapSubpixel(&font(), cover.data(), width, height, width, scale, scale, shift, 0,
                                    character);
  const long left = std::lround(whole) + box[0], top = std::lround(y) + box[1];
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      blend(image, left + column, top + row, colour,
            static_cast<float>(cover[static_cast<std::size_t>(row * width + column)]) / 255);
}

}  // namespace

std::vector<Glyph> glyphs_of(const std::string& text) {
  std::vector<Glyph> glyphs;
  for (const int character : characters(text))
    glyphs.push_back({stbtt_FindGlyphIndex(&font(), character), character});
  return glyphs;
}

double advance_of(int character) { return static_cast<double>(pixels_to_next(character, scale_of(1))); }

FontBox font_box() {
  std::array<int, 4> box{};
  stbtt_GetFontBoundingBox(&font(), &box[0], &box[1], &box[2], &box[3]);
  const auto em = static_cast<double>(scale_of(1));
  return {em * box[0], em * box[1], em * box[2], em * box[3]};
}

double text_width(const std::string& text, double size) {
  double width = 0;
  for (const int character : characters(text))
    width += static_cast<double>(pixels_to_next(character, scale_of(size)));
  return width;
}

void write_text(Image& image, double x, double y, const std::string& text, double size,
                const Colour& colour) {
  const float scale = scale_of(size);
  for (const int character : characters(text)) {
    write_letter(image, x, y, character, scale, colour);
    x += static_cast<double>(pixels_to_next(character, scale));
  }
}

}  // namespace netloft::pictures
