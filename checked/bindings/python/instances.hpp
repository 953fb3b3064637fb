// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <oplus/oplus.hpp>
#include <string>
#include <utility>

/// @file
/// Objects of the module's classes, as arguments. All files that have such arguments include it.
namespace oplus::python {

/// Takes no object whose __init__ was not called, which has no value: pybind11 would take memory as it is.
template <typename T>
struct InstanceCaster : pybind11::detail::type_caster_base<T> {
  bool load(pybind11::handle source, bool convert) {
    return this->template load_impl<InstanceCaster>(source, convert);
  }

  void load_value(pybind11::detail::value_and_holder&& instance) {
    if (instance.value_ptr() == nullptr)
      throw pybind11::type_error(std::string("an object of type ") +
                                 Py_TYPE(reinterpret_cast<PyObject*>(instance.inst))->tp_name +
                                 " without a value: expected one whose __init__ was called");
    pybind11::detail::type_caster_base<T>::load_value(std::move(instance));
  }
};

}  // namespace oplus::python

namespace pybind11::detail {

template <>
class type_caster<oplus::PreparedRegion>
    : public oplus::python::InstanceCaster<oplus::PreparedRegion> {};
template <>
class type_caster<oplus::ValidSet> : public oplus::python::InstanceCaster<oplus::ValidSet> {};

}  // namespace pybind11::detail
