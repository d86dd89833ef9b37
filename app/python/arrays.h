#pragma once
// Arrays of numpy: those that come in, whose shapes are checked, and those that go out, which are
// views of what the library holds and keep it alive.
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "burl/bake.h"

namespace burl::python {

namespace py = pybind11;

/// An array of float64, rows one after the other.
using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
/// An array of whole numbers, rows one after the other.
using Indices = py::array_t<std::uint32_t, py::array::c_style | py::array::forcecast>;

/// The array as float64 of a shape such as {-1, 3}, where -1 is any length; not copied if it is
/// that already. Throws ValueError that names both shapes, and TypeError for what is no array of
/// real numbers.
Doubles doubles_of(const char* name, const py::object& array,
                   std::initializer_list<py::ssize_t> shape);
/// The array as numbers of points, in the same way. Throws ValueError for negative numbers and
/// those beyond 32 bits, and TypeError for what has no whole numbers.
Indices indices_of(const char* name, const py::object& array,
                   std::initializer_list<py::ssize_t> shape);

/// The numbers of an array.
template <class Array>
auto span_of(const Array& array) {
    return std::span(array.data(), std::size_t(array.size()));
}

/// A view, which cannot be written to, of numbers that `owner` keeps alive.
template <class Number>
py::array view_of(std::span<const Number> numbers, std::vector<py::ssize_t> shape,
                  const py::object& owner) {
    py::array view(py::dtype::of<Number>(), std::move(shape), {}, numbers.data(), owner);
    view.attr("flags").attr("writeable") = false;
    return view;
}

/// A view of an image's pixels, of shape (rows, columns) for numbers and (rows, columns,
/// components) for colours.
py::array view_of(const ImageView& image, const py::object& owner);

}  // namespace burl::python
