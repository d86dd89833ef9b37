// Decodes accessors after the glTF 2.0 specification, 3.6.2. Bytes are copied out one component at
// a time, so alignment does not matter.
#include "atlas/gltf/accessor.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace burl {
namespace {

template <typename Value>
double component_as(const unsigned char* bytes, bool normalized) {
    Value value;
    std::memcpy(&value, bytes, sizeof value);
    if constexpr (std::numeric_limits<Value>::is_integer) {
        if (normalized)
            return std::max(double(value) / double(std::numeric_limits<Value>::max()), -1.0);
    }
    return double(value);
}

using Decoder = double (*)(const unsigned char*, bool);

Decoder decoder_for(int component_type) {
    switch (component_type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return component_as<std::int8_t>;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return component_as<std::uint8_t>;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return component_as<std::int16_t>;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return component_as<std::uint16_t>;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return component_as<std::uint32_t>;
        default:
            return component_as<float>;
    }
}

std::size_t bytes_of(int component_type) {
    return static_cast<std::size_t>(
        tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(component_type)));
}

const unsigned char* view_data(const tinygltf::Model& model, int view) {
    const tinygltf::BufferView& v = model.bufferViews[static_cast<std::size_t>(view)];
    return model.buffers[static_cast<std::size_t>(v.buffer)].data.data() + v.byteOffset;
}

/// The memory layout of an accessor's elements; matrix columns start at multiples of four bytes.
struct Layout {
    Decoder decode;
    bool normalized;
    std::size_t components, rows, component_bytes, column_bytes, element_bytes;

    explicit Layout(const tinygltf::Accessor& accessor)
        : decode(decoder_for(accessor.componentType)), normalized(accessor.normalized) {
        components = static_cast<std::size_t>(
            tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
        const bool matrix = accessor.type == TINYGLTF_TYPE_MAT2 ||
                            accessor.type == TINYGLTF_TYPE_MAT3 ||
                            accessor.type == TINYGLTF_TYPE_MAT4;
        rows = !matrix ? components : components == 4 ? 2 : components == 9 ? 3 : 4;
        component_bytes = bytes_of(accessor.componentType);
        column_bytes = matrix ? (rows * component_bytes + 3) / 4 * 4 : rows * component_bytes;
        element_bytes = components / rows * column_bytes;
    }

    void read(const unsigned char* element, double* values) const {
        for (std::size_t i = 0; i < components; ++i)
            values[i] =
                decode(element + i / rows * column_bytes + i % rows * component_bytes, normalized);
    }
};

void apply_sparse(const tinygltf::Model& model, const tinygltf::Accessor& accessor,
                  const Layout& layout, AccessorValues& result) {
    const auto& sparse = accessor.sparse;
    const Decoder decode = decoder_for(sparse.indices.componentType);
    const std::size_t index_bytes = bytes_of(sparse.indices.componentType);
    const unsigned char* index = view_data(model, sparse.indices.bufferView) +
                                 static_cast<std::size_t>(sparse.indices.byteOffset);
    const unsigned char* value = view_data(model, sparse.values.bufferView) +
                                 static_cast<std::size_t>(sparse.values.byteOffset);
    for (int i = 0; i < sparse.count; ++i) {
        const auto element = static_cast<std::size_t>(decode(index, false));
        layout.read(value, &result.values[element * result.components]);
        index += index_bytes;
        value += layout.element_bytes;
    }
}

}  // namespace

bool sparse_indices_in_range(const tinygltf::Model& model, int accessor_index) {
    const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(accessor_index)];
    const auto& sparse = accessor.sparse;
    if (!sparse.isSparse) return true;
    const Decoder decode = decoder_for(sparse.indices.componentType);
    const std::size_t index_bytes = bytes_of(sparse.indices.componentType);
    const unsigned char* index = view_data(model, sparse.indices.bufferView) +
                                 static_cast<std::size_t>(sparse.indices.byteOffset);
    for (int i = 0; i < sparse.count; ++i, index += index_bytes)
        if (decode(index, false) >= static_cast<double>(accessor.count)) return false;
    return true;
}

AccessorValues read_accessor(const tinygltf::Model& model, int accessor_index) {
    const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(accessor_index)];
    const Layout layout(accessor);
    AccessorValues result{layout.components, {}};
    result.values.resize(accessor.count * layout.components, 0.0);
    if (accessor.bufferView >= 0) {
        const std::size_t view_stride =
            model.bufferViews[static_cast<std::size_t>(accessor.bufferView)].byteStride;
        const std::size_t stride = view_stride == 0 ? layout.element_bytes : view_stride;
        const unsigned char* element = view_data(model, accessor.bufferView) + accessor.byteOffset;
        for (std::size_t i = 0; i < accessor.count; ++i)
            layout.read(element + i * stride, &result.values[i * layout.components]);
    }
    if (accessor.sparse.isSparse) apply_sparse(model, accessor, layout, result);
    return result;
}

std::vector<std::uint32_t> read_indices(const tinygltf::Model& model, int accessor) {
    const AccessorValues numbers = read_accessor(model, accessor);
    std::vector<std::uint32_t> indices(numbers.count());
    for (std::size_t i = 0; i < indices.size(); ++i)
        indices[i] = static_cast<std::uint32_t>(*numbers[i]);
    return indices;
}

}  // namespace burl
