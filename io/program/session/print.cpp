// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/session/print.hpp"

#include "io/formats/text/printable.hpp"

#include <cstdio>
#include <string>

namespace netloft::program {

namespace {

void put_safe(std::string_view text, std::FILE* stream) {
  const std::string safe = formats::printable(text);
  std::fwrite(safe.data(), 1, safe.size(), stream);
}

}  // namespace

void print(std::string_view text) { put_safe(text, stdout); }

void print_line(std::string_view text) {
  put_safe(text, stdout);
  std::fputc('\n', stdout);
}

void flush_answers() { std::fflush(stdout); }

void print_error(std::string_view text) {
  put_safe(text, stderr);
  std::fputc('\n', stderr);
}

}  // namespace netloft::program
