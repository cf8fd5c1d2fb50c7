// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/share.hpp"

#include <memory>
#include <span>

namespace netloft {

class Assembler;
struct Plan;
struct Request;

/// Other processes that have the same scene and evaluate shares of it.
class Partners {
 public:
  virtual ~Partners() = default;
  /// Called once, by the assembler that they share with; it is whole then. Throws std::runtime_error where
  /// one of them could not make the scene.
  virtual void join(const Assembler& assembler) = 0;
  /// How many there are, this process included.
  virtual int size() const = 0;
  /// The share of this process.
  virtual const Share& own() const = 0;
  /// Whether they can evaluate this: nothing moves.
  virtual bool can(const Request& request) const = 0;
  /// Lets them begin at positions x over all dofs [m].
  virtual void begin(std::span<const double> x, const Request& request) = 0;
  /// Waits for them, and puts what they have into its places: residual, gradient, matrix values,
  /// energies of tiles. Returns false if one could not be evaluated.
  virtual bool end(const Request& request, std::span<double> tile_energy) = 0;
  /// Hands them what all elements remember from now on.
  virtual void set_memory(std::span<const double> kept) = 0;
};

/// Where partners come from.
class Team {
 public:
  virtual ~Team() = default;
  /// Has a scene made by all others, while this process makes it, too. Null: the
  /// scene is small, or it moves.
  virtual std::unique_ptr<Partners> open(const Scene& scene, const Plan& plan) = 0;
};

/// Who evaluates a scene: threads of this process, and other processes (null: none).
struct Crew {
  int threads = 1;
  Team* others = nullptr;
};

std::unique_ptr<Assembler> make_assembler(const Scene& scene, const Plan& plan, const Crew& crew);

}  // namespace netloft
