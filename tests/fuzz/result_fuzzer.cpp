// SPDX-License-Identifier: BSD-3-Clause
// Tries random changes of a result. HDF5 itself crashes on some damaged bytes, so bytes of the file are not
// damaged. Each input says how a good result is changed by HDF5: objects and attributes are removed, renamed,
// replaced by others of another type or extent, and numbers overwritten. Then the result is read, reported
// and drawn like any other. The first byte also says whether the points are replaced by data in another file,
// which must be refused.
#include "io/formats/mesh/mesh.hpp"
#include "io/results/file/read_result.hpp"
#include "io/results/text/result_text.hpp"
#include "io/results/text/tables.hpp"
#include "tests/fuzz/choices.hpp"
#include "tests/fuzz/lead_elsewhere.hpp"
#include "tests/fuzz/scratch_file.hpp"

#include <hdf5.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace {

using namespace netloft;
namespace fs = std::filesystem;

constexpr const char* kResults[] = {"panel.hdf", "rope-in-time.hdf", "panel.hdf", "half-gear.hdf"};

/// The folder in which make_results.sh has written its results.
fs::path good_results() {
  const char* folder = std::getenv("NETLOFT_FUZZ_RESULTS");
  if (folder) return folder;
  std::fputs("NETLOFT_FUZZ_RESULTS: name the folder that make_results.sh has filled\n", stderr);
  std::exit(1);
}

/// Paths of all objects of a file.
std::vector<std::string> objects_of(hid_t file) {
  std::vector<std::string> paths;
  H5Ovisit1(
      file, H5_INDEX_NAME, H5_ITER_INC,
      [](hid_t, const char* name, const H5O_info_t*, void* to) -> herr_t {
        if (std::strcmp(name, ".") != 0) static_cast<std::vector<std::string>*>(to)->push_back(name);
        return 0;
      },
      &paths);
  return paths;
}

/// A dataset or an attribute of numbers or texts, whose extents are taken from the input.
class Replacement {
 public:
  explicit Replacement(fuzz::Choices& source) : source_(source) {
    const hid_t types[] = {H5T_NATIVE_DOUBLE, H5T_NATIVE_INT64, H5T_NATIVE_UINT8, H5T_NATIVE_INT};
    is_text_ = source.in<int>(0, 4) == 0;
    type_ = is_text_ ? H5Tcopy(H5T_C_S1) : H5Tcopy(types[source.in<std::size_t>(0, 3)]);
    if (is_text_) H5Tset_size(type_, source.flag() ? H5T_VARIABLE : source.in<std::size_t>(1, 9));
    hsize_t extents[3];
    const int rank = source.in<int>(0, 3);
    for (int i = 0; i < rank; ++i) extents[i] = source.in<hsize_t>(0, 12);
    space_ = rank == 0 ? H5Screate(source.flag() ? H5S_SCALAR : H5S_NULL)
                       : H5Screate_simple(rank, extents, nullptr);
  }
  ~Replacement() { H5Sclose(space_), H5Tclose(type_); }
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;

  void add_dataset(hid_t file, const std::string& path) {
    const hid_t made = H5Dcreate2(file, path.c_str(), type_, space_, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    if (made < 0) return;
    overwrite(made, source_);
    H5Dclose(made);
  }
  void add_attribute(hid_t object, const std::string& name) {
    const hid_t made = H5Acreate2(object, name.c_str(), type_, space_, H5P_DEFAULT, H5P_DEFAULT);
    if (made < 0) return;
    if (!H5Tis_variable_str(type_)) {
      auto bytes = source_.bytes(1 << 10);
      bytes.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space_)) * H5Tget_size(type_) + 16);
      H5Awrite(made, type_, bytes.data());
    }
    H5Aclose(made);
  }
  /// Overwrites some of the numbers of a dataset.
  static void overwrite(hid_t dataset, fuzz::Choices& source) {
    const hid_t type = H5Dget_type(dataset), space = H5Dget_space(dataset);
    const auto count = static_cast<std::size_t>(std::max<hssize_t>(0, H5Sget_simple_extent_npoints(space)));
    if (H5Tget_class(type) == H5T_INTEGER || H5Tget_class(type) == H5T_FLOAT) {
      std::vector<double> values(count + 1);
      H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
      for (int n = source.in<int>(1, 4); n > 0 && count > 0; --n)
        values[source.in<std::size_t>(0, count - 1)] = number(source);
      H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    }
    H5Sclose(space), H5Tclose(type);
  }
  static double number(fuzz::Choices& source) {
    const double special[] = {0, -1, 1, 2, 3, 1e9, -1e9, 1e19, 4294967296.0, 1e300, 0.5};
    if (source.flag()) return special[source.in<std::size_t>(0, 10)];
    return source.flag() ? source.in<int>(-5, 200) : source.number();
  }

 private:
  fuzz::Choices& source_;
  hid_t type_ = -1, space_ = -1;
  bool is_text_ = false;
};

