// SPDX-License-Identifier: BSD-3-Clause
#include "framework/registry/elf_length.hpp"

#include <elf.h>
#include <link.h>

#include <cstring>
#include <fstream>

namespace netloft {

namespace {

using Header = ElfW(Ehdr);
using Segment = ElfW(Phdr);

template <class T>
bool read_at(std::ifstream& in, std::uint64_t offset, T& to) {
  in.seekg(static_cast<std::streamoff>(offset));
  return static_cast<bool>(in.read(reinterpret_cast<char*>(&to), sizeof to));
}

}  // namespace

bool is_whole(const std::filesystem::path& file) {
  std::error_code none;
  const std::uint64_t size = std::filesystem::file_size(file, none);
  std::ifstream in(file, std::ios::binary);
  char magic[SELFMAG] = {};
  if (none || !in.read(magic, SELFMAG) || std::memcmp(magic, ELFMAG, SELFMAG) != 0) return true;
  Header header{};
  if (!read_at(in, 0, header)) return false;
  if (header.e_shoff + std::uint64_t{header.e_shnum} * header.e_shentsize > size) return false;
  for (std::uint64_t i = 0; i < header.e_phnum; ++i) {
    Segment segment{};
    if (!read_at(in, header.e_phoff + i * header.e_phentsize, segment)) return false;
    if (segment.p_type == PT_LOAD && segment.p_offset + segment.p_filesz > size) return false;
  }
  return true;
}

}  // namespace netloft
