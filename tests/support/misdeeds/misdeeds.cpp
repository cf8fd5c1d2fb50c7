// SPDX-License-Identifier: BSD-3-Clause
// A plugin with one component of every kind. All of them are correct unless the environment variable MISDEED
// names a function and a fault, such as "term throw"; this function then has this fault.
// tests/regression/cli/test_misdeeds.py lists all functions and faults. The plugin uses the C interface
// directly, because the C++ layer would catch some of the faults.
#include <netloft/ext/integrator.h>
#include <netloft/ext/laws.h>
#include <netloft/ext/strategy.h>
#include <pthread.h>
#include <unistd.h>

#include <cfenv>
#include <cmath>
#include <csetjmp>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string_view>
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace {

std::jmp_buf earlier;
bool may_jump = false;

/// The fault that MISDEED assigns to a function; empty if it has none.
std::string_view deed_of(std::string_view function) {
  const char* all = std::getenv("MISDEED");
  const std::string_view words = all ? all : "";
  const bool is_mine = words.starts_with(function) && words.substr(function.size()).starts_with(' ');
  return is_mine ? words.substr(function.size() + 1) : std::string_view();
}

/// Recurses without end; its result prevents the compiler from making a loop.
int overflow(int depth) {
  volatile char here[512];
  here[0] = static_cast<char>(depth);
  return overflow(depth + 1) + here[0];
}

void leave_mode([[maybe_unused]] std::string_view deed) {
  if (deed == "rounding") std::fesetround(FE_UPWARD);
#if defined(__x86_64__)
  if (deed == "subnormals") _mm_setcsr(_mm_getcsr() | 0x8040);
  if (deed == "traps") _mm_setcsr(_mm_getcsr() & ~0x0200u);  // of a division by zero
#endif
}

void end(std::string_view deed) {
  if (deed == "exit") std::exit(0);
  if (deed == "quick_exit") std::quick_exit(0);
  if (deed == "_exit") _exit(0);
  if (deed == "_Exit") std::_Exit(0);
  if (deed == "pthread_exit") pthread_exit(nullptr);
  if (deed == "terminate") std::terminate();
  if (deed == "abort") std::abort();
  if (deed == "crash") std::raise(SIGSEGV);
  if (deed == "divide") std::raise(SIGFPE);
  if (deed == "recursion" && overflow(0) == 1) std::abort();
}

/// Commits the fault assigned to a function. Returns the status that the function should return.
int act(std::string_view function, int right = NETLOFT_OK) {
  const std::string_view deed = deed_of(function);
  if (deed.empty()) return right;
  end(deed);
  leave_mode(deed);
  if (deed == "throw") throw std::runtime_error("unfinished");
  if (deed == "throw_int") throw 1;
  if (deed == "error") return NETLOFT_ERROR;
  if (deed == "no_status") return 77;
  return right;
}

/// Fills the memory for a message to its last byte, and returns an error.
int act_with_words(std::string_view function, char* words, std::uint32_t size, int failed,
                   int right = NETLOFT_OK) {
  if (deed_of(function) != "endless_words") return act(function, right);
  std::memset(words, 'x', size);
  return failed;
}

double number_of(std::string_view function, double right) {
  act(function);
  const std::string_view deed = deed_of(function);
  return deed == "nan" ? std::nan("") : deed == "minus" ? -1 : right;
}

// ---------------------------------------------------------------- an element: a weight of 100 N

int create(netloft_create* in, void** self) {
  static int family;
  *self = &family;
  const int status = act_with_words("create", in->message, in->message_size, NETLOFT_ERROR);
  if (deed_of("create") == "no_self") *self = nullptr;
  if (deed_of("create") == "wild_fault") in->at_fault = ~0u;
  return deed_of("create") == "wild_fault" ? int{NETLOFT_ERROR} : status;
}

void destroy(void*) { act("destroy"); }

int pull(const void*, netloft_tile* t) {
  if (deed_of("term") == "jump" && may_jump) std::longjmp(earlier, 1);
  const int status = act_with_words("term", t->message, t->message_size, NETLOFT_ERROR);
  for (std::uint32_t i = 0; i < t->count; ++i) {
    if (t->energy) t->energy[i] += 100 * t->x[2 * NETLOFT_LANES + i];
    if (t->force) t->force[2 * NETLOFT_LANES + i] += deed_of("term") == "nan" ? std::nan("") : 100;
  }
  if (deed_of("term") == "wild_fault") t->lane_at_fault = ~0u, t->count = 0, t->message = nullptr;
  return deed_of("term") == "wild_fault" ? int{NETLOFT_ERROR} : status;
}

int output(const void*, netloft_tile* t, double* values) {
  for (std::uint32_t i = 0; i < t->count; ++i) values[i] = 100;
  return act("outputs");
}

// ---------------------------------------------------------------- a law

int force(const void*, const netloft_law_tile* f) {
  const double answer = deed_of("law") == "nan" ? std::nan("") : 0;
  const auto write = [&](double* values, std::uint32_t rows) {
    for (std::uint32_t row = 0; values && row < rows; ++row)
      for (std::uint32_t i = 0; i < f->count; ++i) values[row * NETLOFT_LANES + i] = answer;
  };
  write(f->force, 3), write(f->d_flow, 9), write(f->d_direction, 9), write(f->d_solidity, 3);
  return act("law");
}

// ---------------------------------------------------------------- a solver, which calls the elements and
// gives up

int solve(const void*, netloft_problem* p) {
  const int status =
      act_with_words("solve", p->message, p->message_size, NETLOFT_SOLVER_ERROR, NETLOFT_STEP_TOO_SHORT);
  double energy = 0;
  auto* r = static_cast<double*>(std::calloc(p->unknowns, sizeof(double)));
  if (setjmp(earlier) == 0) {
    may_jump = true;
    p->evaluate(p->host, NETLOFT_WANT_FORCE | NETLOFT_WANT_ENERGY, p->u, &energy, r);
  }
  may_jump = false;
  if (deed_of("solve") == "nan")
    for (std::uint32_t i = 0; i < p->unknowns; ++i) p->u[i] = std::nan("");
  if (deed_of("solve") == "nulls") p->u = nullptr, p->message = nullptr, p->host = nullptr, p->unknowns = 0;
  if (deed_of("solve") == "lie") return NETLOFT_STOPPED;
  std::free(r);
  return status;
}

// ---------------------------------------------------------------- an integrator: velocity Verlet

int step(const void*, netloft_motion* m) {
  const int status = act_with_words("step", m->message, m->message_size, NETLOFT_ERROR);
  const std::string_view deed = deed_of("step");
  const double go = deed == "nothing" || deed == "stops" ? 0 : 1;
  for (std::uint32_t i = 0; i < m->unknowns; ++i) {
    m->u_new[i] = m->u[i] + go * m->h * (m->v[i] + 0.5 * m->h * m->a[i]);
    m->v_new[i] = m->v[i] + go * m->h * m->a[i];
    m->a_new[i] = deed == "stops" ? 0 : m->a[i];
  }
  if (deed == "still_positions") std::memcpy(m->u_new, m->u, m->unknowns * sizeof(double));
  if (go != 0 && m->accelerate(m->host, m->t + m->h, m->u_new, m->v_new, m->a_new) != NETLOFT_OK)
    return NETLOFT_OUTSIDE_DOMAIN;
  for (std::uint32_t i = 0; go != 0 && i < m->unknowns; ++i) {
    if (deed == "ignores_forces") m->a_new[i] = 0;
    m->v_new[i] = m->v[i] + (deed == "ignores_forces" ? 0 : 0.5 * m->h * (m->a[i] + m->a_new[i]));
    if (deed == "backwards") m->v_new[i] = m->v[i] - 0.5 * m->h * (m->a[i] + m->a_new[i]);
    if (deed == "nan") m->u_new[i] = std::nan("");
  }
  if (deed == "nulls") m->u_new = m->v_new = nullptr, m->host = nullptr, m->message = nullptr;
  return status;
}
double order(const void*) { return number_of("order", 3); }
double stable_step(const void*, double omega) { return number_of("stable_step", 2 / omega); }

// ---------------------------------------------------------------- a strategy: the scene itself, once

int run(const void*, netloft_search* s) {
  const int status = act_with_words("run", s->message, s->message_size, NETLOFT_ERROR);
  netloft_stage stage{};
  stage.size = sizeof stage, stage.name = "once";
  stage.variant.size = sizeof stage.variant, stage.variant.compression = stage.variant.current = 1;
  stage.u = static_cast<double*>(std::calloc(s->unknowns, sizeof(double)));
  if (deed_of("run") == "wild_stage") stage.variant.level = ~0u;
  if (deed_of("run") == "wild_solver") stage.solver = "nowhere", stage.parameters = "=,=";
  if (deed_of("run") == "calls_itself") s->call(s->host, "misdeeds/strategy", nullptr, &stage);
  if (setjmp(earlier) == 0) {
    may_jump = deed_of("term") == "jump";
    if (deed_of("run") != "nothing") s->solve(s->host, &stage);
  }
  may_jump = false;
  if (deed_of("run") == "lie")
    for (std::uint32_t i = 0; i < s->unknowns; ++i) stage.u[i] += 1;
  if (deed_of("run") == "nan")
    for (std::uint32_t i = 0; i < s->unknowns; ++i) stage.u[i] = std::nan("");
  if (deed_of("run") != "nothing") s->answer(s->host, stage.u);
  if (deed_of("run") == "nulls") s->host = nullptr, s->message = nullptr, s->start = nullptr;
  return status;
}

int explain(const void*, netloft_search* s, char* text, std::uint32_t size) {
  const std::string_view deed = deed_of("explain");
  if (deed == "endless_text") std::memset(text, 'x', size);
  if (deed == "nulls") s->host = nullptr, s->message = nullptr;
  return act_with_words("explain", s->message, s->message_size, NETLOFT_ERROR);
}

// ---------------------------------------------------------------- the tables

const void* law_list() {
  static netloft_law law{};
  law.size = sizeof law, law.kind = NETLOFT_TWINE_LAW, law.name = "law", law.doc = "no force";
  law.evaluate = deed_of("table") == "null_function" ? nullptr : force;
  static const netloft_laws list{sizeof list, 1, &law};
  return &list;
}
const void* solver_list() {
  static netloft_solver solver{};
  solver.size = sizeof solver, solver.name = "solver", solver.doc = "gives up", solver.solve = solve;
  if (deed_of("table") == "null_solver_name") solver.name = nullptr;
  static const netloft_solvers list{sizeof list, 1, &solver};
  return &list;
}
const void* integrator_list() {
  static netloft_integrator integrator{};
  integrator.size = sizeof integrator, integrator.name = "integrator", integrator.doc = "velocity Verlet";
  integrator.traits = NETLOFT_EXPLICIT, integrator.step = step, integrator.order = order;
  integrator.stable_step = stable_step;
  static const netloft_integrators list{sizeof list, 1, &integrator};
  return &list;
}
const void* strategy_list() {
  static netloft_strategy strategy{};
  strategy.size = sizeof strategy, strategy.name = "strategy", strategy.doc = "the scene itself";
  strategy.run = run, strategy.explain = explain;
  static netloft_strategies list{sizeof list, 1, &strategy};
  if (deed_of("table") == "null_rows") list.rows = nullptr;
  if (deed_of("table") == "huge_count") list.count = ~0u;
  return &list;
}

}  // namespace

