// SPDX-License-Identifier: BSD-3-Clause
#include "io/python/module/module.hpp"

#include "io/formats/files/installed_folder.hpp"
#include "io/formats/hdf5/handle.hpp"
#include "io/formats/units/units.hpp"
#include "io/formats/work/long_work.hpp"
#include "io/program/session/find_plugins.hpp"
#include "io/python/module/background.hpp"
#include "io/python/module/objects.hpp"
#include "io/python/module/opened_scene.hpp"
#include "io/python/module/python_element.hpp"
#include "io/python/module/python_solver.hpp"
#include "io/results/file/provenance.hpp"

#include <pybind11/stl.h>

namespace netloft::python {

namespace py = pybind11;

namespace {

/// Raises an exception of the package: the class `name` of netloft.errors, called with `arguments`.
template <class... Arguments>
void raise(const char* name, Arguments&&... arguments) {
  const py::object type = py::module_::import("netloft.errors").attr(name);
  const py::object exception = type(std::forward<Arguments>(arguments)...);
  PyErr_SetObject(type.ptr(), exception.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const WrongScene& e) {
    raise(e.refused ? "Refused" : "WrongInput", std::string(e.what()), message_list(e.diagnostics));
  } catch (const PluginRefused& e) {
    raise("Refused", std::string(e.what()), py::list());
  } catch (const formats::FileError& e) {
    PyErr_SetString(PyExc_OSError, e.what());
  } catch (const formats::Interrupted&) {
    PyErr_SetNone(PyExc_KeyboardInterrupt);
  }
}

/// Converts a text with a unit, such as "0.1 m/s", to a number in another unit. Throws std::invalid_argument.
double in_unit(const std::string& text, const std::string& unit) {
  const std::string wanted = unit.empty() ? "1" : unit;
  const auto number = formats::to_si(text, wanted);
  if (!number.ok()) throw std::invalid_argument(text + ": " + number.error);
  return number.value;
}

}  // namespace

// NOLINTNEXTLINE: the macro of pybind11 makes a function
PYBIND11_MODULE(_netloft, module) {
  module.doc() = "Netloft in this process. Use the package netloft, which stands on it.";
  py::register_exception_translator(&translate);
  bind_scenes(module);
  bind_answers(module);
  bind_stored(module);
  bind_problem(module);
  bind_search(module);
  bind_elements(module);
  bind_searches(module);
  program::find_plugins({}, registry());
  module.def("add_plugins", [](const std::string& folder) {
    const ReadingLock lock;
    registry().add_folder(folder);
  });
  module.def("in_unit", &in_unit, py::arg("text"), py::arg("unit"));
  module.def("installed_folder", [] { return formats::installed_folder().string(); });
  module.def("add_solver", &add_solver, py::arg("name"), py::arg("doc"), py::arg("solve"));
  py::module_::import("atexit").attr("register")(py::cpp_function(&finish_left_work));
  module.def("components", [] {
    const ReadingLock lock;
    return registry().available();
  });
  module.attr("__version__") = results::program_version();
}

}  // namespace netloft::python
