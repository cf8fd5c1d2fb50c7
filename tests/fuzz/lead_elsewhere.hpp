// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tests/fuzz/scratch_file.hpp"

#include <hdf5.h>
#include <sys/stat.h>

#include <string>

namespace netloft::fuzz {

/// A pipe to which nobody writes: a program that opens it waits for ever.
inline const std::string& endless_pipe() {
  static const std::string path = [] {
    const std::string pipe = (scratch_folder() / "pipe").string();
    mkfifo(pipe.c_str(), 0600);
    return pipe;
  }();
  return path;
}

/// Ways in which an HDF5 file can refer to other files, or contain an endless loop. All are refused.
constexpr int kWaysElsewhere = 8;

inline void nest(hid_t file, const std::string& path) {
  hid_t group = H5Gcreate2(file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  for (int depth = 0; depth < 100; ++depth) {
    const hid_t inner = H5Gcreate2(group, "a", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Gclose(group);
    group = inner;
  }
  H5Gclose(group);
}

inline void add_dataset_elsewhere(hid_t file, const std::string& path, bool is_virtual) {
  const hsize_t extents[] = {4, 3};
  const hid_t space = H5Screate_simple(2, extents, nullptr), how = H5Pcreate(H5P_DATASET_CREATE);
  if (is_virtual)
    H5Pset_virtual(how, space, endless_pipe().c_str(), "/x", space);
  else
    H5Pset_external(how, endless_pipe().c_str(), 0, H5F_UNLIMITED);
  H5Dclose(H5Dcreate2(file, path.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, how, H5P_DEFAULT));
  H5Pclose(how), H5Sclose(space);
}

inline void add_strings(hid_t file, const std::string& path, const char* text) {
  const hsize_t count = 1;
  const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate_simple(1, &count, nullptr);
  H5Tset_size(type, H5T_VARIABLE);
  const hid_t made = H5Dcreate2(file, path.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(made, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, &text);
  H5Dclose(made), H5Sclose(space), H5Tclose(type);
}

/// Replaces the object `path`, or for the last `way` the names of parts, by a reference of the kind `way`,
/// from 1 to kWaysElsewhere.
inline void lead_elsewhere(hid_t file, const std::string& path, int way) {
  const std::string names = "/netloft/parts/name";
  const std::string& replaced = way == kWaysElsewhere ? names : path;
  if (H5Lexists(file, replaced.c_str(), H5P_DEFAULT) > 0) H5Ldelete(file, replaced.c_str(), H5P_DEFAULT);
  switch (way) {
    case 1:
    case 2:
      return add_dataset_elsewhere(file, path, way == 2);
    case 3:
      H5Lcreate_external(endless_pipe().c_str(), "/x", file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      return;
    case 4:
      H5Lcreate_soft("/netloft", file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      return;
    case 5:
      return nest(file, path);
    case 6:
      H5Lcreate_hard(file, "/netloft", file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      return;
    case 7:
      H5Gclose(H5Gcreate2(file, (path + "\x1b[31m").c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
      return;
    default:
      add_strings(file, names, "\x1b]0;title\x07");
  }
}

}  // namespace netloft::fuzz
