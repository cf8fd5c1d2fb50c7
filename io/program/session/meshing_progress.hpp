// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/gear_mesh.hpp"

#include <memory>
#include <thread>

namespace netloft::program {

class Terminal;

/// Shows the progress of meshing while a scene is read. It uses its own thread, because one step may take
/// long. Nothing else may write to the terminal during its lifetime.
class MeshingProgress {
 public:
  explicit MeshingProgress(Terminal& terminal);
  ~MeshingProgress();
  MeshingProgress(const MeshingProgress&) = delete;
  MeshingProgress& operator=(const MeshingProgress&) = delete;

  /// The callback for the mesher. It may outlive this object.
  gears::OnMeshing observer() const;

 private:
  struct State;
  std::shared_ptr<State> state_;
  Terminal& terminal_;
  std::thread thread_;
};

}  // namespace netloft::program
