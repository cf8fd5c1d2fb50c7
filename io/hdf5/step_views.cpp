// SPDX-License-Identifier: BSD-3-Clause
#include "io/hdf5/step_views.hpp"

#include <array>
#include <cstdio>

namespace netloft::io {

namespace {

/// Slot of a state, by (1) of vtkhdf.hpp.
std::size_t slot_of(std::size_t step, std::size_t states) { return step + 1 < states ? step + 1 : 0; }

void write_view(hid_t file, const std::string& path, const SlottedArray& array, std::size_t slot,
                std::size_t slots) {
  const int rank = array.columns == 1 ? 1 : 2;
  const std::array<hsize_t, 2> all = {slots * array.rows, array.columns}, view = {array.rows, array.columns},
                               start = {slot * array.rows, 0};
  const Handle source(H5Screate_simple(rank, all.data(), nullptr), H5Sclose),
      space(H5Screate_simple(rank, view.data(), nullptr), H5Sclose),
      properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose), links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  check(H5Sselect_hyperslab(source, H5S_SELECT_SET, start.data(), nullptr, view.data(), nullptr));
  check(H5Pset_virtual(properties, space, ".", ("/VTKHDF/" + array.path).c_str(), source));
  check(H5Pset_create_intermediate_group(links, 1));
  const Handle dataset(H5Dcreate2(file, path.c_str(), H5T_IEEE_F64LE, space, links, properties, H5P_DEFAULT),
                       H5Dclose);
}

}  // namespace

std::string step_group(std::size_t step) {
  char name[40];
  std::snprintf(name, sizeof name, "/steps/%05zu/", step);
  return name;
}

void write_step_views(hid_t file, std::size_t states, const std::vector<SlottedArray>& arrays) {
  silence_hdf5();
  for (std::size_t step = 0; step < states && states > 1; ++step)
    for (const SlottedArray& array : arrays)
      if (array.rows > 0)
        write_view(file, step_group(step) + array.path, array, slot_of(step, states), states);
}

}  // namespace netloft::io
