// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/moving_state.hpp"

#include <map>
#include <string>
#include <vector>

namespace netloft {

/// Energy budget of a motion since its start. r_k and E_k are the residual and the energy of term k, F the
/// sum of all r_k, M the masses, q the degrees of freedom, v their rates; integrals are sums over steps by
/// the trapezoidal rule.
///   Σ_k ∫ r_k·dq = ∫ reaction·dq          over all terms, from F = 0                     (1)
///   stored_k = E_k                        terms with an energy                           (2)
///   kinetic = ½ v·M v                                                                    (3)
///   entrained = ∫ r_M(0, v)·dq − ½ ∫ v·(dM/dt) v dt
///                                         energy taken by added mass as the gear turns   (4)
///   dissipated_k = ∫ r_k·dq               drag, damping, friction; negative if they drive (5)
///   work_of_holds = ∫ reaction·dq         of moving holds                                (6)
///   work_of_winches = ∫ ∂E/∂t dt          lengths that change in time                    (7)
///   numerical = (6) + (7) − Δ(2) − Δ(3) − (4) − (5)     taken by the scheme; zero if (1) held at all times
/// r_M(0, v) is the inertia force of turning rigid bodies that have no acceleration; the second term of (4)
/// balances it. Dampers in (5) are evaluated in the middle of each step at the rate Δx/h, because a force
/// that begins to act within a step must not count as if it had acted for half of the step. For the
/// trapezoidal rule on a linear system, (1) and the budget hold exactly.
///
/// If a scheme uses mean forces (MeanStep), the budget sums the work of the mean forces instead. For a step
/// of length h from x₀ to x₁, with the forces f in its middle:
///   (5) f_k·Δq,   (6) reaction·Δq,   (7) change of E(x₀) and of E(x₁) from either end's time to the middle's
///   (4) h f_M·½(v₀ + v₁) − Δ(3),  f_M the force of inertia                               (8)
/// Then (1) holds to the tolerance of the solver, and `numerical` is the energy taken by the damping of the
/// scheme.
class EnergyBudget {
 public:
  EnergyBudget(Assembler& assembler, double mass_damping);

  /// Begins the budget at a state. Returns false if an element failed, which Assembler::fault describes.
  bool begin(double t, std::span<const double> u, std::span<const double> v, std::span<const double> a);
  /// Adds a step that ends at this state. `mean` has the mean forces of the step; nullptr: the scheme used
  /// none.
  bool advance(double t, std::span<const double> u, std::span<const double> v, std::span<const double> a,
               const MeanStep* mean = nullptr);
  void retract();
  /// Evaluates the forces of the last state again. Needed after elements have stored this state in their
  /// memory.
  bool refresh() { return find_forces(now_); }
  /// Replaces the rotation vectors of bodies in the last state by shorter vectors of the same rotations.
  bool restate(double t, std::span<const double> u, std::span<const double> v, std::span<const double> a);

  /// Names and values [J], in the same order.
  std::vector<std::string> names() const;
  std::vector<double> values() const;
  /// Energies of the last state, and work since the start, for EnergyJudge.
  struct Totals {
    double kinetic = 0, stored = 0, numerical = 0;
    std::vector<double> given;  // work done on the gear by holds, by winches, and by each nonconservative
                                // force; negative: work taken from the gear
  };
  Totals totals() const;
  /// The sums since the start. A resumed march calls `begin` at the same state and then continues with these
  /// sums.
  std::vector<double> sums() const;
  void set_sums(std::span<const double> sums);

 private:
  /// The energy or work of all active terms with the same name, such as "drag", together. `value` is their
  /// current energy if they are conservative, otherwise the sum of their work.
  struct Account {
    std::string name;
    std::vector<std::pair<std::size_t, std::size_t>> terms;  // indices of family and term
    bool in_the_middle = false;  // true: (5) is evaluated in the middle of each step
    double value = 0, first = 0;
  };
  /// A state, and its forces over all dofs, as residuals.
  struct Moment {
    double t = 0;
    std::vector<double> x, v, q, rates;           // q and `rates` contain unknowns and guided dofs
    std::vector<std::vector<double>> works;       // forces of each account in work_
    std::vector<double> damping, holds, turning;  // turning: r_M(0, v) of (4), if there are bodies
  };

  void place(double t, std::span<const double> u, std::span<const double> v, std::span<const double> a,
             Moment& to);
  bool find_forces(Moment& m);
  bool find_turning(Moment& m);
  bool find_energies(const std::vector<double>& x, double t, double& sum, bool keep);
  bool sum_force(const Account& account, const std::vector<double>& x, const Kinematics& motion,
                 std::vector<double>& force);
  void keep_values();
  bool add_ends();
  bool add_means(const MeanStep& mean, double kinetic_before);
  bool find_entrained();
  void find_mean_rates();
  bool add_works();
  bool add_winches(const MeanStep* mean);
  bool find_power(const Moment& m, double h, double& power);
  bool add_winches_of_means(double middle);
  double numerical() const;
  double done(const std::vector<double>& before, const std::vector<double>& after,
              std::size_t from = 0) const;

  Assembler& assembler_;
  MovingState state_;
  double mass_damping_;
  bool is_guided_, reads_time_ = false;
  std::vector<Account> stored_, work_;
  Account inertia_;
  Moment now_, next_;
  double kinetic_ = 0, first_kinetic_ = 0, entrained_ = 0, damped_ = 0, holds_ = 0, winches_ = 0;
  std::vector<double> before_;  // sums() and energies before the last step
  std::vector<double> zero_, scratch_, mean_rates_, mean_own_rates_, momentum_, turned_, middle_, secant_,
      force_;
};

}  // namespace netloft
