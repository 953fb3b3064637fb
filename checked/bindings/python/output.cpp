// SPDX-License-Identifier: MIT
#include "checked/bindings/python/output.hpp"

#include "checked/bindings/python/numbers.hpp"

namespace oplus::python {

namespace {

py::list chain_of(const Chain& chain) { return points_of(chain); }

}  // namespace

py::list components_of(const std::vector<Component>& components) {
  py::list result;
  for (const Component& component : components) {
    py::list holes;
    for (const Chain& hole : component.holes) holes.append(chain_of(hole));
    result.append(py::make_tuple(chain_of(component.outer), holes));
  }
  return result;
}

py::list edges_of(const std::vector<Segment>& edges) {
  py::list result;
  for (const Segment& edge : edges)
    result.append(py::make_tuple(to_python(edge.source), to_python(edge.target)));
  return result;
}

py::list points_of(const std::vector<Point>& points) {
  py::list result;
  for (const Point& p : points) result.append(to_python(p));
  return result;
}

std::string name_of(Location location) {
  return location == Location::inside     ? "inside"
         : location == Location::boundary ? "boundary"
                                          : "outside";
}

py::object error_of(const InvalidInput& error, const std::string& message, const std::string& place,
                    const py::object& index) {
  const auto known = [](std::size_t n) { return n == 0 ? py::object(py::none()) : py::int_(n); };
  return py::module_::import("oplus._errors")
      .attr("InvalidInput")(
          message, py::arg("place") = place, py::arg("line") = known(error.where().line),
          py::arg("column") = known(error.where().column), py::arg("wrong") = error.wrong(),
          py::arg("expected") = error.expected(), py::arg("index") = index);
}

}  // namespace oplus::python
