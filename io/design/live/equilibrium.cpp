// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/live/equilibrium.hpp"

#include "io/results/file/provenance.hpp"
#include "io/results/file/write_result.hpp"

#include <system_error>

namespace netloft::design {

results::StoredShape EquilibriumStore::shape_of(const Equilibrium& of) const {
  const std::filesystem::path path = folder_.path() / (of.scene->loaded().scene.name + ".hdf");
  std::error_code none;
  std::filesystem::remove(path, none);
  formats::ResultFile file(path);
  results::Result result = of.result;
  result.origins =
      results::make_origins(of.scene->loaded(), {{}, results::utc_now(), of.scene->registry().opened(), {}});
  result.origins.finished = results::utc_now();
  result.path = path.string();
  results::write_result(file, of.scene->loaded(), of.scene->assembler(), {of.solution, {}}, result);
  file.finish();
  return results::StoredShape(path);
}

}  // namespace netloft::design
