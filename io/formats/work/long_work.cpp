// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/work/long_work.hpp"

#include <utility>

namespace netloft::formats {

namespace {

thread_local WorkFollower* current = nullptr;
thread_local int depth = 0;  // depth of work within other work

void leave() {
  if (--depth == 0 && current) current->end();
}

}  // namespace

WorkFollower* follow_work(WorkFollower* follower) { return std::exchange(current, follower); }

LongWork::LongWork(const Step& first) {
  ++depth;
  try {
    report(first);
  } catch (...) {
    leave();  // needed because the destructor does not run if the constructor throws
    throw;
  }
}

LongWork::~LongWork() { leave(); }

void report(const Step& step) {
  if (depth > 0 && current) current->at(step);
}

void hear_interruption() {
  if (depth > 0 && current) current->hear();
}

}  // namespace netloft::formats
