// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <oplus/engines.hpp>
#include <string>

/// The other engines, each for the module _oplus of the same build. They are over CGAL's arrangements, so this module is
/// under the GPL, and the package does without it.
PYBIND11_MODULE(_engines, m) {
  m.def("names", oplus::engine_names);
  m.def("engine",
        [](const std::string& name) { return pybind11::capsule(oplus::engine(name), "engine"); });
}
