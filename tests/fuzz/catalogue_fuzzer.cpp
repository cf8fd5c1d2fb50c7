// SPDX-License-Identifier: BSD-3-Clause
// Tries random input in the reader of catalogues: each input is the only file in a folder of parts.
#include "io/gears/catalogue/catalogue.hpp"
#include "tests/fuzz/scratch_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace netloft;
  fuzz::write_scratch("parts.toml", data, size);
  formats::Diagnostics diagnostics;
  const gears::Catalogue parts = gears::Catalogue::load({fuzz::scratch_folder()}, diagnostics);
  fuzz::use(diagnostics.render(false).size());
  for (const auto& part : parts.parts()) {
    const auto* found = parts.find(part.name, {part.kind->name});
    fuzz::use(found ? found->numbers.size() : 0);
  }
  return 0;
}
