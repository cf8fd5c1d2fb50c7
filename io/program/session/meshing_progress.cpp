// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/session/meshing_progress.hpp"

#include "io/program/session/terminal.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace netloft::program {

struct MeshingProgress::State {
  std::mutex mutex;
  std::condition_variable wake;
  bool is_over = false;
  std::string step;  // empty until meshing begins
  std::size_t nodes = 0;
};

MeshingProgress::MeshingProgress(Terminal& terminal)
    : state_(std::make_shared<State>()), terminal_(terminal), thread_([this] {
        constexpr std::chrono::milliseconds kLook{100};
        std::unique_lock lock(state_->mutex);
        while (!state_->wake.wait_for(lock, kLook, [this] { return state_->is_over; }))
          if (!state_->step.empty()) terminal_.progress_in_meshing(state_->step, state_->nodes);
      }) {}

MeshingProgress::~MeshingProgress() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->is_over = true;
  }
  state_->wake.notify_all();
  thread_.join();
  terminal_.clear();
}

gears::OnMeshing MeshingProgress::observer() const {
  return [state = state_](const std::string& step, std::size_t nodes) {
    const std::lock_guard lock(state->mutex);
    state->step = step;
    state->nodes = nodes;
  };
}

}  // namespace netloft::program
