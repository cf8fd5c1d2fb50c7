// SPDX-License-Identifier: BSD-3-Clause
#include "io/python/module/answer.hpp"
#include "io/python/module/background.hpp"
#include "io/python/module/module.hpp"
#include "io/python/module/motion.hpp"
#include "io/python/module/objects.hpp"

#include <pybind11/functional.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <optional>

namespace netloft::python {

namespace py = pybind11;

namespace {

using AnswerPointer = std::shared_ptr<Answer>;

/// The numbers of a scene with these paths; if there are no paths, all numbers of its tables and all
/// parameters of its parts.
py::list numbers_of_scene(const OpenedScene& scene) {
  using Numbers = std::vector<studies::SceneNumber>;
  return scene_number_list(in_background<Numbers>([&](const std::atomic<bool>&) {
    const auto prepared = scene.prepare();
    const ReadingLock lock;
    Numbers all = studies::chosen_numbers(*prepared, {});
    for (auto& number : studies::parameters_of(prepared->loaded(), registry()))
      all.push_back(std::move(number));
    return all;
  }));
}

/// Facts about the numbers of a scene, by their paths: unit [SI], half a sentence, range.
py::dict words_of_scene(const OpenedScene& scene) {
  using Words = std::map<std::string, formats::NumberWords>;
  py::dict all;
  for (const auto& [path, known] :
       in_background<Words>([&](const std::atomic<bool>&) { return scene.words(); }))
    all[py::str(path)] = py::make_tuple(known.unit, known.doc, known.range.lo, known.range.hi);
  return all;
}

std::vector<std::string> part_names(const OpenedScene& scene) {
  return in_background<std::vector<std::string>>([&](const std::atomic<bool>&) {
    std::vector<std::string> names;
    const auto prepared = scene.prepare();
    for (const auto& part : prepared->loaded().scene.parts) names.push_back(part.name);
    return names;
  });
}

/// Work in the background that reports its progress to a callable of Python. An exception of the callable
/// ends the work.
class Watched {
 public:
  explicit Watched(const py::object& progress)
      : progress_(new py::object(progress), [](const py::object* last) {
          const py::gil_scoped_acquire
              interpreter;  // work that goes on after the call ends in its own thread
          delete last;
        }) {}

  /// Calls the callable from the thread that does the work.
  template <class... Numbers>
  void report(Numbers... numbers) {
    if (progress_->is_none()) return;
    const py::gil_scoped_acquire interpreter;
    try {
      (*progress_)(numbers...);
    } catch (...) {
      raised_ = std::current_exception();
      *interrupt_ = true;
    }
  }
  /// The exception of the callable or of a signal that ended the work; None if there was no exception.
  py::object run(const std::function<void(const std::atomic<bool>&)>& work) {
    return exception(call_in_background(watched(work)));
  }
  /// Like run(), for work that may go on after a signal, and then owns this object; see call_or_leave().
  py::object run_or_leave(const std::function<void(const std::atomic<bool>&)>& work,
                          std::function<void()>& finish) {
    EndOfWork end = call_or_leave(watched(work));
    finish = std::move(end.finish);
    return exception(end.raised);
  }

 private:
  std::function<void(std::atomic<bool>&)> watched(const std::function<void(const std::atomic<bool>&)>& work) {
    return [this, work](std::atomic<bool>& interrupt) {
      interrupt_ = &interrupt;
      work(interrupt);
    };
  }
  py::object exception(const std::exception_ptr& by_signal) const {
    try {
      if (by_signal) std::rethrow_exception(by_signal);
      if (raised_) std::rethrow_exception(raised_);
    } catch (py::error_already_set& e) {
      return e.value();
    }
    return py::none();
  }

  std::shared_ptr<const py::object> progress_;
  std::atomic<bool>* interrupt_ = nullptr;
  std::exception_ptr raised_;
};

/// All that a search for an equilibrium uses.
struct WatchedSearch {
  OpenedScene scene;
  Watched watched;
  SolveRequest request;
  AnswerPointer answer = nullptr;

  void run(const std::atomic<bool>& interrupt) {
    request.on_iteration = [this](const IterationRecord& r) {
      watched.report(r.iteration, r.residual, r.scale);
    };
    answer = std::make_shared<Answer>(scene, request, interrupt);
  }
};

/// Solves a scene on its own mesh, or on the mesh of the answer `mesh_of`. `progress` is called after each
/// iteration with its number, the largest residual and the largest load [N]. Returns the answer, the
/// exception that ended the search, and a function. If the search still goes on after a signal, the function
/// waits for its answer; otherwise it is None.
py::tuple solve(const OpenedScene& scene, const std::vector<double>& start, const AnswerPointer& mesh_of,
                bool with_mesh_errors, const py::object& progress) {
  const auto search = std::make_shared<WatchedSearch>(WatchedSearch{
      scene, Watched(progress), {start, mesh_of ? mesh_of->scene() : nullptr, with_mesh_errors}});
  std::function<void()> finish;
  const py::object ended_by = search->watched.run_or_leave(
      [search](const std::atomic<bool>& interrupt) { search->run(interrupt); }, finish);
  if (!finish) return py::make_tuple(search->answer, ended_by, py::none());
  return py::make_tuple(py::none(), ended_by, py::cpp_function([search, finish] {
                          finish();
                          return search->answer;
                        }));
}

/// Computes a motion. `progress` is called after each step with the present time and the time of the end [s].
/// Returns the file, warnings, and the exception that ended the motion.
py::tuple simulate_scene(const OpenedScene& scene, const std::filesystem::path& output,
                         const py::object& progress) {
  Watched watched(progress);
  MotionEnd end;
  const py::object ended_by = watched.run([&](const std::atomic<bool>& interrupt) {
    end = simulate(
        scene, output, [&](double t, double of) { watched.report(t, of); }, interrupt);
  });
  return py::make_tuple(end.file, end.warnings, ended_by);
}

}  // namespace

void bind_scenes(py::module_& module) {
  py::class_<OpenedScene>(module, "OpenedScene")
      .def(py::init([](const std::string& file) { return OpenedScene(file); }), py::arg("file"))
      .def("with_", &OpenedScene::with, py::arg("changes"))
      .def("by", &OpenedScene::by, py::arg("key"), py::arg("specification"))
      .def_property_readonly("file", &OpenedScene::file)
      .def_property_readonly("changes", &OpenedScene::changes)
      .def("tables", [](const OpenedScene& s) { return value_object(s.tables()); })
      .def("check", [](const OpenedScene& s) { return message_list(s.check()); })
      .def("numbers", &numbers_of_scene)
      .def("words", &words_of_scene)
      .def("parts", &part_names)
      .def("solve", &solve, py::arg("start"), py::arg("mesh_of"), py::arg("with_mesh_errors"),
           py::arg("progress"))
      .def("simulate", &simulate_scene, py::arg("output"), py::arg("progress"));
}

}  // namespace netloft::python
