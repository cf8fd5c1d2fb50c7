// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/open.hpp"

#include <set>
#include <vector>

#include "io/formats/hdf5/image.hpp"
#include "io/formats/text/printable.hpp"

namespace netloft::formats {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kDeepestGroup = 16;  // results nest groups five deep, meshes two deep

const std::string kCure = "only data in the file itself are read, so ask for a file that holds all its data";

// The name given to files in memory. HDF5 refuses this name if it can open a file of this name. Therefore it
// must be the name of a file that cannot exist.
constexpr const char* kNoFile = "/dev/null/image";

[[noreturn]] void refuse_elsewhere(const std::string& object, const std::string& why) {
  throw FileError(object + " " + why + "; " + kCure);
}

std::string external_file_of(hid_t properties) {
  char name[256] = "";
  off_t offset = 0;
  hsize_t size = 0;
  check(H5Pget_external(properties, 0, sizeof name - 1, name, &offset, &size));
  return name;
}

/// Checks that HDF5 finds the data of a dataset in the file itself.
void require_own_numbers(hid_t dataset, const std::string& path) {
  const Handle properties(H5Dget_create_plist(dataset), H5Pclose);
  if (check(H5Pget_external_count(properties)) > 0)
    refuse_elsewhere(
        path, "has its numbers in another file, " + external_file_of(properties) + " (external storage)");
  if (check(H5Pget_layout(properties)) == H5D_VIRTUAL)
    refuse_elsewhere(path, "is made of datasets of other files (a virtual dataset)");
}

std::string kind_of(H5L_type_t link) {
  if (link == H5L_TYPE_EXTERNAL) return "an external link";
  return link == H5L_TYPE_SOFT ? "a soft link" : "a link of an unknown kind";
}

/// Visits every object of a file once. H5Ovisit() is not suitable, because it has no limit of depth and
/// follows the whole path of every object.
class ObjectVisit {
 public:
  explicit ObjectVisit(hid_t file) { visit(Handle(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose), "", 0); }

 private:
  struct Link {
    std::string name;
    H5L_type_t type;
  };

  static herr_t append_link(hid_t, const char* name, const H5L_info_t* link, void* links) {
    static_cast<std::vector<Link>*>(links)->push_back({name, link->type});
    return 0;
  }

  void visit(const Handle& group, const std::string& path, std::size_t depth) {
    if (depth > kDeepestGroup)
      throw FileError(path + " is nested deeper than " + std::to_string(kDeepestGroup) +
                      " groups, which no result has");
    require_first_visit(group, path);
    std::vector<Link> links;
    check(H5Literate(group, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, append_link, &links));
    for (const Link& link : links) visit(group, link, path + "/" + link.name, depth);
  }

  void visit(const Handle& group, const Link& link, const std::string& path, std::size_t depth) {
    if (has_control_characters(link.name))
      throw FileError("the name of " + printable_in_line(path) +
                      " has control characters, and no result has such names");
    if (link.type != H5L_TYPE_HARD) refuse_elsewhere(path, "is " + kind_of(link.type));
    const Handle object =
        with_context(path, [&] { return Handle(H5Oopen(group, link.name.c_str(), H5P_DEFAULT), H5Oclose); });
    if (H5Iget_type(object) == H5I_DATASET) require_own_numbers(object, path);
    if (H5Iget_type(object) == H5I_GROUP) visit(object, path, depth + 1);
  }

  void require_first_visit(const Handle& group, const std::string& path) {
    H5O_info_t info;
    check(H5Oget_info1(group, &info));
    if (!groups_.insert(info.addr).second)
      throw FileError(
          path +
          " is a group that also appears in another group, possibly in itself; results have no such groups");
  }

  std::set<haddr_t> groups_;  // addresses of the visited groups
};

/// Replaces HDF5's messages for common failures by sentences for the user.
std::string explain(const std::string& reason) {
  if (reason.find("truncated") != std::string::npos)
    return "it is truncated: a copy that was cut short, or a writer that died before its first output (" +
           reason + ")";
  if (reason.find("flag values don't match") != std::string::npos) return "this process is writing it";
  if (reason.find("unable to lock") != std::string::npos ||
      reason.find("temporarily unavailable") != std::string::npos)
    return "another process is writing it; HDF5_USE_FILE_LOCKING=FALSE in the environment reads it all the "
           "same";
  return reason;
}

Handle open_unchecked(const std::string& name, hid_t access) {
  silence_hdf5();
  static const bool loads_no_plugins = H5PLset_loading_state(0) >= 0;
  if (!loads_no_plugins) throw FileError("HDF5 cannot be kept from loading plugins");
  return Handle(H5Fopen(name.c_str(), H5F_ACC_RDONLY, access), H5Fclose);
}

}  // namespace

bool is_hdf5_file(const fs::path& path) {
  silence_hdf5();
  return H5Fis_hdf5(path.c_str()) > 0;
}

void require_own_data(hid_t file) { ObjectVisit{file}; }

Handle open_for_reading(const fs::path& path) {
  return with_context("cannot read " + path.string(), [&] {
    Handle file;
    try {
      file = open_unchecked(path.string(), H5P_DEFAULT);
    } catch (const FileError& e) {
      const std::string reason = e.what();
      if (H5Fis_hdf5(path.c_str()) == 0)
        throw FileError("it is not an HDF5 file, nor the journal of a motion");
      throw FileError(explain(reason));
    }
    require_own_data(file);
    return file;
  });
}

Handle open_image(const std::string& image) {
  const Handle access = access_in_memory();
  check(H5Pset_file_image(access, const_cast<char*>(image.data()), image.size()));  // HDF5 copies the image
  Handle file = open_unchecked(kNoFile, access);
  require_own_data(file);
  return file;
}

}  // namespace netloft::formats
