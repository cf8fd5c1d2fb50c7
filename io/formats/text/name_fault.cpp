// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/text/name_fault.hpp"

#include "io/formats/text/printable.hpp"

namespace netloft::formats {
namespace {

constexpr std::size_t kLongestName = 100;  // length in bytes; file systems allow 255 including all endings

}  // namespace

std::string name_fault(const std::string& name) {
  if (name.empty()) return "must not be empty";
  if (name.size() > kLongestName) return "is longer than " + std::to_string(kLongestName) + " bytes";
  if (name.find('/') != std::string::npos)
    return "must not contain a slash, which leads into a file or a folder";
  if (name.find_first_not_of('.') == std::string::npos) return "must not be made of dots only";
  if (has_control_characters(name)) return "must not contain control characters";
  return {};
}

}  // namespace netloft::formats
