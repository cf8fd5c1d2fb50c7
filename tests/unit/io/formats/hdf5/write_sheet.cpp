// SPDX-License-Identifier: BSD-3-Clause
// write_sheet FILE.hdf: six states of a bending sheet with a rope.
#include <cstdio>
#include <exception>

#include "tests/unit/io/formats/hdf5/sheet.hpp"

int main(int argc, char** argv) try {
  using namespace netloft::formats;
  if (argc != 2) return 2;
  const test::Sheet sheet;
  ResultFile file(argv[1]);
  test::begin(file, sheet, 6);
  for (int i = 0; i <= 5; ++i) test::write_state(file, sheet, 0.2 * i);
  file.tree().write_real("/netloft/scalars/lowest_z", -6.0, "m", "Lowest point of the sheet");
  file.finish();
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
