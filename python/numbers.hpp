// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <oplus/oplus.hpp>

/// @file
/// Numbers and points, from and to Python's.
namespace oplus::python {

namespace py = pybind11;

/// Whether it is an int, a float, a Fraction, text, or another number that says which fraction it is.
bool is_number(py::handle value);

/// Returns the number, exactly. Throws InvalidInput where it is infinite or not a number, py::type_error
/// where it is something else.
Number number_of(py::handle value);

/// Returns the point of a list, a tuple or an array of two numbers; what follows y is left out. Throws as
/// number_of does.
Point point_of(py::handle value);

/// Returns a Fraction.
py::object to_python(const Rational& value);

/// Returns a pair of Fractions.
py::object to_python(const Point& point);

}  // namespace oplus::python
