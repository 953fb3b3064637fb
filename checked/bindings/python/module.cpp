// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "checked/bindings/python/arrays.hpp"
#include "checked/bindings/python/numbers.hpp"
#include "checked/bindings/python/operation.hpp"
#include "checked/bindings/python/output.hpp"
#include "checked/bindings/python/results.hpp"
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

ValidSet minkowski_sum_of(py::handle p_value, py::handle q_value, const std::string& boundary,
                          long long threads) {
  const SumOptions options =
      interruptible({.boundary = boundary_of(boundary), .threads = checked_threads(threads)});
  const Set p = set_of(p_value), q = set_of(q_value);
  const Unlocked released;
  if (std::holds_alternative<PreparedRegion>(p) && std::holds_alternative<PreparedRegion>(q))
    return minkowski_sum(std::get<PreparedRegion>(p), std::get<PreparedRegion>(q), options);
  return minkowski_sum(planar_set_of(p), planar_set_of(q), options);
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

Verdict verify_of(py::handle p_value, py::handle q_value, py::handle value,
                  const std::optional<std::string>& boundary) {
  const PreparedRegion p = region_of(p_value), q = region_of(q_value);
  const ClaimedSum given = given_of(value);
  const Boundary of_given = boundary_of_given(value, boundary);
  const Unlocked released;
  return verify(p.region(), q.region(), given, of_given);
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

Rounded rounded_of(py::handle value, py::handle step_value, const std::string& side_name) {
  const Number step = number_of(step_value);
  const Side side = side_of(side_name);
  if (py::isinstance<ValidSet>(value)) {
    const ValidSet sum = value.cast<ValidSet>();
    const Unlocked released;
    return rounded(sum, step, side);
  }
  const PreparedRegion region = region_of(value);
  const Unlocked released;
  return rounded(region.region(), step, side);
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

py::object complement_of(py::handle value) {
  if (py::isinstance<ValidSet>(value)) {
    const ValidSet& sum = value.cast<const ValidSet&>();
    return py::cast(unlocked([&] { return complement(sum); }));
  }
  const PreparedRegion region = region_of(value);
  return py::cast(unlocked([&] { return PreparedRegion(complement(region.region())); }));
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

/// What the docstring of an operation says besides the table's words: on its result, and an example.
struct Remark {
  const char* name;
  const char* text;
};
constexpr Remark remarks[] = {
    {"nfp", R"( It is an open set.
On its boundary, with dangling edges and isolated vertices, the two only touch.

>>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
>>> print(oplus.nfp(square, square))
POLYGON ((-1 -1, 1 -1, 1 1, -1 1, -1 -1))
)"},
    {"ifp", R"( It is a closed set.
Where q fits exactly there are dangling edges and isolated vertices.

>>> bin = [[0, 0], [100, 0], [100, 100], [0, 100]]
>>> print(oplus.ifp(bin, bin))
GEOMETRYCOLLECTION (POINT (0 0))
)"},
    {"erode", R"(

>>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
>>> print(oplus.erode([[0, 0], [3, 0], [3, 2], [0, 2]], square))
POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))
)"},
    {"open", R"(

>>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
>>> print(oplus.open([[0, 0], [3, 0], [3, '1/2'], [2, '1/2'], [2, 2], [0, 2]], square))
POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))
)"},
    {"close", R"( It contains p.

>>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
>>> notched = [[0, 0], [3, 0], [3, 2], [2, 2], [2, 1], ['3/2', 1], ['3/2', 2], [0, 2]]
>>> print(oplus.close(notched, square))
POLYGON ((0 0, 3 0, 3 2, 0 2, 0 0))
)"},
};

std::string doc_of(const std::string& name, const std::string& what) {
  std::string doc = name + "(p, q, *, threads=1)\n--\n\nReturns " + what + '.';
  // The arguments are p and q here. No word begins with either letter.
  std::ranges::replace(doc, 'P', 'p');
  std::ranges::replace(doc, 'Q', 'q');
  for (const Remark& remark : remarks)
    if (name == remark.name) doc += remark.text;
  return doc;
}

void define_operations(py::module_& m) {
  m.def("minkowski_sum", minkowski_sum_of, py::arg("p"), py::arg("q"), py::kw_only(),
        py::arg("boundary") = "closed", py::arg("threads") = 1,
        R"(minkowski_sum(p, q, *, boundary='closed', threads=1)
--

Returns the Minkowski sum, the set of all p + q, exactly.

p, q: whatever Region or PlanarSet takes. boundary: 'closed', or 'open' for the sum of the
interiors, which has dangling edges and isolated vertices. threads: 0 for all cores.

>>> print(oplus.minkowski_sum([[0, 0], [2, 0], [0, 2]], [[0, 0], [1, 0], [1, 1], [0, 1]]))
POLYGON ((0 0, 3 0, 3 1, 1 3, 0 3, 0 0))
)");
  for (const auto& [name, what] : named_operations()) {
    const auto compute = [name = name](py::handle p_value, py::handle q_value, long long threads) {
      const SumOptions options = interruptible({.threads = checked_threads(threads)});
      const PreparedRegion p = region_of(p_value), q = region_of(q_value);
      return unlocked([&] { return value_of(name, p.region(), q.region(), options); });
    };
    m.def(name.c_str(), compute, py::arg("p"), py::arg("q"), py::kw_only(), py::arg("threads") = 1,
          doc_of(name, what).c_str());
  }
}

