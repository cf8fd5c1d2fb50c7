// SPDX-License-Identifier: BSD-3-Clause
//
// A struct of parameters whose table declares one of two members. The host sets the declared member and
// leaves the other zero; the functions of the author must see the author's default.
#include <netloft/integrator.hpp>
#include <netloft/law.hpp>
#include <netloft/solver.hpp>
#include <netloft/strategy.hpp>

#include <gtest/gtest.h>

namespace netloft {
namespace {

struct Shared {
  double given = 1;
  std::int64_t number = 3;
};

/// The parameters as the host fills them: 2 for declared members, zero for others.
struct Block {
  double given = 2;
  std::int64_t number = 0;
};

struct Weight {
  static constexpr auto stencil = NETLOFT_NODE;
  using Parameters = Shared;
  struct Data {};
  struct Pull {
    static Status evaluate(const Parameters& p, const Data&, const State<1>&, Local<1>& out) {
      out.force[0] = {p.given, static_cast<double>(p.number), 0};
      return Status::ok;
    }
  };
};

TEST(UndeclaredParameters, OfAnElementKeepTheAuthorsDefaults) {
  ElementTable<Weight> table("weight", "a weight");
  table.real("given", &Shared::given, "N", "declared", {.lo = 0, .hi = 10, .fallback = 1});
  table.term<Weight::Pull>("pull", "both members");
  const netloft_element e = table.descriptor();
  const Block block;
  const void* blocks[] = {&block};
  const std::uint32_t part[] = {0};
  netloft_create in{};
  in.size = sizeof in, in.count = in.part_count = 1, in.parameters = blocks, in.part = part;
  void* self = nullptr;
  ASSERT_EQ(e.create(&in, &self), NETLOFT_OK);
  double x[3 * kLanes] = {}, force[3 * kLanes] = {};
  netloft_tile t{};
  t.size = sizeof t, t.want = NETLOFT_WANT_FORCE, t.count = 1, t.x = x, t.force = force;
  EXPECT_EQ(e.terms[0].evaluate(self, &t), NETLOFT_OK);
  e.destroy(self);
  EXPECT_EQ(force[0], 2) << "what was given";
  EXPECT_EQ(force[kLanes], 3) << "what no row declares";
}

struct Push {
  static constexpr auto kind = NETLOFT_TWINE_LAW;
  using Parameters = Shared;
  static void lanes(const Parameters& p, const netloft_law_tile& f) {
    f.force[0] = p.given * static_cast<double>(p.number);
  }
};

TEST(UndeclaredParameters, OfALawKeepTheAuthorsDefaults) {
  LawTable<Push> table("push", "a law");
  table.real("given", &Shared::given, "1", "declared", {.lo = 0, .hi = 10, .fallback = 1});
  double force[3 * kLanes] = {};
  netloft_law_tile flow{};
  flow.size = sizeof flow, flow.count = 1, flow.force = force;
  const Block block;
  EXPECT_EQ(table.descriptor().evaluate(&block, &flow), NETLOFT_OK);
  EXPECT_EQ(force[0], 6);
}

/// A solver whose outcome tells whether it received the right parameters.
struct Teller {
  using Parameters = Shared;
  static Outcome solve(const Parameters& p, Problem&) {
    return p.given == 2 && p.number == 3 ? Outcome::stopped : Outcome::not_finite;
  }
  static Step step(const Parameters& p, Motion&) {
    return p.given == 2 && p.number == 3 ? Step::found : Step::shorter;
  }
  static double order(const Parameters& p) { return static_cast<double>(p.number); }
  static double stable_step(const Parameters& p, double) { return p.given; }
  static void run(const Parameters& p, Search&) {
    if (p.given != 2 || p.number != 3) throw std::runtime_error("other numbers");
  }
};

TEST(UndeclaredParameters, OfASolverAnIntegratorAndAStrategyKeepTheAuthorsDefaults) {
  const auto declare = [](auto&& table) {
    table.real("given", &Shared::given, "1", "declared", {.lo = 0, .hi = 10, .fallback = 1});
    return table.descriptor();
  };
  const Block block;
  netloft_problem problem{};
  EXPECT_EQ(declare(SolverTable<Teller>("teller", "a solver")).solve(&block, &problem), NETLOFT_STOPPED);
  netloft_search search{};
  EXPECT_EQ(declare(StrategyTable<Teller>("teller", "a strategy")).run(&block, &search), NETLOFT_OK);
  const netloft_integrator i = declare(IntegratorTable<Teller>("teller", "an integrator"));
  netloft_motion motion{};
  EXPECT_EQ(i.step(&block, &motion), NETLOFT_OK);
  EXPECT_EQ(i.order(&block), 3);
  EXPECT_EQ(i.stable_step(&block, 1), 2);
}

TEST(UndeclaredParameters, OfOneStructInTwoTablesMustBeTheSame) {
  struct Other : Push {};
  LawTable<Other> one("one", "a law"), two("two", "another");
  one.real("given", &Shared::given, "1", "declared", {.lo = 0, .hi = 10, .fallback = 1});
  one.descriptor();
  two.integer("number", &Shared::number, "declared", 1, 9, 1);
  EXPECT_THROW(two.descriptor(), std::logic_error);
}

}  // namespace
}  // namespace netloft
