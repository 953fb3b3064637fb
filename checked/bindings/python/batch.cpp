// SPDX-License-Identifier: MIT
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "checked/bindings/python/arrays.hpp"
#include "checked/bindings/python/numbers.hpp"
#include "checked/bindings/python/operation.hpp"
#include "checked/bindings/python/shapes.hpp"
#include "checked/bindings/python/workers.hpp"
#include "checked/oplus/internal/named_operations.hpp"

namespace oplus::python {

namespace {

/// A message without what it starts with: "region: it is empty" is about a region of many.
std::string without_place(const InvalidInput& error) {
  const std::string text = error.what();
  const std::size_t colon = text.find(": ");
  return error.where().line == 0 && colon != std::string::npos ? text.substr(colon + 2) : text;
}

/// Why something is not the region it should be.
struct Wrong {
  py::object error() const { return type()(message); }

  [[noreturn]] void raise() const {
    PyErr_SetString(type().ptr(), message.c_str());
    throw py::error_already_set();
  }

  py::object type() const {
    return is_type_error ? py::reinterpret_borrow<py::object>(PyExc_TypeError)
                         : py::module_::import("oplus").attr("InvalidInput");
  }

  std::string message;
  bool is_type_error = false;
};

/// The regions that stand on one side of the pairs.
class Side {
 public:
  explicit Side(py::handle value) {
    if (is_arrays(value)) {
      arrays_.emplace(value);
      size_ = arrays_->size();
    } else if (is_single(value)) {
      regions_.emplace_back(region_of(value));
    } else {
      for (const py::handle one : value) {
        try {
          regions_.emplace_back(region_of(one));
        } catch (const InvalidInput& error) {
          regions_.emplace_back(error);
        } catch (const py::type_error& error) {
          regions_.emplace_back(error);
        }
      }
      size_ = regions_.size();
    }
  }

  /// Returns how many there are, nothing for one that is in all pairs.
  std::optional<std::size_t> size() const { return size_; }

  /// Returns the region of a pair. Needs no lock. Throws InvalidInput and py::type_error.
  PreparedRegion operator[](std::size_t i) const {
    if (arrays_) return ValidRegion((*arrays_)[i]);
    const auto& region = regions_[size_ ? i : 0];
    if (const auto* error = std::get_if<InvalidInput>(&region)) throw *error;
    if (const auto* error = std::get_if<py::type_error>(&region)) throw *error;
    return std::get<PreparedRegion>(region);
  }

