// SPDX-License-Identifier: MIT
#include <optional>

#include "checked/bindings/python/module.hpp"
#include "checked/bindings/python/numbers.hpp"
#include "checked/bindings/python/output.hpp"
#include "checked/bindings/python/shapes.hpp"
#include "checked/bindings/python/unlocked.hpp"
#include "checked/bindings/python/workers.hpp"

namespace oplus::python {

namespace {

py::object answer(const NearestPoints& nearest) {
  return py::make_tuple(to_python(nearest.squared_distance), to_python(nearest.on_p),
                        to_python(nearest.on_q));
}

py::object answer(const std::optional<Overlap>& overlap) {
  if (!overlap) return py::none();
  return py::make_tuple(to_python(overlap->move), to_python(overlap->squared_depth),
                        to_python(overlap->contact));
}

py::object answer(Location location) { return py::str(name_of(location)); }

/// A function of two regions.
template <typename Compute>
auto of_pair(Compute compute) {
  return [compute](py::handle p_value, py::handle q_value) {
    const PreparedRegion p = region_of(p_value), q = region_of(q_value);
    return answer(unlocked([&] { return compute(p.region(), q.region()); }));
  };
}

/// A function of a place of Q.
template <typename Ask>
auto at_place(Ask ask) {
  return [ask](const Placements& placements, py::handle place) {
    const Point x = point_of(place);
    return answer(unlocked([&] { return ask(placements, x); }));
  };
}

}  // namespace

void define_distances(py::module_& m) {
  m.def("distance", of_pair([](const auto& p, const auto& q) { return distance(p, q); }));
  m.def("depth", of_pair([](const auto& p, const auto& q) { return depth(p, q); }));
  py::class_<Placements>(m, "Placements")
      .def(py::init(
          [](py::handle p_value, py::handle q_value, long long threads, py::handle progress) {
            const PreparedRegion p = region_of(p_value), q = region_of(q_value);
            const SumOptions options = options_of(threads, progress);
            return unlocked([&] { return Placements(p.region(), q.region(), options); });
          }))
      .def("no_fit", [](const Placements& placements) { return placements.no_fit(); })
      .def("locate", at_place([](const auto& of, const auto& x) { return of.locate(x); }))
      .def("depth", at_place([](const auto& of, const auto& x) { return of.depth(x); }))
      .def("distance", at_place([](const auto& of, const auto& x) { return of.distance(x); }));
}

}  // namespace oplus::python
