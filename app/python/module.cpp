// The module burl._burl: the library's values and functions in Python. Their types and texts for
// people are in __init__.pyi.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "app/python/arrays.h"
#include "burl/bake.h"
#include "burl/error.h"
#include "burl/evaluate.h"
#include "burl/mesh.h"
#include "burl/metrics.h"
#include "burl/progress.h"
#include "burl/recipe.h"
#include "burl/version.h"

namespace burl::python {

namespace {

/// The word for a kind of error.
const char* word_of(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::usage:
            return "usage";
        case ErrorKind::io:
            return "io";
        case ErrorKind::invalid_file:
            return "invalid_file";
        case ErrorKind::unsupported:
            return "unsupported";
        case ErrorKind::stopped:
            return "stopped";
        default:
            return "runtime";
    }
}

/// Returns what `work` returns; meanwhile other threads of Python run.
template <class Work>
auto released(Work&& work) {
    const py::gil_scoped_release release;
    return work();
}

/// A callback that tells Python's signals, such as Ctrl-C, and then calls `progress`, if any.
Progress progress_of(const py::object& progress) {
    return [&progress](const ProgressState& state) {
        const py::gil_scoped_acquire acquire;
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        if (progress.is_none()) return true;
        const py::object answer = progress(py::module_::import("burl").attr("ProgressState")(
            state.stage, state.share, state.texels_per_second, state.seconds_left));
        return !answer.is(py::bool_(false));
    };
}

Mesh read_asked(const std::string& path, const MeshReading& reading) {
    return released([&] { return Mesh::read(path, reading); });
}

/// The text of a path: a str, or what os.PathLike stands for. Throws TypeError, with what `wanted`
/// says the argument `name` may be, for anything else.
std::string path_of(const std::string& name, const py::object& path, const std::string& wanted) {
    if (!py::isinstance<py::str>(path) && !py::hasattr(path, "__fspath__")) {
        const auto type = py::str(py::type::of(path).attr("__name__")).cast<std::string>();
        throw py::type_error(name + ": is of type " + type + ", and must be " + wanted);
    }
    return py::module_::import("os").attr("fsdecode")(path).cast<std::string>();
}

/// A mesh, or that of a file's path, which Ctrl-C stops reading.
Mesh mesh_of(const py::object& mesh) {
    if (py::isinstance<Mesh>(mesh)) return mesh.cast<Mesh>();
    const py::none none;
    return read_asked(path_of("mesh", mesh, "a path, a sample or a burl.Mesh"),
                      {.progress = progress_of(none)});
}

Recipe recipe_of(const py::object& recipe) {
    if (py::isinstance<Recipe>(recipe)) return recipe.cast<Recipe>();
    return Recipe::load(path_of("recipe", recipe, "a name, a path or a burl.Recipe"));
}

Mesh mesh_of_arrays(const py::object& positions, const py::object& triangles, const py::object& uvs,
                    const std::string& name) {
    const Doubles points = doubles_of("positions", positions, {-1, 3});
    const Indices corners = indices_of("triangles", triangles, {-1, 3});
    Doubles coordinates;
    if (!uvs.is_none()) coordinates = doubles_of("uvs", uvs, {corners.shape(0), 3, 2});
    const std::span<const double> own =
        uvs.is_none() ? std::span<const double>() : span_of(coordinates);
    return released([&] { return Mesh(span_of(points), span_of(corners), own, name); });
}

Baked bake_asked(const py::object& mesh, const py::object& recipe, std::uint32_t size,
                 const std::string& atlas, int depth, int levels, const std::string& packing,
                 const std::vector<std::string>& masks, bool normals, double crease, int threads,
                 const py::object& progress) {
    const Mesh baked_mesh = mesh_of(mesh);
    const Recipe baked_recipe = recipe_of(recipe);
    const BakeOptions options{size,  atlas,   depth,  levels,  packing,
                              masks, normals, crease, threads, progress_of(progress)};
    return released([&] { return bake(baked_mesh, baked_recipe, options); });
}

py::object evaluate_asked(const py::object& recipe, const py::object& points,
                          const std::string& channel, const py::object& mesh,
                          const py::object& progress) {
    const Doubles places = doubles_of("points", points, {-1, 3});
    const Recipe asked = recipe_of(recipe);
    std::optional<Mesh> shape;
    if (!mesh.is_none()) shape = mesh_of(mesh);
    auto* const result = new Evaluated(released([&] {
        return evaluate(asked, span_of(places),
                        {channel, shape ? &*shape : nullptr, progress_of(progress)});
    }));
    const py::capsule owner(result, [](void* held) { delete static_cast<Evaluated*>(held); });
    const py::ssize_t count = places.shape(0);
    const auto view = [&](const std::vector<double>& numbers, std::vector<py::ssize_t> shape_of) {
        return view_of(std::span<const double>(numbers), std::move(shape_of), owner);
    };
    return py::module_::import("burl").attr("Evaluated")(view(result->values, {count}),
                                                         view(result->gradients, {count, 3}),
                                                         view(result->colors, {count, 3}));
}

py::object metrics_asked(const py::object& mesh, const py::object& recipe, const std::string& atlas,
                         std::uint32_t size, bool own_uvs, bool lookups,
                         const py::object& progress) {
    const Mesh measured = mesh_of(mesh);
    const Recipe asked = recipe_of(recipe);
    const std::string json = released([&] {
        return metrics(measured, asked, {atlas, size, own_uvs, lookups, progress_of(progress)});
    });
    return py::module_::import("json").attr("loads")(json);
}

/// The shape of so many rows of `columns` numbers.
template <class Number>
std::vector<py::ssize_t> rows_of(std::span<const Number> numbers, py::ssize_t columns) {
    return {py::ssize_t(numbers.size()) / columns, columns};
}

/// The properties that a Mesh and a Baked have in common.
template <class Value>
void add_arrays(py::class_<Value>& type) {
    type.def_property_readonly("positions", [](const py::object& self) {
        const auto numbers = self.cast<const Value&>().positions();
        return view_of(numbers, rows_of(numbers, 3), self);
    });
    type.def_property_readonly("triangles", [](const py::object& self) {
        const auto numbers = self.cast<const Value&>().triangles();
        return view_of(numbers, rows_of(numbers, 3), self);
    });
    type.def_property_readonly("uvs", [](const py::object& self) -> py::object {
        const auto numbers = self.cast<const Value&>().uvs();
        if (numbers.empty()) return py::none();
        return view_of(numbers, {py::ssize_t(numbers.size()) / 6, 3, 2}, self);
    });
    type.def_property_readonly("notes", &Value::notes);
}

void add_mesh(py::module_& module) {
    py::class_<Mesh> mesh(module, "Mesh");
    mesh.def(py::init(&mesh_of_arrays), py::arg("positions"), py::arg("triangles"),
             py::arg("uvs") = py::none(), py::arg("name") = "mesh");
    mesh.def_static(
        "read",
        [](const py::object& path, double weld, const std::string& up, double scale,
           std::uint32_t uv_set, const py::object& progress) {
            return read_asked(path_of("path", path, "a path or a sample"),
                              {weld, up, scale, uv_set, progress_of(progress)});
        },
        py::arg("path"), py::kw_only(), py::arg("weld") = 0.0, py::arg("up") = "y",
        py::arg("scale") = 1.0, py::arg("uv_set") = 0, py::arg("progress") = py::none());
    mesh.def_property_readonly("name", &Mesh::name);
    add_arrays(mesh);
    mesh.def("__repr__", [](const Mesh& self) {
        return "<burl.Mesh " + self.name() + ": " + std::to_string(self.positions().size() / 3) +
               " points, " + std::to_string(self.triangles().size() / 3) + " triangles>";
    });
}

void add_recipe(py::module_& module) {
    py::class_<Recipe> recipe(module, "Recipe");
    recipe.def_static(
        "load",
        [](const py::object& path) {
            return Recipe::load(path_of("path_or_preset", path, "a name or a path"));
        },
        py::arg("path_or_preset"));
    recipe.def_static("parse", &Recipe::parse, py::arg("json"), py::arg("origin") = "recipe");
    recipe.def_static("names", &Recipe::names);
    recipe.def_property_readonly("name", &Recipe::name);
    recipe.def_property_readonly("notes", &Recipe::notes);
    recipe.def("to_json", &Recipe::to_json);
    recipe.def(
        "set",
        [](const Recipe& self, const std::string& path, const std::string& value) {
            return self.set(path, value);
        },
        py::arg("path"), py::arg("value"));
    recipe.def(
        "set",
        [](const Recipe& self, const std::string& path, double value) {
            return self.set(path, value);
        },
        py::arg("path"), py::arg("value"));
    recipe.def("at", &Recipe::at, py::arg("seconds"));
    recipe.def("__repr__", [](const Recipe& self) { return "<burl.Recipe " + self.name() + ">"; });
}

void add_baked(py::module_& module) {
    py::class_<Baked> baked(module, "Baked");
    add_arrays(baked);
    baked.def_property_readonly("names", &Baked::image_names);
    baked.def_property_readonly("factors", [](const Baked& self) {
        py::dict factors;
        for (const auto& [name, number] : self.factors()) factors[py::str(name)] = number;
        return factors;
    });
    baked.def("level_count", &Baked::level_count, py::arg("name"));
    const auto image = [](const py::object& self, const std::string& name, std::size_t level) {
        return view_of(self.cast<const Baked&>().image(name, level), self);
    };
    baked.def("image", image, py::arg("name"), py::arg("level") = 0);
    baked.def("__getitem__", [image](const py::object& self, const std::string& name) {
        return image(self, name, 0);
    });
    baked.def(
        "is_srgb", [](const Baked& self, const std::string& name) { return self.image(name).srgb; },
        py::arg("name"));
    baked.def(
        "write",
        [](const Baked& self, const py::object& path) {
            const std::string file = path_of("path", path, "a path");
            return released([&] { return write(self, file); });
        },
        py::arg("path"));
    baked.def("__repr__", [](const Baked& self) {
        std::string text = "<burl.Baked";
        for (const std::string& name : self.image_names()) text += ' ' + name;
        return text + ">";
    });
}

/// Makes the library's Error the Python exception `type`, which has a `kind`.
void translate(std::exception_ptr thrown) {
    try {
        if (thrown) std::rethrow_exception(std::move(thrown));
    } catch (const Error& error) {
        const py::object type = py::module_::import("burl").attr("Error");
        const py::object value = type(error.what(), word_of(error.kind()));
        PyErr_SetObject(type.ptr(), value.ptr());
    }
}

}  // namespace

PYBIND11_MODULE(_burl, module) {
    py::register_exception_translator(&translate);
    add_mesh(module);
    add_recipe(module);
    add_baked(module);
    module.def("bake", &bake_asked, py::arg("mesh"), py::arg("recipe"), py::kw_only(),
               py::arg("size") = 0, py::arg("atlas") = "", py::arg("depth") = 8,
               py::arg("levels") = 0, py::arg("packing") = "gltf",
               py::arg("masks") = std::vector<std::string>(), py::arg("normals") = true,
               py::arg("crease") = 40.0, py::arg("threads") = 0, py::arg("progress") = py::none());
    module.def("evaluate", &evaluate_asked, py::arg("recipe"), py::arg("points"), py::kw_only(),
               py::arg("channel") = "", py::arg("mesh") = py::none(),
               py::arg("progress") = py::none());
    module.def("metrics", &metrics_asked, py::arg("mesh"), py::arg("recipe"), py::kw_only(),
               py::arg("atlas") = "", py::arg("size") = 0, py::arg("own_uvs") = false,
               py::arg("lookups") = false, py::arg("progress") = py::none());
    module.def("version", &version);
    module.def("simd", &simd);
}

}  // namespace burl::python