void change_attribute(hid_t file, const std::string& path, fuzz::Choices& source) {
  const hid_t object = H5Oopen(file, path.c_str(), H5P_DEFAULT);
  if (object < 0) return;
  H5O_info_t info{};
  if (H5Oget_info1(object, &info) >= 0 && info.num_attrs > 0) {
    const auto which = source.in<hsize_t>(0, info.num_attrs - 1);
    char name[128] = "";
    H5Aget_name_by_idx(object, ".", H5_INDEX_NAME, H5_ITER_INC, which, name, sizeof name, H5P_DEFAULT);
    H5Adelete(object, name);
    if (source.flag()) Replacement(source).add_attribute(object, name);
  }
  H5Oclose(object);
}

void change(hid_t file, fuzz::Choices& source) {
  const auto paths = objects_of(file);
  if (paths.empty()) return;
  const std::string& path = paths[source.in<std::size_t>(0, paths.size() - 1)];
  const std::string& other = paths[source.in<std::size_t>(0, paths.size() - 1)];
  switch (source.in<int>(0, 6)) {
    case 0:
      H5Ldelete(file, path.c_str(), H5P_DEFAULT);
      return;
    case 1:
      H5Ldelete(file, path.c_str(), H5P_DEFAULT);
      Replacement(source).add_dataset(file, path);
      return;
    case 2:
      H5Lmove(file, path.c_str(), file, (path + "x").c_str(), H5P_DEFAULT, H5P_DEFAULT);
      return;
    case 3:
      H5Ldelete(file, path.c_str(), H5P_DEFAULT);
      H5Lcreate_hard(file, other.c_str(), file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      return;
    case 4:
      change_attribute(file, path, source);
      return;
    default: {
      const hid_t dataset = H5Dopen2(file, path.c_str(), H5P_DEFAULT);
      if (dataset < 0) return;
      Replacement::overwrite(dataset, source);
      H5Dclose(dataset);
    }
  }
}

/// Uses the result as the mesh of a scene.
void stand_on(const fs::path& path) {
  formats::Diagnostics diagnostics;
  const auto mesh = formats::read_vtkhdf(path, diagnostics.add_source("r.hdf", ""), diagnostics);
  fuzz::use(diagnostics.render(false).size());
  if (diagnostics.errors() > 0 || mesh.node_count() == 0) return;
  const std::string text = formats::mesh_text(mesh, "a result");
  formats::Diagnostics again;
  formats::read_mesh(text, again.add_source("r.mesh", text), again);
  if (again.errors()) {
    std::fputs(again.render(false).c_str(), stderr);
    std::abort();
  }
}

/// Reports the result in every form. Returns whether it could be read.
bool look_at(const fs::path& path) {
  try {
    const results::Result result = results::read_result(path);
    fuzz::use(results::result_text(result).size() + results::result_json(result).size() +
              results::result_csv(result).size());
    const results::StoredShape shape(path);
    for (const std::size_t state : {std::size_t{0}, shape.times.size() - 1})
      fuzz::use(results::nodes_csv(shape, state).size() + results::elements_csv(shape, state).size());
    return true;
  } catch (const formats::FileError& e) {
    fuzz::use(std::strlen(e.what()));
    return false;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  formats::silence_hdf5();
  fuzz::Choices source(data, size);
  const auto path = fuzz::scratch_folder() / "r.hdf";
  const int first = source.any<std::uint8_t>(), way = first / 4 % 16;
  fs::copy_file(good_results() / kResults[first % 4], path, fs::copy_options::overwrite_existing);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const bool leads_elsewhere = way > 0 && way <= fuzz::kWaysElsewhere;
  if (leads_elsewhere) fuzz::lead_elsewhere(file, "/VTKHDF/Points", way);
  const bool is_changed = source.left() > 0;
  for (int n = 0; n < 8 && source.left() > 0; ++n) change(file, source);
  H5Fclose(file);
  if (look_at(path) && leads_elsewhere && !is_changed) std::abort();
  stand_on(path);
  return 0;
}
