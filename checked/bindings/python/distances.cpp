// SPDX-License-Identifier: MIT
#include <optional>

#include "checked/bindings/python/numbers.hpp"
#include "checked/bindings/python/output.hpp"
#include "checked/bindings/python/results.hpp"
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
  m.def("distance", of_pair([](const auto& p, const auto& q) { return distance(p, q); }),
        py::arg("p"), py::arg("q"), R"(distance(p, q)
--

Returns (the squared distance, a point of p, a point of q): exact ones, as near to each other as any.
The squared distance is 0 where p and q overlap or touch. Raises InvalidInput where one is empty.

>>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
>>> oplus.distance(square, oplus.Region(square).translated(3, '3/2'))
(Fraction(17, 4), (Fraction(1, 1), Fraction(1, 1)), (Fraction(3, 1), Fraction(3, 2)))
)");
  m.def("depth", of_pair([](const auto& p, const auto& q) { return depth(p, q); }), py::arg("p"),
        py::arg("q"), R"(depth(p, q)
--

Returns (move, its squared length, contact): a shortest move of q after which it overlaps p no longer,
and a point in which the two touch then; None where they don't overlap. Raises InvalidInput where they
overlap wherever q is.

>>> square = [[0, 0], [4, 0], [4, 4], [0, 4]]
>>> oplus.depth(square, [[1, 3], [3, 3], [3, 6], [1, 6]])
((Fraction(0, 1), Fraction(1, 1)), Fraction(1, 1), (Fraction(1, 1), Fraction(4, 1)))
)");
  py::class_<Placements>(m, "Placements", R"(A pair of regions for many places of q.

Placements(p, q, *, threads=1) computes their no-fit polygon once. q + x is q moved by x.

>>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
>>> oplus.Placements(square, square).locate((3, 0))
'outside'
)")
      .def(py::init([](py::handle p_value, py::handle q_value, long long threads) {
             const PreparedRegion p = region_of(p_value), q = region_of(q_value);
             const SumOptions options = interruptible({.threads = checked_threads(threads)});
             return unlocked([&] { return Placements(p.region(), q.region(), options); });
           }),
           py::arg("p"), py::arg("q"), py::kw_only(), py::arg("threads") = 1)
      .def_property_readonly(
          "no_fit", [](const Placements& placements) { return placements.no_fit(); },
          R"(The no-fit polygon, as nfp returns it.

>>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
>>> print(oplus.Placements(square, square).no_fit)
POLYGON ((-1 -1, 1 -1, 1 1, -1 1, -1 -1))
)")
      .def("locate", at_place([](const auto& of, const auto& x) { return of.locate(x); }),
           py::arg("x"), R"(locate(x)
--

Returns 'inside' where q + x overlaps p, 'boundary' where they only touch, else 'outside'.

>>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
>>> at = oplus.Placements(square, square)
>>> at.locate((0, 0)), at.locate((1, '1/2')), at.locate((2, 0))
('inside', 'boundary', 'outside')
)")
      .def("depth", at_place([](const auto& of, const auto& x) { return of.depth(x); }),
           py::arg("x"), R"(depth(x)
--

Returns depth(p, q + x).

>>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
>>> move, squared_depth, contact = oplus.Placements(square, square).depth(('1/2', '1/4'))
>>> move, squared_depth
((Fraction(1, 2), Fraction(0, 1)), Fraction(1, 4))
)")
      .def("distance", at_place([](const auto& of, const auto& x) { return of.distance(x); }),
           py::arg("x"), R"(distance(x)
--

Returns distance(p, q + x).

>>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
>>> oplus.Placements(square, square).distance((3, 2))
(Fraction(5, 1), (Fraction(1, 1), Fraction(1, 1)), (Fraction(3, 1), Fraction(2, 1)))
)");
}

}  // namespace oplus::python
