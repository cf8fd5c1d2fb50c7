// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>

#include <exception>
#include <memory>
#include <new>
#include <span>
#include <type_traits>

// Code that the adapters to SUNDIALS share: owners of SUNDIALS' objects, and return values of callbacks.
namespace netloft::sundials {

/// Return values of callbacks: SUNDIALS tries a shorter step after a positive value, and stops after a
/// negative one.
enum { kDone = 0, kRecoverable = 1, kStop = -1 };

/// Runs a callback on its host. No exception may pass through SUNDIALS; it is stored in `failure` of the
/// host.
template <class Host, class Work>
int guarded(void* host, Work&& work) noexcept {
  try {
    return work(*static_cast<Host*>(host));
  } catch (...) {
    static_cast<Host*>(host)->failure = std::current_exception();
    return kStop;
  }
}

/// Receives error messages of SUNDIALS, and stores them in `host` instead of printing them.
template <class Host>
void keep_complaint(int, const char*, const char*, char* message, void* host) {
  guarded<Host>(host, [&](Host& h) {
    h.complaint = message;
    return int{kDone};
  });
}

template <class T>
T* checked(T* made) {
  if (!made) throw std::bad_alloc();
  return made;
}

struct FreeContext {
  void operator()(SUNContext c) const { SUNContext_Free(&c); }
};
struct FreeVector {
  void operator()(N_Vector v) const { N_VDestroy(v); }
};
using Context = std::unique_ptr<std::remove_pointer_t<SUNContext>, FreeContext>;
using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, FreeVector>;

inline Context make_context() {
  SUNContext context = nullptr;
  SUNContext_Create(nullptr, &context);
  return Context(checked(context));
}

/// Makes a vector that uses the memory of `values`.
inline Vector make_vector(std::span<double> values, SUNContext context) {
  return Vector(checked(N_VMake_Serial(static_cast<sunindextype>(values.size()), values.data(), context)));
}

}  // namespace netloft::sundials