extern "C" NETLOFT_EXPORT const netloft_plugin* netloft_plugin_v1(void) {
  if (act("describe") != NETLOFT_OK) return nullptr;
  const std::string_view deed = deed_of("table");
  static netloft_term term{};
  term.size = sizeof term, term.name = "pull", term.doc = "its weight", term.evaluate = pull;
  term.traits = NETLOFT_CONSERVATIVE | NETLOFT_SYMMETRIC | NETLOFT_CONSTANT | NETLOFT_FROM_OUTSIDE;
  static netloft_output pulled{};
  pulled.size = sizeof pulled, pulled.name = "pull", pulled.unit = "N", pulled.doc = "its weight";
  static netloft_element element{};
  element.size = sizeof element, element.name = "element", element.doc = "a weight",
  element.stencil = NETLOFT_NODE;
  element.terms = &term, element.term_count = 1, element.outputs = &pulled, element.output_count = 1;
  element.create = create, element.destroy = destroy, element.output = output;
  static netloft_plugin plugin{};
  plugin.size = sizeof plugin, plugin.abi_major = NETLOFT_ABI_MAJOR, plugin.abi_minor = NETLOFT_ABI_MINOR;
  plugin.name = "misdeeds", plugin.version = "1", plugin.doc = "misdeeds", plugin.compiler = "";
  plugin.elements = &element, plugin.element_count = 1;
  plugin.extension = [](const char* id) -> const void* {
    const std::string_view name = id;
    return name == NETLOFT_EXT_LAWS         ? law_list()
           : name == NETLOFT_EXT_SOLVER     ? solver_list()
           : name == NETLOFT_EXT_INTEGRATOR ? integrator_list()
           : name == NETLOFT_EXT_STRATEGY   ? strategy_list()
                                            : nullptr;
  };
  if (deed == "null_name") plugin.name = nullptr;
  if (deed == "null_element_name") element.name = nullptr;
  if (deed == "null_term_name") term.name = nullptr;
  if (deed == "null_create") element.create = nullptr;
  if (deed == "null_elements") plugin.elements = nullptr;
  if (deed == "huge_elements") plugin.element_count = ~0u;
  if (deed == "huge_terms") element.term_count = ~0u;
  if (deed == "huge_parameters") element.parameter_bytes = ~0u;
  if (deed == "no_size") plugin.size = 0;
  if (deed == "no_element_size") element.size = 0;
  if (deed == "huge_size") element.size = ~0u;
  if (deed == "wild_stencil") element.stencil = 0xff;
  if (deed == "control_characters") element.name = "ele\033[31mment";
  return &plugin;
}
