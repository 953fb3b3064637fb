// SPDX-License-Identifier: MIT
#include "checked/bindings/python/arrays.hpp"

#include <memory>
#include <numeric>
#include <string>
#include <utility>

namespace oplus::python {

namespace {

py::handle& arrays_type() {
  static py::handle type;
  return type;
}

std::vector<std::size_t> each_alone(std::size_t n) {
  std::vector<std::size_t> offsets(n + 1);
  std::iota(offsets.begin(), offsets.end(), std::size_t{0});
  return offsets;
}

/// Returns offsets into `size` things: from 0 to `size`, never smaller than the one before.
std::vector<std::size_t> offsets_of(py::handle value, const char* name, std::size_t size) {
  if (value.is_none()) return each_alone(size);
  const auto fail = [&](const std::string& wrong) {
    throw InvalidInput({name, 0, 0}, wrong, "offsets from 0 to " + std::to_string(size));
  };
  const auto any = array_of(value, name, "offsets");
  if (any.ndim() != 1 || any.size() == 0) fail("not an array of one dimension with an offset");
  if (any.dtype().kind() != 'i' && any.dtype().kind() != 'u') fail("not integers");
  const auto array = array_of<py::array_t<std::int64_t, py::array::forcecast>>(any, name, "int64");
  const auto offsets = array.unchecked<1>();
  std::vector<std::size_t> result;
  result.reserve(static_cast<std::size_t>(offsets.shape(0)));
  std::int64_t before = 0;
  for (py::ssize_t i = 0; i < offsets.shape(0); ++i) {
    const std::int64_t offset = offsets(i);
    const std::string which = "offset " + std::to_string(i) + " is " + std::to_string(offset);
    if (i == 0 && offset != 0) fail(which);
    if (offset < before) fail(which + " after " + std::to_string(before));
    before = offset;
    result.push_back(static_cast<std::size_t>(offset));
  }
  if (result.back() != size) fail("the last offset is " + std::to_string(before));
  return result;
}

/// An array over what it takes, without a copy.
template <typename T>
py::array_t<T> array_over(std::vector<T> values, std::vector<py::ssize_t> shape) {
  auto kept = std::make_unique<std::vector<T>>(std::move(values));
  const T* const data = kept->data();
  const py::capsule owner(kept.release(), [](void* p) { delete static_cast<std::vector<T>*>(p); });
  return py::array_t<T>(std::move(shape), data, owner);
}

py::array_t<std::int64_t> offset_array(std::vector<std::int64_t> offsets) {
  const auto n = static_cast<py::ssize_t>(offsets.size());
  return array_over(std::move(offsets), {n});
}

}  // namespace

void prepare_arrays() {
  // So that pybind11 imports numpy now, and not when it is first used, under the lock of a static variable,
  // where two threads would wait for each other.
  py::dtype::of<double>();
  arrays_type() = py::module_::import("oplus._arrays").attr("Arrays").cast<py::object>().release();
}

bool is_arrays(py::handle value) { return py::isinstance(value, arrays_type()); }

RegionArrays::RegionArrays(const py::array& coordinates, py::handle rings, py::handle polygons,
                           py::handle regions)
    : points_(coordinates),
      rings_(offsets_of(rings, "rings", points_.size())),
      polygons_(offsets_of(polygons, "polygons", rings_.size() - 1)),
      regions_(offsets_of(regions, "regions", polygons_.size() - 1)) {}

RegionArrays::RegionArrays(py::handle arrays)
    : RegionArrays(array_of(arrays.attr("coordinates"), "coordinates", "shape (n, 2)"),
                   arrays.attr("rings"), arrays.attr("polygons"), arrays.attr("regions")) {}

Region RegionArrays::operator[](std::size_t i) const {
  Region region;
  for (std::size_t polygon = regions_[i]; polygon < regions_[i + 1]; ++polygon) {
    const std::size_t outer = polygons_[polygon], end = polygons_[polygon + 1];
    if (outer == end || rings_[outer] == rings_[outer + 1])
      throw InvalidInput({"region", 0, 0}, "a polygon without an outer ring",
                         "at least 3 vertices");
    Component& component = region.components.emplace_back();
    component.outer = points_.chain(rings_[outer], rings_[outer + 1]);
    for (std::size_t hole = outer + 1; hole < end; ++hole)
      component.holes.push_back(points_.chain(rings_[hole], rings_[hole + 1]));
  }
  return region;
}

void NewArrays::add(const ValidRegion& region) {
  if (is_unbounded(region))
    throw InvalidInput({"region", 0, 0}, "it is unbounded", "a bounded region");
  for (const Component& component : region.components()) {
    add(component.outer);
    for (const Chain& hole : component.holes) add(hole);
    polygons_.push_back(static_cast<std::int64_t>(rings_.size() - 1));
  }
  regions_.push_back(static_cast<std::int64_t>(polygons_.size() - 1));
}

void NewArrays::add(const Chain& chain) {
  for (const Point& p : chain) {
    const auto [x, y] = to_double(p);
    coordinates_.push_back(x);
    coordinates_.push_back(y);
  }
  rings_.push_back(static_cast<std::int64_t>(coordinates_.size() / 2));
}

py::object NewArrays::take() && {
  const auto n = static_cast<py::ssize_t>(coordinates_.size() / 2);
  return arrays_type()(array_over(std::move(coordinates_), {n, 2}), offset_array(std::move(rings_)),
                       offset_array(std::move(polygons_)), offset_array(std::move(regions_)));
}

}  // namespace oplus::python
