// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <oplus/oplus.hpp>
#include <string>

/// @file
/// Numbers and points, from and to Python's.
namespace oplus::python {

namespace py = pybind11;

/// Imports what the others use. To be called when the module is made.
void prepare_numbers();

/// Returns the name of its type.
std::string type_of(py::handle value);

/// Whether it is text or bytes.
bool is_text(py::handle value);

/// Returns text in UTF-8, or bytes as they are. Throws InvalidInput for what is not Unicode.
///
/// Requires: is_text(value).
std::string text_of(py::handle value);

/// Whether it is an int, a float, a Fraction, text, or another number that says which fraction it is.
bool is_number(py::handle value);

/// Returns the number, exactly. Throws InvalidInput where it is infinite or not a number, a Python
/// TypeError where it is something else.
Number number_of(py::handle value);

/// Returns the point of a list, a tuple or an array of two numbers; what follows y is left out. Throws as
/// number_of does.
Point point_of(py::handle value);

/// Returns a Fraction.
py::object to_python(const Rational& value);

/// Returns a pair of Fractions.
py::object to_python(const Point& point);

}  // namespace oplus::python
