// SPDX-License-Identifier: MIT
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "checked/bindings/python/arrays.hpp"
#include "checked/bindings/python/module.hpp"
#include "checked/bindings/python/numbers.hpp"
#include "checked/bindings/python/output.hpp"
#include "checked/bindings/python/shapes.hpp"
#include "checked/bindings/python/workers.hpp"
#include "checked/oplus/internal/named_operations.hpp"

namespace oplus::python {

namespace {

/// What is wrong with one of many.
struct Wrong {
  /// Of a region that is invalid. Its message is without what it starts with: "region: it is empty".
  Wrong(const InvalidInput& error, std::string at, std::size_t i)
      : invalid(error), place(std::move(at)), index(i), message(error.what()) {
    if (error.where().line == 0) message.erase(0, error.where().file.size() + 2);
  }

  /// Of something of another type.
  Wrong(const py::type_error& error, std::string at, std::size_t i)
      : place(std::move(at)), index(i), message(error.what()) {}

  py::object error() const {
    const std::string line = place + ": " + message;
    return invalid ? error_of(*invalid, line, place, py::int_(index))
                   : py::handle(PyExc_TypeError)(line);
  }

  [[noreturn]] void raise() const {
    const py::object raised = error();
    PyErr_SetObject(py::type::of(raised).ptr(), raised.ptr());
    throw py::error_already_set();
  }

  std::optional<InvalidInput> invalid;
  std::string place;
  std::size_t index;
  std::string message;
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
               const std::string& boundary, long long threads, const std::string& errors,
               py::handle progress) {
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
  for_each_below(n, threads, progress, [&](std::size_t i) {
    char side = 'p';
    const auto place = [&] {
      return "pair " + std::to_string(i) + (side == ' ' ? "" : std::string(", ") + side);
    };
    try {
      const PreparedRegion of_p = p[i];
      side = 'q';
      const PreparedRegion of_q = q[i];
      side = ' ';
      sums[i] = compute(of_p, of_q, options);
      sums[i].region();  // computed when first asked for, so here
    } catch (const InvalidInput& error) {
      wrong[i].emplace(error, place(), i);
    } catch (const py::type_error& error) {
      wrong[i].emplace(error, place(), i);
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
  for_each_below(arrays.size(), threads, py::none(), [&](std::size_t i) {
    try {
      regions[i] = ValidRegion(arrays[i]);
    } catch (const InvalidInput& error) {
      wrong[i].emplace(error, "region " + std::to_string(i), i);
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
  m.def("batch", batch);
  m.def("from_arrays", from_arrays);
  m.def("to_arrays", to_arrays);
}

}  // namespace oplus::python
