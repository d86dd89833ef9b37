// Bounds checks of all that a glTF keeps in buffers: no view leaves its buffer and no accessor its
// view.
#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "atlas/gltf/checker.h"

namespace burl {
namespace {

using Json = GltfChecker::Json;

/// Length and stride of a bufferView in bytes; stride 0 means packed elements.
struct View {
    std::uint64_t length = 0;
    std::uint64_t stride = 0;
};

View check_view(const GltfChecker& gltf, const Json& view, const std::string& where) {
    const Json& buffer = gltf.list("buffers")[gltf.index(view, "buffer", "buffers", where)];
    const std::uint64_t held = gltf.whole(buffer, "byteLength", "buffers");
    const std::uint64_t offset = gltf.whole_or(view, "byteOffset", 0, where);
    const View checked{gltf.whole(view, "byteLength", where),
                       gltf.whole_or(view, "byteStride", 0, where)};
    if (offset + checked.length > held)
        gltf.fail(where, fmt::format("ends at byte {}, but its buffer has {}",
                                     offset + checked.length, held));
    if (checked.length == 0) gltf.fail(where, "'byteLength' must be at least 1");
    if (checked.stride > 252) gltf.fail(where, "'byteStride' must be at most 252");
    return checked;
}

View view_of(const GltfChecker& gltf, const Json& user, const std::string& where) {
    const std::size_t i = gltf.index(user, "bufferView", "bufferViews", where);
    return check_view(gltf, gltf.list("bufferViews")[i], place("bufferViews", i));
}

std::uint64_t component_bytes(const GltfChecker& gltf, const Json& user, const std::string& where) {
    switch (gltf.whole(user, "componentType", where)) {
        case 5120:
        case 5121:
            return 1;
        case 5122:
        case 5123:
            return 2;
        case 5125:
        case 5126:
            return 4;
        default:
            gltf.fail(where, "unknown 'componentType'");
    }
}

/// Number of bytes of one element; matrix columns start at multiples of four bytes.
std::uint64_t element_bytes(const GltfChecker& gltf, const Json& accessor,
                            const std::string& where) {
    const std::uint64_t size = component_bytes(gltf, accessor, where);
    const std::string* type = gltf.string_in(accessor, "type", where);
    const auto columns = [&](std::uint64_t n) { return n * ((n * size + 3) / 4 * 4); };
    if (type == nullptr) gltf.fail(where, "'type' is missing");
    if (*type == "SCALAR") return size;
    if (*type == "VEC2") return 2 * size;
    if (*type == "VEC3") return 3 * size;
    if (*type == "VEC4") return 4 * size;
    if (*type == "MAT2") return columns(2);
    if (*type == "MAT3") return columns(3);
    if (*type == "MAT4") return columns(4);
    gltf.fail(where, "unknown 'type'");
}

/// Checks that `count` elements of `bytes` bytes each, from byte `offset` of `view` on, lie inside
/// it.
void check_extent(const GltfChecker& gltf, const View& view, std::uint64_t offset,
                  std::uint64_t count, std::uint64_t bytes, const std::string& where) {
    const std::uint64_t stride = view.stride == 0 ? bytes : view.stride;
    if (stride < bytes) gltf.fail(where, "its elements are longer than the view's 'byteStride'");
    const std::uint64_t end = offset + stride * (count - 1) + bytes;
    if (end > view.length)
        gltf.fail(where, fmt::format("{} elements end at byte {}, but its bufferView has {}", count,
                                     end, view.length));
}

void check_sparse(const GltfChecker& gltf, const Json& sparse, std::uint64_t elements,
                  std::uint64_t bytes, const std::string& where) {
    const std::uint64_t count = gltf.whole(sparse, "count", where);
    if (count == 0 || count > elements) gltf.fail(where, "'count' is out of range");
    const Json* indices = gltf.object_in(sparse, "indices", where);
    const Json* values = gltf.object_in(sparse, "values", where);
    if (indices == nullptr || values == nullptr)
        gltf.fail(where, "'indices' or 'values' is missing");
    if (gltf.whole(*indices, "componentType", where) % 2 == 0)
        gltf.fail(where + ".indices", "'componentType' must be an unsigned type");
    const auto check_one = [&](const Json& part, std::uint64_t size, const std::string& name) {
        View view = view_of(gltf, part, name);
        view.stride = 0;  // sparse data is always packed
        check_extent(gltf, view, gltf.whole_or(part, "byteOffset", 0, name), count, size, name);
    };
    check_one(*indices, component_bytes(gltf, *indices, where), where + ".indices");
    check_one(*values, bytes, where + ".values");
}

void check_accessor(const GltfChecker& gltf, const Json& accessor, const std::string& where) {
    const std::uint64_t count = gltf.whole(accessor, "count", where);
    const std::uint64_t bytes = element_bytes(gltf, accessor, where);
    const std::uint64_t offset = gltf.whole_or(accessor, "byteOffset", 0, where);
    if (count == 0) gltf.fail(where, "'count' must be at least 1");
    if (accessor.contains("bufferView"))
        check_extent(gltf, view_of(gltf, accessor, where), offset, count, bytes, where);
    gltf.numbers(accessor, "min", 0, where);
    gltf.numbers(accessor, "max", 0, where);
    if (const Json* sparse = gltf.object_in(accessor, "sparse", where))
        check_sparse(gltf, *sparse, count, bytes, where + ".sparse");
}

void check_image(const GltfChecker& gltf, const Json& image, const std::string& where) {
    gltf.string_in(image, "uri", where);
    gltf.string_in(image, "mimeType", where);
    gltf.index_or_none(image, "bufferView", "bufferViews", where);
}

}  // namespace

void check_gltf_data(const GltfChecker& gltf) {
    const Json& views = gltf.list("bufferViews");
    for (std::size_t i = 0; i < views.size(); ++i)
        check_view(gltf, views[i], place("bufferViews", i));
    const Json& accessors = gltf.list("accessors");
    for (std::size_t i = 0; i < accessors.size(); ++i)
        check_accessor(gltf, accessors[i], place("accessors", i));
    const Json& images = gltf.list("images");
    for (std::size_t i = 0; i < images.size(); ++i)
        check_image(gltf, images[i], place("images", i));
}

}  // namespace burl