void define_others(py::module_& m) {
  m.def("verify", verify_of, py::arg("p"), py::arg("q"), py::arg("given"), py::kw_only(),
        py::arg("boundary") = py::none(), R"(verify(p, q, given, *, boundary=None)
--

Decides whether `given` is the sum of p and q, by the definitions and by no engine. It is a PlanarSet or
whatever Region takes, or what would be invalid: chains of geometries and lists may cross. boundary:
'closed' or 'open'; None: that of a PlanarSet, closed for others. Raises InvalidInput where a region is
unbounded.

>>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
>>> verdict = oplus.verify(square, square, [[0, 0], [2, 0], [2, 2], [1, 2], [0, 1]])
>>> bool(verdict), verdict.reasons
(False, [<oplus.Reason: in the sum but not given>])
)");
  m.def("certify", certify_of, py::arg("p"), py::arg("q"), py::arg("given"), py::kw_only(),
        py::arg("boundary") = py::none(), R"(certify(p, q, given, *, boundary=None)
--

Returns the text of a certificate that `given` is the sum of p and q, for the program
oplus-certified, which is proved. It reads p, q and `given` as files, with chains and vertices in
the same order: what to_wkt returns. `given` and `boundary` are whatever verify takes. Raises InvalidInput,
with the first reason of verify, where it is not the sum.

>>> square = oplus.Region([[0, 0], [1, 0], [1, 1], [0, 1]])
>>> certificate = oplus.certify(square, square, oplus.minkowski_sum(square, square))
>>> certificate.splitlines()[0]
'oplus certificate 2'
)");
  m.def("rounded", rounded_of, py::arg("value"), py::arg("step"), py::arg("side") = "nearest",
        R"(rounded(value, step, side='nearest')
--

Returns a Rounded: a valid set whose coordinates are multiples of `step`, and how far it is from the
exact one. value: a PlanarSet, or whatever Region takes. side: 'nearest', 'contain' for a set that
contains it, 'contained' for one that is contained in it. Steps 2**-k give exact doubles.

>>> third = oplus.rounded([[0, 0], ['1/3', 0], [0, 1]], '0.01')
>>> print(third.sum, third.bound)
POLYGON ((0 0, 0.33 0, 0 1, 0 0)) 1/200
)");
  m.def("repair", repair, py::arg("value"), py::arg("fill") = py::none(),
        R"(repair(value, fill=None)
--

Returns (Region, list of what was done): repeated vertices, spikes and chains that enclose nothing
are left out. Where chains still cross or overlap: what they enclose by the rule fill='even-odd' or
'nonzero', else InvalidInput is raised. value: text, or whatever Region takes.

>>> region, mends = oplus.repair([[0, 0], [2, 2], [2, 0], [0, 2]], fill='even-odd')
>>> region.area
Fraction(2, 1)
)");
  m.def("complement", complement_of, py::arg("value"), R"(complement(value)
--

Returns the complement: of a region a Region, of a PlanarSet a PlanarSet, closed of an open one, and
the reverse.

>>> outside = oplus.complement([[0, 0], [1, 0], [0, 1]])
>>> (5, 5) in outside
True
)");
  m.def(
      "read_file",
      [](const std::filesystem::path& path) {
        return unlocked([&] { return PreparedRegion(read_file(path.string())); });
      },
      py::arg("path"), R"(read_file(path)
--

Returns the Region in a file, in any format that oplus reads. Raises InvalidInput.

>>> oplus.read_file('missing.wkt')
Traceback (most recent call last):
    ...
oplus.InvalidInput: missing.wkt: cannot be opened (No such file or directory); expected a file that can be read
)");
  m.def(
      "read_set_file",
      [](const std::filesystem::path& path) {
        return unlocked([&] { return read_set_file(path.string()); });
      },
      py::arg("path"), R"(read_set_file(path)
--

Returns the PlanarSet in a file, with its line strings and points. Raises InvalidInput.

>>> oplus.read_set_file('missing.wkt')
Traceback (most recent call last):
    ...
oplus.InvalidInput: missing.wkt: cannot be opened (No such file or directory); expected a file that can be read
)");
  m.def("disc", disc_of, py::arg("radius"), py::arg("side"), py::arg("error"),
        R"(disc(radius, side, error)
--

Returns a convex polygon inside or around the disc about the origin, at most `error` away from it.
side: 'inside' or 'outside'. Its sum with a region is an offset. Raises InvalidInput for an `error`
that needs more than 1000000 vertices.

>>> (1, 0) in oplus.disc(1, 'outside', '0.01')
True
)");
  m.def("rotation", rotation_of, py::arg("degrees"), py::arg("error") = "1/1000",
        R"(rotation(degrees, error='1/1000')
--

Returns the exact cosine and sine that Region.rotated takes: Fractions. `error` is in degrees, and
positive.

>>> oplus.rotation(90)
(Fraction(0, 1), Fraction(1, 1))
>>> cosine, sine = oplus.rotation(30, 1)
>>> cosine**2 + sine**2
Fraction(1, 1)
)");
}

void define_errors(py::module_& m) {
  const auto type = py::register_exception<InvalidInput>(m, "InvalidInput", PyExc_ValueError);
  type.attr("__module__") = "oplus";
  type.attr("__doc__") =
      "Invalid input. The message is one line: what is wrong and what was expected.";
}

}  // namespace

}  // namespace oplus::python

PYBIND11_MODULE(_oplus, m) {
  namespace python = oplus::python;
  pybind11::options options;
  options.disable_function_signatures();
  m.attr("__version__") = OPLUS_VERSION;
  python::prepare_numbers();
  python::define_errors(m);
  python::define_arrays(m);
  python::define_regions(m);
  python::define_results(m);
  python::define_operations(m);
  python::define_batch(m);
  python::define_distances(m);
  python::define_others(m);
}
