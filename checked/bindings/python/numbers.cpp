// SPDX-License-Identifier: MIT
#include "checked/bindings/python/numbers.hpp"

#include <cstdlib>
#include <string>

namespace oplus::python {

namespace {

/// Throws py::error_already_set where it is not an integer.
Number integer_of(py::handle value) {
  int overflow = 0;
  const long long small = PyLong_AsLongLongAndOverflow(value.ptr(), &overflow);
  if (overflow == 0) {
    if (PyErr_Occurred() != nullptr) throw py::error_already_set();
    return small;
  }
  // Python limits the number of decimal digits, not that of hexadecimal ones.
  std::string digits =
      py::reinterpret_steal<py::str>(PyNumber_ToBase(value.ptr(), 16)).cast<std::string>();
  digits.erase(digits.find("0x"), 2);
  return Rational(digits, 16);
}

py::object to_python(const mpz_class& value) {
  PyObject* const result = value.fits_slong_p()
                               ? PyLong_FromLong(value.get_si())
                               : PyLong_FromString(value.get_str(16).c_str(), nullptr, 16);
  if (result == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::object>(result);
}

/// Never destroyed: Python may have ended before.
py::handle& fraction_type() {
  static py::handle type;
  return type;
}

/// Never destroyed either.
py::handle& decimal_type() {
  static py::handle type;
  return type;
}

Number ratio_of(const py::tuple& ratio) {
  if (ratio.size() != 2) throw py::type_error("a ratio that is not a pair: expected two integers");
  const Rational numerator = integer_of(ratio[0]).value(),
                 denominator = integer_of(ratio[1]).value();
  if (denominator == 0) throw InvalidInput({"number", 0, 0}, "its denominator is 0", "a number");
  return Rational(numerator / denominator);
}

}  // namespace

void prepare_numbers() {
  fraction_type() = py::module_::import("fractions").attr("Fraction").cast<py::object>().release();
  decimal_type() = py::module_::import("decimal").attr("Decimal").cast<py::object>().release();
}

std::string type_of(py::handle value) { return Py_TYPE(value.ptr())->tp_name; }

bool is_text(py::handle value) {
  return PyUnicode_Check(value.ptr()) || PyBytes_Check(value.ptr());
}

std::string text_of(py::handle value) {
  if (PyBytes_Check(value.ptr())) return value.cast<py::bytes>().cast<std::string>();
  Py_ssize_t size = 0;
  const char* const text = PyUnicode_AsUTF8AndSize(value.ptr(), &size);
  if (text == nullptr) {
    PyErr_Clear();
    throw InvalidInput({"text", 0, 0}, "a surrogate without the other one", "Unicode");
  }
  return {text, static_cast<std::size_t>(size)};
}

bool is_number(py::handle value) {
  PyObject* const object = value.ptr();
  return PyFloat_Check(object) || PyLong_Check(object) || PyUnicode_Check(object) ||
         PyIndex_Check(object) || py::hasattr(value, "as_integer_ratio");
}

Number number_of(py::handle value) {
  PyObject* const object = value.ptr();
  if (PyFloat_Check(object)) return PyFloat_AS_DOUBLE(object);
  if (PyLong_Check(object)) return integer_of(value);
  if (PyUnicode_Check(object)) return text_of(value);
  // Exponents are limited as those of text are: of 10^9 there would be as many digits.
  if (py::isinstance(value, decimal_type()) &&
      std::abs(value.attr("adjusted")().cast<long long>()) > 4096)
    return text_of(py::str(value));
  if (py::hasattr(value, "as_integer_ratio")) {
    try {
      return ratio_of(value.attr("as_integer_ratio")());
    } catch (const py::error_already_set& error) {
      if (!error.matches(PyExc_OverflowError) && !error.matches(PyExc_ValueError)) throw;
      // An infinity, or not a number: oplus has a message for it.
      return static_cast<double>(py::float_(py::reinterpret_borrow<py::object>(value)));
    }
  }
  if (PyIndex_Check(object)) {
    const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(object));
    if (!index) throw py::error_already_set();
    return integer_of(index);
  }
  throw py::type_error("a coordinate of type " + type_of(value) +
                       ": expected an int, a float, a Fraction or text");
}

Point point_of(py::handle value) {
  if (!py::isinstance<py::list>(value) && !py::isinstance<py::tuple>(value) &&
      !(PySequence_Check(value.ptr()) && !PyUnicode_Check(value.ptr()) &&
        !PyBytes_Check(value.ptr())))
    throw py::type_error("a point of type " + type_of(value) + ": expected a pair of numbers");
  const auto items = py::reinterpret_steal<py::object>(
      PySequence_Fast(value.ptr(), "a point: expected a pair of numbers"));
  if (!items) throw py::error_already_set();
  if (const Py_ssize_t size = PySequence_Fast_GET_SIZE(items.ptr()); size != 2)
    throw InvalidInput(
        {"point", 0, 0},
        size < 2 ? "it has less than two coordinates" : "it has more than two coordinates",
        "x and y");
  // Kept: a number may be of a class that changes the list when it is asked for its value.
  const auto item = [&](Py_ssize_t i) {
    return py::reinterpret_borrow<py::object>(PySequence_Fast_GET_ITEM(items.ptr(), i));
  };
  const py::object x = item(0), y = item(1);
  return {number_of(x).value(), number_of(y).value()};
}

py::object to_python(const Rational& value) {
  return value.get_den() == 1
             ? fraction_type()(to_python(value.get_num()))
             : fraction_type()(to_python(value.get_num()), to_python(value.get_den()));
}

py::object to_python(const Point& point) {
  return py::make_tuple(to_python(point.x), to_python(point.y));
}

}  // namespace oplus::python
