// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "checked/bindings/python/arrays.hpp"
#include "checked/bindings/python/module.hpp"
#include "checked/bindings/python/numbers.hpp"
#include "checked/bindings/python/output.hpp"
#include "checked/bindings/python/shapes.hpp"
#include "checked/bindings/python/unlocked.hpp"
#include "checked/bindings/python/workers.hpp"
#include "checked/oplus/internal/named_operations.hpp"

namespace oplus::python {

namespace {

ValidSet planar_set_of(const Set& set) {
  if (const auto* closed = std::get_if<ValidSet>(&set)) return *closed;
  return std::get<PreparedRegion>(set).region();
}

/// The sum of any two sets, of regions by what they keep.
ValidSet sum_of(const Set& p, const Set& q, const SumOptions& options) {
  if (std::holds_alternative<PreparedRegion>(p) && std::holds_alternative<PreparedRegion>(q))
    return minkowski_sum(std::get<PreparedRegion>(p), std::get<PreparedRegion>(q), options);
  return minkowski_sum(planar_set_of(p), planar_set_of(q), options);
}

ValidSet minkowski_sum_of(py::handle p_value, py::handle q_value, const std::string& boundary,
                          bool with_origins, long long threads, py::handle progress) {
  SumOptions options = options_of(threads, progress);
  options.boundary = boundary_of(boundary);
  options.with_origins = with_origins;
  const Set p = set_of(p_value), q = set_of(q_value);
  const Unlocked released;
  return sum_of(p, q, options);
}

/// Of sets with line strings or points: where the two have a common point inside one of them.
ValidSet nfp_of(const Set& p, const Set& q, SumOptions options) {
  if (std::holds_alternative<PreparedRegion>(p) && std::holds_alternative<PreparedRegion>(q))
    return nfp(std::get<PreparedRegion>(p).region(), std::get<PreparedRegion>(q).region(), options);
  options.boundary = Boundary::open;
  return minkowski_sum(planar_set_of(p), -planar_set_of(q), options);
}

ValidSet operation_of(const std::string& name, py::handle p_value, py::handle q_value,
                      long long threads, py::handle progress) {
  const SumOptions options = options_of(threads, progress);
  if (name == "nfp") {
    const Set p = set_of(p_value), q = set_of(q_value);
    return unlocked([&] { return nfp_of(p, q, options); });
  }
  const PreparedRegion p = region_of(p_value), q = region_of(q_value);
  return unlocked([&] { return value_of(name, p.region(), q.region(), options); });
}

/// Adds the edges of a line; its point if it has no other.
void add_line(const std::vector<Coordinates>& line, ClaimedSum& given) {
  bool is_point = !line.empty();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Segment edge{line[i - 1].point(), line[i].point()};
    if (edge.source == edge.target) continue;
    given.dangling_edges.push_back(edge);
    is_point = false;
  }
  if (is_point) given.isolated_vertices.push_back(line[0].point());
}

/// What is claimed to be a sum; of it, nothing is required.
ClaimedSum given_of(py::handle value) {
  ClaimedSum given;
  if (py::isinstance<ValidSet>(value)) {
    const ValidSet sum = value.cast<ValidSet>();
    given = {sum.region().region(), sum.dangling_edges(), sum.isolated_vertices()};
  } else if (py::isinstance<PreparedRegion>(value)) {
    given.region = region_of(value).region().region();
  } else if (is_text(value)) {
    const std::string text = text_of(value);
    const Unlocked released;
    return read_claimed_sum(text);
  } else {
    const Shapes shapes = shapes_of(value);
    try {
      given.region = ValidRegion(shapes.region).region();
    } catch (const InvalidInput&) {
      given.region = shapes.region;
    }
    for (const auto& line : shapes.lines) add_line(line, given);
    for (const Coordinates& point : shapes.points) given.isolated_vertices.push_back(point.point());
  }
  return given;
}

/// The one that is named, else that of a set, else closed.
Boundary boundary_of_given(py::handle value, const std::optional<std::string>& boundary) {
  if (boundary) return boundary_of(*boundary);
  return py::isinstance<ValidSet>(value) ? value.cast<const ValidSet&>().boundary()
                                         : Boundary::closed;
}

/// Returns (reasons, notes), reasons as the arguments of the package's Reason.
py::tuple verify_of(py::handle p_value, py::handle q_value, py::handle value,
                    const std::optional<std::string>& boundary) {
  const PreparedRegion p = region_of(p_value), q = region_of(q_value);
  const ClaimedSum given = given_of(value);
  const Boundary of_given = boundary_of_given(value, boundary);
  const Verdict verdict = unlocked([&] { return verify(p.region(), q.region(), given, of_given); });
  py::list reasons;
  for (const Reason& reason : verdict.reasons)
    reasons.append(py::make_tuple(describe(reason.kind), to_python(reason.witness), reason.in_sum,
                                  reason.in_given, reason.detail));
  return py::make_tuple(reasons, verdict.notes);
}

std::string certify_of(py::handle p_value, py::handle q_value, py::handle value,
                       const std::optional<std::string>& boundary) {
  const PreparedRegion p = region_of(p_value), q = region_of(q_value);
  const ClaimedSum given = given_of(value);
  const Boundary of_given = boundary_of_given(value, boundary);
  const Unlocked released;
  return certify(p.region(), q.region(), given, of_given);
}

Side side_of(const std::string& name) {
  if (name == "nearest") return Side::nearest;
  if (name == "contain") return Side::contain;
  if (name == "contained") return Side::contained;
  throw std::invalid_argument("side " + name + "; expected nearest, contain or contained");
}

py::dict changes_of(const TopologyChanges& c) {
  py::dict result;
  const auto add = [&](const char* name, std::size_t n) {
    if (n != 0) result[name] = n;
  };
  add("vanished_components", c.vanished_components);
  add("joined_components", c.joined_components);
  add("split_components", c.split_components);
  add("new_components", c.new_components);
  add("closed_holes", c.closed_holes);
  add("joined_holes", c.joined_holes);
  add("split_holes", c.split_holes);
  add("opened_holes", c.opened_holes);
  add("new_holes", c.new_holes);
  add("lost_edges_and_points", c.lost_edges_and_points);
  return result;
}

/// Returns the arguments of the package's Rounded.
py::tuple rounded_of(py::handle value, py::handle step_value, const std::string& side_name) {
  const Number step = number_of(step_value);
  const Side side = side_of(side_name);
  const auto result = [&](const auto& exact) {
    const Rounded r = unlocked([&] { return rounded(exact, step, side); });
    return py::make_tuple(r.sum, r.is_exact, to_python(r.bound), changes_of(r.changes));
  };
  if (py::isinstance<ValidSet>(value)) return result(value.cast<ValidSet>());
  return result(region_of(value).region());
}

py::tuple repair(py::handle value, const std::optional<std::string>& fill_name) {
  std::optional<FillRule> fill;
  if (fill_name == "even-odd")
    fill = FillRule::even_odd;
  else if (fill_name == "nonzero")
    fill = FillRule::nonzero;
  else if (fill_name)
    throw std::invalid_argument("fill " + *fill_name + "; expected even-odd or nonzero");
  Repaired result;
  if (py::isinstance<PreparedRegion>(value) || py::isinstance<ValidSet>(value)) {
    result.region = region_of(value).region();
  } else if (is_text(value)) {
    const std::string text = text_of(value);
    const Unlocked released;
    result = repaired_text(text, fill);
  } else {
    Shapes shapes = shapes_of(value);
    if (!shapes.lines.empty() || !shapes.points.empty())
      throw InvalidInput({"geometry", 0, 0}, "line strings or points", "polygons");
    const Unlocked released;
    result = repaired(std::move(shapes.region), fill);
  }
  py::list mends;
  for (const Mend& mend : result.mends) mends.append(mend.what);
  return py::make_tuple(PreparedRegion(std::move(result.region)), mends);
}

PreparedRegion disc_of(py::handle radius, const std::string& side, py::handle error) {
  if (side != "inside" && side != "outside")
    throw std::invalid_argument("side " + side + "; expected inside or outside");
  const Number of_radius = number_of(radius), at_most = number_of(error);
  return unlocked([&] {
    return PreparedRegion(
        disc(of_radius, side == "inside" ? DiscSide::inside : DiscSide::outside, at_most));
  });
}

py::tuple rotation_of(py::handle degrees, py::handle error) {
  const Number angle = number_of(degrees), at_most = number_of(error);
  const AffineMap map = unlocked([&] { return rotation(angle, at_most); });
  return py::make_tuple(to_python(map.a), to_python(map.c));
}

/// The exceptions of the package, with the place of the fault.
void define_errors() {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const InvalidInput& error) {
      const py::object raised = error_of(error, error.what(), error.where().file, py::none());
      PyErr_SetObject(py::type::of(raised).ptr(), raised.ptr());
    }
  });
}

}  // namespace

}  // namespace oplus::python

PYBIND11_MODULE(_oplus, m) {
  namespace python = oplus::python;
  pybind11::options options;
  options.disable_function_signatures();
  m.attr("__version__") = OPLUS_VERSION;
  python::prepare_numbers();
  python::prepare_arrays();
  python::define_errors();
  python::define_sets(m);
  python::define_distances(m);
  python::define_batch(m);
  m.def("minkowski_sum", python::minkowski_sum_of);
  m.def("operation", python::operation_of);
  m.def("verify", python::verify_of);
  m.def("certify", python::certify_of);
  m.def("rounded", python::rounded_of);
  m.def("repair", python::repair);
  m.def("disc", python::disc_of);
  m.def("rotation", python::rotation_of);
  m.def("read_file", [](const std::filesystem::path& path) {
    return python::unlocked([&] { return oplus::PreparedRegion(oplus::read_file(path.string())); });
  });
  m.def("read_set_file", [](const std::filesystem::path& path) {
    return python::unlocked([&] { return oplus::read_set_file(path.string()); });
  });
}
