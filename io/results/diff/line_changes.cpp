// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/diff/line_changes.hpp"

#include <algorithm>
#include <cstdint>
#include <sstream>

namespace netloft::results {

namespace {

// Limit of table cells (lines of one text times lines of the other). If it is exceeded, all differing lines
// count as changed.
constexpr std::size_t kMostCells = 4'000'000;

using Lines = std::vector<std::string>;

Lines split(const std::string& text) {
  Lines lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The middles of texts `a` and `b`: lines [begin, a_end) of `a` and [begin, b_end) of `b`. Equal lines at
/// the beginning and at the end are left out.
struct Middle {
  std::size_t begin = 0, a_end, b_end;

  Middle(const Lines& a, const Lines& b) : a_end(a.size()), b_end(b.size()) {
    while (begin < std::min(a_end, b_end) && a[begin] == b[begin]) ++begin;
    while (a_end > begin && b_end > begin && a[a_end - 1] == b[b_end - 1]) {
      --a_end;
      --b_end;
    }
  }
  std::size_t rows() const { return a_end - begin; }
  std::size_t columns() const { return b_end - begin; }
};

/// at(i, j) is the length of the longest common subsequence of the lines from i of `a` and from j of `b` to
/// their ends.
class CommonTails {
 public:
  CommonTails(const Lines& a, const Lines& b, const Middle& m)
      : width_(m.columns() + 1), length_((m.rows() + 1) * width_) {
    for (std::size_t i = m.rows(); i-- > 0;)
      for (std::size_t j = m.columns(); j-- > 0;)
        length_[i * width_ + j] =
            a[m.begin + i] == b[m.begin + j] ? 1 + at(i + 1, j + 1) : std::max(at(i + 1, j), at(i, j + 1));
  }
  std::uint32_t at(std::size_t i, std::size_t j) const { return length_[i * width_ + j]; }

 private:
  std::size_t width_;
  std::vector<std::uint32_t> length_;
};

/// Collects removed and new lines with their numbers.
struct Changes {
  const Lines &a, &b;
  const Middle& m;
  std::vector<LineChange> found = {};

  void gone(std::size_t i) { found.push_back({false, static_cast<int>(m.begin + i + 1), a[m.begin + i]}); }
  void is_new(std::size_t j) { found.push_back({true, static_cast<int>(m.begin + j + 1), b[m.begin + j]}); }
};

void walk(const CommonTails& common, Changes& changes) {
  const Middle& m = changes.m;
  std::size_t i = 0, j = 0;
  while (i < m.rows() && j < m.columns())
    if (changes.a[m.begin + i] == changes.b[m.begin + j]) {
      ++i;
      ++j;
    } else if (common.at(i + 1, j) >= common.at(i, j + 1))
      changes.gone(i++);
    else
      changes.is_new(j++);
  while (i < m.rows()) changes.gone(i++);
  while (j < m.columns()) changes.is_new(j++);
}

}  // namespace

std::vector<LineChange> find_line_changes(const std::string& before, const std::string& after) {
  const Lines a = split(before), b = split(after);
  const Middle m(a, b);
  Changes changes{a, b, m};
  if (m.rows() * m.columns() <= kMostCells) {
    walk(CommonTails(a, b, m), changes);
  } else {
    for (std::size_t i = 0; i < m.rows(); ++i) changes.gone(i);
    for (std::size_t j = 0; j < m.columns(); ++j) changes.is_new(j);
  }
  return changes.found;
}

}  // namespace netloft::results
