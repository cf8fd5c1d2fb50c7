// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <petscvec.h>

#include <exception>
#include <span>

// What the adapters to PETSc share: its start, owners of what it makes, and what becomes of errors.
namespace netloft::petsc {

/// PETSc for as long as the program runs, in this process alone, and out of the way: no signal handlers, no
/// options of other programs, no traces on the terminal, no daemon of MPI's.
void start();

/// Throws what PETSc says of an error.
void check(PetscErrorCode code);

/// Runs a callback on its host. No exception may pass through PETSc: it waits in `failure` of the host.
template <class Host, class Work>
PetscErrorCode guarded(void* host, Work&& work) noexcept {
  try {
    work(*static_cast<Host*>(host));
    return PetscErrorCode{};
  } catch (...) {
    static_cast<Host*>(host)->failure = std::current_exception();
    return PETSC_ERR_USER;
  }
}

/// Owns what PETSc makes.
template <class Handle, PetscErrorCode (*Destroy)(Handle*)>
class Owned {
 public:
  Owned() = default;
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  ~Owned() { Destroy(&handle_); }
  operator Handle() const { return handle_; }
  Handle* address() { return &handle_; }

 private:
  Handle handle_ = nullptr;
};

/// A vector that stands on `values`, or one of its own.
class Vector : public Owned<Vec, VecDestroy> {
 public:
  explicit Vector(std::span<double> values) {
    check(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, static_cast<PetscInt>(values.size()), values.data(),
                                address()));
  }
  explicit Vector(std::size_t size) {
    check(VecCreateSeq(PETSC_COMM_SELF, static_cast<PetscInt>(size), address()));
  }
};

/// Entries of a vector, for reading or for writing, as long as this lives.
class Entries {
 public:
  explicit Entries(Vec v) : vector_(v) {
    check(VecGetLocalSize(v, &size_));
    check(VecGetArray(v, &begin_));
  }
  Entries(const Entries&) = delete;
  Entries& operator=(const Entries&) = delete;
  ~Entries() { VecRestoreArray(vector_, &begin_); }
  operator std::span<double>() const { return {begin_, static_cast<std::size_t>(size_)}; }

 private:
  Vec vector_;
  PetscInt size_ = 0;
  double* begin_ = nullptr;
};

class ReadEntries {
 public:
  explicit ReadEntries(Vec v) : vector_(v) {
    check(VecGetLocalSize(v, &size_));
    check(VecGetArrayRead(v, &begin_));
  }
  ReadEntries(const ReadEntries&) = delete;
  ReadEntries& operator=(const ReadEntries&) = delete;
  ~ReadEntries() { VecRestoreArrayRead(vector_, &begin_); }
  operator std::span<const double>() const { return {begin_, static_cast<std::size_t>(size_)}; }

 private:
  Vec vector_;
  PetscInt size_ = 0;
  const double* begin_ = nullptr;
};

}  // namespace netloft::petsc
