// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/pdf_picture.hpp"

#include "io/pictures/picture/base64.hpp"
#include "io/pictures/picture/colour_map.hpp"
#include "io/pictures/picture/drawn_text.hpp"
#include "io/pictures/picture/font_file.hpp"

#include <fmt/format.h>

#include <vector>

namespace netloft::pictures {

namespace {

constexpr double kPoint = 0.75;  // points in a pixel of CSS: 72/96

std::string rgb(const char* colour) {
  const Colour c = colour_of(colour);
  return fmt::format("{:.3f} {:.3f} {:.3f}", c[0], c[1], c[2]);
}

/// A stream object: a dictionary with some entries, and deflated bytes.
std::string stream(Bytes bytes, const std::string& entries = "") {
  const std::string packed = deflated(bytes);
  return fmt::format("<< /Length {} /Filter /FlateDecode{} >>\nstream\n", packed.size(), entries) + packed +
         "\nendstream";
}

/// Widths of glyphs in thousandths of the font size: "7 [556] 12 [278]".
std::string widths_of(const std::map<int, int>& characters) {
  std::string widths;
  for (const auto& [glyph, character] : characters)
    widths += fmt::format("{} [{:.0f}] ", glyph, 1000 * advance_of(character));
  return widths;
}

/// The character of each glyph, by which programs search and copy texts.
std::string characters_of(const std::map<int, int>& characters) {
  std::string map =
      "/CIDInit /ProcSet findresource begin\n12 dict begin\nbegincmap\n/CMapName /Letters def\n/CMapType 2 "
      "def\n1 begincodespacerange\n<0000> <FFFF>\nendcodespacerange\n";
  for (const auto& [glyph, character] : characters)  // the letters of the font have codes of four digits
    if (glyph > 0) map += fmt::format("1 beginbfchar\n<{:04X}> <{:04X}>\nendbfchar\n", glyph, character);
  return map + "endcmap\nend\nend\n";
}

/// Numbers of the objects of a file.
enum Object { catalog = 1, pages, page, content, letters, glyphs, descriptor, font_file, to_unicode };

std::vector<std::string> font_objects(const std::map<int, int>& characters) {
  const FontBox box = font_box();
  const std::string name = "/BaseFont /NETLFT+NotoSans";
  return {
      fmt::format("<< /Type /Font /Subtype /Type0 {} /Encoding /Identity-H /DescendantFonts [{} 0 R] "
                  "/ToUnicode {} 0 R >>",
                  name, +glyphs, +to_unicode),
      fmt::format(
          "<< /Type /Font /Subtype /CIDFontType2 {} /CIDSystemInfo << /Registry (Adobe) /Ordering (Identity) "
          "/Supplement 0 >> /FontDescriptor {} 0 R /CIDToGIDMap /Identity /W [{}] >>",
          name, +descriptor, widths_of(characters)),
      fmt::format(
          "<< /Type /FontDescriptor /FontName /NETLFT+NotoSans /Flags 4 /FontBBox [{:.0f} {:.0f} {:.0f} "
          "{:.0f}] "
          "/ItalicAngle 0 /Ascent {:.0f} /Descent {:.0f} /CapHeight {:.0f} /StemV 80 /FontFile2 {} 0 R >>",
          1000 * box.left, 1000 * box.bottom, 1000 * box.right, 1000 * box.top, 1000 * box.top,
          1000 * box.bottom, 1000 * box.top, +font_file),
      stream({kFontFile, kFontFileSize}, fmt::format(" /Length1 {}", kFontFileSize)),
      stream(bytes_of(characters_of(characters)))};
}

/// A file of numbered objects, and the table of their places.
std::string file_of(const std::vector<std::string>& objects) {
  std::string file = "%PDF-1.5\n%\xE2\xE3\xCF\xD3\n",
              table = fmt::format("xref\n0 {}\n0000000000 65535 f \n", objects.size() + 1);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    table += fmt::format("{:010} 00000 n \n", file.size());
    file += fmt::format("{} 0 obj\n", i + 1) + objects[i] + "\nendobj\n";
  }
  return file + table +
         fmt::format("trailer\n<< /Size {} /Root {} 0 R >>\nstartxref\n{}\n%%EOF\n", objects.size() + 1,
                     +catalog, file.size());
}

}  // namespace

void PdfPicture::line(formats::PicturePoint from, formats::PicturePoint to, const char* colour,
                      double width) {
  drawn_ += fmt::format("{} RG {:.3f} w {:.2f} {:.2f} m {:.2f} {:.2f} l S\n", rgb(colour), width, from.x,
                        from.y, to.x, to.y);
}

void PdfPicture::text(formats::PicturePoint at, const std::string& text, double size, const char* colour,
                      formats::Anchor anchor) {
  const double width = text_width(text, size);
  const double back = anchor == formats::Anchor::end      ? width
                      : anchor == formats::Anchor::middle ? width / 2
                                                          : 0;
  std::string codes;
  for (const Glyph& glyph : glyphs_of(text)) {
    characters_[glyph.number] = glyph.character;
    codes += fmt::format("{:04X}", glyph.number);
  }
  drawn_ += fmt::format("BT /F {:.2f} Tf {} rg 1 0 0 -1 {:.2f} {:.2f} Tm <{}> Tj ET\n", size, rgb(colour),
                        at.x - back, at.y, codes);
}

std::string PdfPicture::finish(formats::DrawingSize size) const {
  const double width = kPoint * size.width, height = kPoint * size.height;
  // The y axis of a page goes up, that of a drawing down.
  const std::string commands = fmt::format("{} 0 0 {} 0 {:.2f} cm 1 J\n", kPoint, -kPoint, height) + drawn_;
  std::vector<std::string> objects = {
      fmt::format("<< /Type /Catalog /Pages {} 0 R >>", +pages),
      fmt::format("<< /Type /Pages /Kids [{} 0 R] /Count 1 >>", +page),
      fmt::format("<< /Type /Page /Parent {} 0 R /MediaBox [0 0 {:.2f} {:.2f}] /Contents {} 0 R /Resources "
                  "<< /Font << /F {} 0 R >> >> >>",
                  +pages, width, height, +content, +letters),
      stream(bytes_of(commands))};
  for (std::string& object : font_objects(characters_)) objects.push_back(std::move(object));
  return file_of(objects);
}

}  // namespace netloft::pictures
