#pragma once
// Reads a glTF's accessors, whatever their component type, stride or sparse parts. The model must
// come from load_gltf(), which has checked every bound.
#include <cstdint>
#include <vector>

namespace tinygltf {
class Model;
}

namespace burl {

/// The elements of an accessor, each of one or more components.
struct AccessorValues {
    std::size_t components = 0;  ///< components of an element: 1 to 16
    std::vector<double> values;  ///< components; normalized integers in [0,1] or [-1,1]

    std::size_t count() const { return components == 0 ? 0 : values.size() / components; }
    const double* operator[](std::size_t i) const { return &values[components * i]; }
};

/// All elements of an accessor as doubles, sparse replacements applied.
AccessorValues read_accessor(const tinygltf::Model& model, int accessor);

/// Whether every index of the accessor's sparse part lies below the accessor's count; true without
/// a sparse part.
bool sparse_indices_in_range(const tinygltf::Model& model, int accessor);

/// The elements of a scalar integer accessor, such as vertex indices.
std::vector<std::uint32_t> read_indices(const tinygltf::Model& model, int accessor);

}  // namespace burl
