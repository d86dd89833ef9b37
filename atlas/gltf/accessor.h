#pragma once
// Values out of a glTF's accessors, whatever their component type, stride or sparse parts. Only for
// models from load_gltf(), which has checked every bound.
#include <cstdint>
#include <vector>

namespace tinygltf {
class Model;
}

namespace burl {

struct AccessorValues {
    std::size_t components = 0;  ///< per element: 1 to 16
    std::vector<double> values;  ///< element after element; normalized integers in [0,1] or [-1,1]

    std::size_t count() const { return components == 0 ? 0 : values.size() / components; }
    const double* operator[](std::size_t i) const { return &values[components * i]; }
};

/// All elements of an accessor as doubles, sparse replacements applied.
AccessorValues read_accessor(const tinygltf::Model& model, int accessor);

/// Does every index of the accessor's sparse part, if it has one, lie below its count?
bool sparse_indices_in_range(const tinygltf::Model& model, int accessor);

/// A scalar integer accessor (vertex indices) as it is.
std::vector<std::uint32_t> read_indices(const tinygltf::Model& model, int accessor);

}  // namespace burl
