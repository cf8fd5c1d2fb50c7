// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace netloft::program {

/// A reference page: a sentence, and tables under headings. Cells are plain text; the first of a row is a
/// name.
struct Page {
  struct Table {
    std::string heading;
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
  };
  struct Link {
    std::string text, file, doc;  // the file without its ending
  };
  std::string file, title;  // the file without its ending
  std::vector<std::string> paragraphs;
  std::vector<Link> links;
  std::vector<Table> tables;
};

std::string markdown(const Page& page);
std::string html(const Page& page);

}  // namespace netloft::program
