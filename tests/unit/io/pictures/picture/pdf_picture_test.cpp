// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/pdf_picture.hpp"

#include <gtest/gtest.h>

namespace netloft::pictures {
namespace {

std::string drawn() {
  PdfPicture picture;
  picture.line({0, 0}, {100, 50}, "#222", 2);
  picture.text({50, 20}, "½ of the headline", 12, "#0b5fa5", formats::Anchor::middle);
  return picture.finish({100, 50});
}

TEST(PdfPicture, HasATableWithThePlaceOfEveryObject) {
  const std::string pdf = drawn();
  EXPECT_TRUE(pdf.starts_with("%PDF-1."));
  EXPECT_TRUE(pdf.ends_with("%%EOF\n"));
  const std::size_t table = std::stoul(pdf.substr(pdf.rfind("startxref\n") + 10));
  ASSERT_EQ(pdf.substr(table, 7), "xref\n0 ");
  const std::size_t count = std::stoul(pdf.substr(table + 7));
  constexpr std::size_t kRow = 20;  // bytes, as the format demands
  const std::size_t rows = pdf.find('\n', table + 5) + 1;
  for (std::size_t i = 1; i < count; ++i) {
    const std::size_t at = std::stoul(pdf.substr(rows + kRow * i, 10));
    EXPECT_TRUE(pdf.substr(at).starts_with(std::to_string(i) + " 0 obj\n")) << i;
  }
}

TEST(PdfPicture, HasAPageOfTheSizeOfTheDrawing) {
  EXPECT_NE(drawn().find("/MediaBox [0 0 75.00 37.50]"), std::string::npos);  // 96 pixels are 72 points
}

TEST(PdfPicture, IsTheSameForTheSameDrawing) { EXPECT_EQ(drawn(), drawn()); }

}  // namespace
}  // namespace netloft::pictures
