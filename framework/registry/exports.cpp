// SPDX-License-Identifier: BSD-3-Clause
#include "framework/registry/exports.hpp"

#include <elf.h>
#include <link.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <iterator>

namespace netloft {

namespace {

using Header = ElfW(Ehdr);
using Section = ElfW(Shdr);
using Symbol = ElfW(Sym);

/// The bytes of a file; bytes outside the file read as zero.
class Bytes {
 public:
  explicit Bytes(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(in), {});
    bytes_.push_back('\0');
  }
  template <class T>
  T at(std::uint64_t offset) const {
    T value{};
    if (offset + sizeof value <= bytes_.size()) std::memcpy(&value, &bytes_[offset], sizeof value);
    return value;
  }
  std::string text(std::uint64_t offset) const { return offset < bytes_.size() ? &bytes_[offset] : ""; }

 private:
  std::vector<char> bytes_;
};

Section section(const Bytes& file, const Header& header, std::uint64_t index) {
  return file.at<Section>(header.e_shoff + index * sizeof(Section));
}

bool is_exported(const Symbol& s) {
  const int binding = s.st_info >> 4, visibility = s.st_other & 3;
  return s.st_shndx != SHN_UNDEF && binding != STB_LOCAL && visibility != STV_HIDDEN &&
         visibility != STV_INTERNAL;
}

bool is_linkers(const std::string& name) {
  constexpr std::array names = {"_init", "_fini", "_edata", "_end", "__bss_start"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

std::vector<std::string> exported_symbols(const std::filesystem::path& path) {
  const Bytes file(path);
  const auto header = file.at<Header>(0);
  std::vector<std::string> names;
  if (std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0) return names;
  for (std::uint64_t i = 0; i < header.e_shnum; ++i) {
    const Section symbols = section(file, header, i), texts = section(file, header, symbols.sh_link);
    if (symbols.sh_type != SHT_DYNSYM) continue;
    for (std::uint64_t k = 0; k < symbols.sh_size / sizeof(Symbol); ++k) {
      const auto symbol = file.at<Symbol>(symbols.sh_offset + k * sizeof(Symbol));
      const std::string name = file.text(texts.sh_offset + symbol.st_name);
      if (is_exported(symbol) && !is_linkers(name)) names.push_back(name);
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace netloft
