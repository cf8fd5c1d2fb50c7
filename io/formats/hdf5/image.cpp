// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/image.hpp"

namespace netloft::formats {

namespace {

constexpr std::size_t kImageBlock = 1 << 16;

}  // namespace

std::string hdf5_image(const std::function<void(Tree&)>& write) {
  silence_hdf5();
  const Handle file(H5Fcreate("image", H5F_ACC_TRUNC, H5P_DEFAULT, access_in_memory()), H5Fclose);
  Tree tree(file, "memory");
  write(tree);
  check(H5Fflush(file, H5F_SCOPE_GLOBAL));
  std::string image(static_cast<std::size_t>(check(H5Fget_file_image(file, nullptr, 0))), '\0');
  check(H5Fget_file_image(file, image.data(), image.size()));
  return image;
}

Handle access_in_memory() {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  check(H5Pset_fapl_core(access, kImageBlock, false));
  return access;
}

}  // namespace netloft::formats
