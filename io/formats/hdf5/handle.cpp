// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/handle.hpp"

#include <string_view>

namespace netloft::formats {
namespace {

// After a full disk H5Fclose() fails and leaves an id behind; the clean-up of HDF5 at exit then crashes (HDF5
// 1.10.8). The handles of this program close all ids, so that the clean-up has nothing to do and is switched
// off. This is possible only before the first call of HDF5.
[[maybe_unused]] const bool kNoCleanUp = H5dont_atexit() >= 0;

struct Ends {
  std::string cause;    // text of the deepest record
  std::string request;  // the call that failed
};

herr_t keep_ends(unsigned, const H5E_error2_t* record, void* data) {
  auto& ends = *static_cast<Ends*>(data);
  const std::string text = record->desc ? record->desc : "";
  if (ends.cause.empty()) ends.cause = text;
  ends.request = text;
  return 0;
}

/// Extracts the message of the operating system from HDF5's long description of a failed system call.
std::string system_words(const std::string& description) {
  constexpr std::string_view kMark = "error message = '";
  const auto begin = description.find(kMark);
  if (begin == std::string::npos) return description;
  const auto first = begin + kMark.size();
  return description.substr(first, description.find('\'', first) - first);
}

}  // namespace

void silence_hdf5() {
  thread_local const bool done = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) >= 0;
  static_cast<void>(done);
}

std::string hdf5_message() {
  Ends ends;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_ends, &ends);
  H5Eclear2(H5E_DEFAULT);
  if (ends.cause.empty()) return "HDF5 gave no reason";
  const std::string cause = system_words(ends.cause);
  return ends.request == ends.cause ? cause : ends.request + " (" + cause + ")";
}

}  // namespace netloft::formats