 private:
  std::optional<std::size_t> size_;
  std::optional<RegionArrays> arrays_;
  std::vector<std::variant<PreparedRegion, InvalidInput, py::type_error>> regions_;
};

std::size_t number_of_pairs(const Side& p, const Side& q) {
  if (p.size() && q.size() && *p.size() != *q.size())
    throw std::invalid_argument("p of length " + std::to_string(*p.size()) + " and q of length " +
                                std::to_string(*q.size()) + "; expected as many");
  return p.size() ? *p.size() : q.size().value_or(1);
}

using Compute = std::function<ValidSet(const PreparedRegion& p, const PreparedRegion& q,
                                       const SumOptions& options)>;

Compute compute_of(const std::string& name) {
  if (name == "sum" || name == "minkowski_sum")
    return [](const PreparedRegion& p, const PreparedRegion& q, const SumOptions& options) {
      return minkowski_sum(p, q, options);
    };
  std::string expected = "sum";
  const std::vector<NamedOperation> all = named_operations();
  for (const NamedOperation& operation : all) {
    if (operation.name == name)
      return [name](const PreparedRegion& p, const PreparedRegion& q, const SumOptions& options) {
        return value_of(name, p.region(), q.region(), options);
      };
    expected += (&operation == &all.back() ? " or " : ", ") + operation.name;
  }
  throw std::invalid_argument("operation " + name + "; expected " + expected);
}

py::list batch(const std::string& name, py::handle p_value, py::handle q_value,
               const std::string& boundary, long long threads, const std::string& errors) {
  const Compute compute = compute_of(name);
  const SumOptions options{.boundary = boundary_of(boundary)};
  if (options.boundary == Boundary::open && name != "sum" && name != "minkowski_sum")
    throw std::invalid_argument("boundary open of " + name + "; expected it of sum only");
  if (errors != "raise" && errors != "return")
    throw std::invalid_argument("errors " + errors + "; expected raise or return");
  const Side p(p_value), q(q_value);
  const std::size_t n = number_of_pairs(p, q);
  std::vector<ValidSet> sums(n);
  std::vector<std::optional<Wrong>> wrong(n);
  for_each_below(n, threads, [&](std::size_t i) {
    char side = 'p';
    const auto place = [&] {
      return "pair " + std::to_string(i) + (side == ' ' ? "" : std::string(", ") + side) + ": ";
    };
    try {
      const PreparedRegion of_p = p[i];
      side = 'q';
      const PreparedRegion of_q = q[i];
      side = ' ';
      sums[i] = compute(of_p, of_q, options);
      sums[i].region();  // computed when first asked for, so here
    } catch (const InvalidInput& error) {
      wrong[i] = {place() + without_place(error)};
    } catch (const py::type_error& error) {
      wrong[i] = {place() + error.what(), true};
    }
  });
  py::list results(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (!wrong[i]) {
      results[i] = py::cast(std::move(sums[i]));
    } else if (errors == "return") {
      results[i] = wrong[i]->error();
    } else {
      wrong[i]->raise();
    }
  }
  return results;
}

py::list from_arrays(py::handle value, long long threads) {
  if (!is_arrays(value))
    throw py::type_error("regions of type " + type_of(value) + ": expected oplus.Arrays");
  const RegionArrays arrays(value);
  std::vector<ValidRegion> regions(arrays.size());
  std::vector<std::optional<Wrong>> wrong(arrays.size());
  for_each_below(arrays.size(), threads, [&](std::size_t i) {
    try {
      regions[i] = ValidRegion(arrays[i]);
    } catch (const InvalidInput& error) {
      wrong[i] = {"region " + std::to_string(i) + ": " + without_place(error)};
    }
  });
  py::list result(regions.size());
  for (std::size_t i = 0; i < regions.size(); ++i) {
    if (wrong[i]) wrong[i]->raise();
    result[i] = py::cast(PreparedRegion(std::move(regions[i])));
  }
  return result;
}

py::object to_arrays(py::handle value) {
  NewArrays arrays;
  const auto add = [&](py::handle one) { arrays.add(region_of(one).region()); };
  if (is_single(value))
    add(value);
  else
    for (const py::handle one : value) add(one);
  return std::move(arrays).take();
}

}  // namespace

Boundary boundary_of(const std::string& name) {
  if (name == "closed") return Boundary::closed;
  if (name == "open") return Boundary::open;
  throw std::invalid_argument("boundary " + name + "; expected closed or open");
}

void define_batch(py::module_& m) {
  m.def("batch", batch, py::arg("operation"), py::arg("p"), py::arg("q"), py::kw_only(),
        py::arg("boundary") = "closed", py::arg("threads") = 0, py::arg("errors") = "raise",
        R"(batch(operation, p, q, *, boundary='closed', threads=0, errors='raise')
--

Returns the list of operation(p[i], q[i]), computed on all cores, or on that many threads.

operation: 'sum' (or 'minkowski_sum'), 'nfp', 'ifp', 'erode', 'open' or 'close'. p, q: Arrays, or lists of
whatever Region takes, as long as each other; or one region for all pairs (not as a list).
Regions only: line strings and points are summands of the function minkowski_sum.
boundary='open' is for 'sum' only. An invalid region raises InvalidInput, another type
than Region takes TypeError, which name the first such pair; with errors='return' the exceptions
are in the list and the other pairs are computed.

>>> bin = oplus.Region([[0, 0], [9, 0], [9, 9], [0, 9]])
>>> parts = [[[0, 0], [w, 0], [w, 1], [0, 1]] for w in (3, 9, 10)]
>>> for place in oplus.batch('ifp', bin, parts): print(place)
POLYGON ((0 0, 6 0, 6 8, 0 8, 0 0))
GEOMETRYCOLLECTION (LINESTRING (0 0, 0 8))
POLYGON EMPTY
)");
  m.def("from_arrays", from_arrays, py::arg("arrays"), py::kw_only(), py::arg("threads") = 0,
        R"(from_arrays(arrays, *, threads=0)
--

Returns the list of a Region for each region of Arrays, coordinates exactly. Checked on all cores,
or on that many threads; coordinates of type float64 and int64 are not copied before. Raises
InvalidInput where arrays don't fit together or a region is invalid.

>>> import numpy
>>> points = numpy.array([[0, 0], [4, 0], [4, 4], [0, 4], [1, 1], [2, 1], [1, 2]])
>>> [ring] = oplus.from_arrays(oplus.Arrays(points, rings=[0, 4, 7], polygons=[0, 2]))
>>> print(ring)
POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 1, 1 1))
)");
  m.def("to_arrays", to_arrays, py::arg("regions"),
        R"(to_arrays(regions)
--

Returns Arrays of one or many regions or results, each coordinate the nearest double. Rings don't
repeat their first point. Dangling edges and isolated vertices of results are left out.

>>> arrays = oplus.to_arrays(oplus.Region([[0, 0], ['1/3', 0], [0, 1]]))
>>> arrays.coordinates.tolist(), arrays.rings.tolist()
([[0.0, 0.0], [0.3333333333333333, 0.0], [0.0, 1.0]], [0, 3])
)");
}

}  // namespace oplus::python
