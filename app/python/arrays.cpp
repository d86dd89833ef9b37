#include "app/python/arrays.h"

#include <limits>

namespace burl::python {

namespace {

/// A shape as Python writes it; -1 is "n".
template <class Sizes>
std::string text_of(const Sizes& sizes) {
    std::string text = "(";
    std::size_t count = 0;
    for (const py::ssize_t size : sizes) {
        if (count++ > 0) text += ", ";
        text += size < 0 ? "n" : std::to_string(size);
    }
    return text + (count == 1 ? ",)" : ")");
}

/// The object as an array of numbers whose kind is one of `kinds`. Throws TypeError.
py::array array_of(const char* name, const py::object& object, const std::string& kinds,
                   const char* wanted) {
    py::array array = py::array::ensure(object);
    if (!array) {
        PyErr_Clear();
        throw py::type_error(std::string(name) + ": must be an array of " + wanted);
    }
    if (kinds.find(array.dtype().kind()) == std::string::npos)
        throw py::type_error(std::string(name) + ": has " + std::string(py::str(array.dtype())) +
                             ", and must have " + wanted);
    return array;
}

/// Throws ValueError unless the array has the shape.
void check_shape(const char* name, const py::array& array,
                 std::initializer_list<py::ssize_t> shape) {
    bool right = array.ndim() == py::ssize_t(shape.size());
    py::ssize_t axis = 0;
    for (const py::ssize_t size : shape) {
        if (!right) break;
        right = size < 0 || array.shape(axis) == size;
        ++axis;
    }
    if (right) return;
    const std::vector<py::ssize_t> found(array.shape(), array.shape() + array.ndim());
    throw py::value_error(std::string(name) + ": has shape " + text_of(found) +
                          ", and must have shape " + text_of(shape));
}

}  // namespace

Doubles doubles_of(const char* name, const py::object& object,
                   std::initializer_list<py::ssize_t> shape) {
    const py::array array = array_of(name, object, "fiub", "real numbers");
    check_shape(name, array, shape);
    return Doubles(array);
}

Indices indices_of(const char* name, const py::object& object,
                   std::initializer_list<py::ssize_t> shape) {
    const py::array array = array_of(name, object, "iu", "whole numbers");
    check_shape(name, array, shape);
    if (array.dtype().kind() != 'u' || array.dtype().itemsize() > 4) {
        const py::array_t<std::int64_t, py::array::c_style | py::array::forcecast> wide(array);
        for (const std::int64_t number : span_of(wide))
            if (number < 0 || number > std::numeric_limits<std::uint32_t>::max())
                throw py::value_error(std::string(name) + ": has " + std::to_string(number) +
                                      ", which is no number of a point");
    }
    return Indices(array);
}

py::array view_of(const ImageView& image, const py::object& owner) {
    std::vector<py::ssize_t> shape{py::ssize_t(image.height), py::ssize_t(image.width)};
    if (image.components > 1) shape.push_back(py::ssize_t(image.components));
    const std::size_t count = image.width * image.height * image.components;
    const auto view = [&]<class Number>(const Number* numbers) {
        return view_of(std::span(numbers, count), shape, owner);
    };
    switch (image.type) {
        case ComponentType::u8:
            return view(static_cast<const std::uint8_t*>(image.data));
        case ComponentType::u16:
            return view(static_cast<const std::uint16_t*>(image.data));
        default:
            return view(static_cast<const float*>(image.data));
    }
}

}  // namespace burl::python
