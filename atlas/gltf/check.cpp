// Checks of a glTF's JSON: no view leaves its buffer and no accessor its view, each reference
// between objects names something that exists, and nodes form trees.
#include <algorithm>

#include <fmt/format.h>

#include "atlas/base/json.h"
#include "atlas/gltf/checker.h"

namespace burl {
namespace {

using Json = GltfChecker::Json;

/// Calls check(element, "name[i]") for each element of a top-level array.
template <typename Check>
void for_each(const GltfChecker& gltf, const char* name, const Check& check) {
    const Json& list = gltf.list(name);
    for (std::size_t i = 0; i < list.size(); ++i) check(list[i], place(name, i));
}

/// Calls check(element, "where.key[i]") for each object of an inner array.
template <typename Check>
void for_each_in(const GltfChecker& gltf, const Json& object, const char* key,
                 const std::string& where, const Check& check) {
    const Json* list = gltf.array_in(object, key, where);
    if (list == nullptr) return;
    for (std::size_t i = 0; i < list->size(); ++i) {
        const std::string name = fmt::format("{}.{}[{}]", where, key, i);
        if (!(*list)[i].is_object()) gltf.fail(name, "must be an object");
        check((*list)[i], name);
    }
}

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

/// Checks an array of indices into `target`.
void check_indices(const GltfChecker& gltf, const Json& object, const char* key, const char* target,
                   const std::string& where) {
    const Json* list = gltf.array_in(object, key, where);
    if (list == nullptr) return;
    for (std::size_t i = 0; i < list->size(); ++i)
        gltf.as_index((*list)[i], target, fmt::format("{}.{}[{}]", where, key, i));
}

std::uint64_t accessor_count(const GltfChecker& gltf, std::size_t accessor) {
    return gltf.whole(gltf.list("accessors")[accessor], "count", place("accessors", accessor));
}

/// Counts the elements that are read from accessors without data, and refuses more than 2^20. They
/// are zeros and cost nothing in the file, but each use of one may be read. Morph targets are not
/// counted: they have as many elements as their mesh, and exporters leave out the data of those
/// that move nothing.
class ZerosAsked {
  public:
    explicit ZerosAsked(const GltfChecker& gltf) : gltf_(gltf) {}

    void add(std::size_t accessor, const std::string& where) {
        if (gltf_.list("accessors")[accessor].contains("bufferView")) return;
        elements_ += accessor_count(gltf_, accessor);
        if (elements_ > most_zeros)
            gltf_.fail(where, fmt::format("with it {} elements have no bufferView, and {} are the "
                                          "most we take; export the data, uncompressed",
                                          elements_, most_zeros));
    }

  private:
    static constexpr std::uint64_t most_zeros = 1u << 20;

    const GltfChecker& gltf_;
    std::uint64_t elements_ = 0;
};

/// Checks the accessor that `key` names; its index, or -1 where `key` is absent.
std::int64_t check_accessor_use(const GltfChecker& gltf, const Json& object, const char* key,
                                const std::string& where, ZerosAsked& zeros) {
    const std::int64_t i = gltf.index_or_none(object, key, "accessors", where);
    if (i >= 0) zeros.add(static_cast<std::size_t>(i), where + '.' + key);
    return i;
}

void check_index_accessor(const GltfChecker& gltf, const Json& primitive, const std::string& where,
                          ZerosAsked& zeros) {
    const std::int64_t i = check_accessor_use(gltf, primitive, "indices", where, zeros);
    if (i < 0) return;
    const Json& accessor = gltf.list("accessors")[static_cast<std::size_t>(i)];
    const std::uint64_t type = gltf.whole(accessor, "componentType", where);
    if (type != 5121 && type != 5123 && type != 5125)
        gltf.fail(where + ".indices", "must be unsigned bytes, shorts or ints");
    if (*gltf.string_in(accessor, "type", where) != "SCALAR")
        gltf.fail(where + ".indices", "must be of type SCALAR");
}

void check_attributes(const GltfChecker& gltf, const Json& attributes, const std::string& where,
                      std::uint64_t& count) {
    for (const auto& [name, value] : attributes.items()) {
        const std::size_t accessor = gltf.as_index(value, "accessors", where + '.' + name);
        const std::uint64_t held = accessor_count(gltf, accessor);
        if (count == 0) count = held;
        if (held != count)
            gltf.fail(where + '.' + name,
                      fmt::format("has {} elements, other attributes {}", held, count));
    }
}

void check_primitive(const GltfChecker& gltf, const Json& primitive, const std::string& where,
                     ZerosAsked& zeros) {
    const Json* attributes = gltf.object_in(primitive, "attributes", where);
    if (attributes == nullptr) gltf.fail(where, "'attributes' is missing");
    std::uint64_t count = 0;
    check_attributes(gltf, *attributes, where + ".attributes", count);
    for (const auto& [name, value] : attributes->items())
        zeros.add(value.get<std::size_t>(), where + ".attributes." + name);
    for_each_in(gltf, primitive, "targets", where,
                [&](const Json& target, const std::string& name) {
                    check_attributes(gltf, target, name, count);
                });
    check_index_accessor(gltf, primitive, where, zeros);
    gltf.index_or_none(primitive, "material", "materials", where);
    if (gltf.whole_or(primitive, "mode", 4, where) > 6) gltf.fail(where, "unknown 'mode'");
}

void check_texture_info(const GltfChecker& gltf, const Json& owner, const char* key,
                        const std::string& where) {
    const Json* info = gltf.object_in(owner, key, where);
    if (info == nullptr) return;
    gltf.index(*info, "index", "textures", where + '.' + key);
    gltf.whole_or(*info, "texCoord", 0, where + '.' + key);
}

void check_material(const GltfChecker& gltf, const Json& material, const std::string& where) {
    for (const char* key : {"normalTexture", "occlusionTexture", "emissiveTexture"})
        check_texture_info(gltf, material, key, where);
    const Json* pbr = gltf.object_in(material, "pbrMetallicRoughness", where);
    if (pbr == nullptr) return;
    check_texture_info(gltf, *pbr, "baseColorTexture", where);
    check_texture_info(gltf, *pbr, "metallicRoughnessTexture", where);
    gltf.numbers(*pbr, "baseColorFactor", 4, where);
}

void check_node(const GltfChecker& gltf, const Json& node, const std::string& where) {
    gltf.index_or_none(node, "mesh", "meshes", where);
    gltf.index_or_none(node, "skin", "skins", where);
    gltf.index_or_none(node, "camera", "cameras", where);
    check_indices(gltf, node, "children", "nodes", where);
    gltf.numbers(node, "matrix", 16, where);
    gltf.numbers(node, "translation", 3, where);
    gltf.numbers(node, "rotation", 4, where);
    gltf.numbers(node, "scale", 3, where);
    gltf.numbers(node, "weights", 0, where);
}

/// Checks that each node has at most one parent, and that walking down from the roots reaches every
/// node.
void check_trees(const GltfChecker& gltf) {
    const Json& nodes = gltf.list("nodes");
    std::vector<std::int64_t> parent(nodes.size(), -1);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!nodes[i].contains("children")) continue;
        for (const Json& child : nodes[i]["children"]) {
            const auto c = static_cast<std::size_t>(child.get<double>());
            if (parent[c] >= 0 || c == i)
                gltf.fail(place("nodes", c), "has more than one parent, or is its own child");
            parent[c] = static_cast<std::int64_t>(i);
        }
    }
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (parent[i] < 0) open.push_back(i);
    std::size_t reached = 0;
    for (; reached < open.size(); ++reached) {
        if (!nodes[open[reached]].contains("children")) continue;
        for (const Json& child : nodes[open[reached]]["children"])
            open.push_back(static_cast<std::size_t>(child.get<double>()));
    }
    if (reached != nodes.size())
        gltf.fail("nodes", "some nodes are their own ancestors; the nodes must form trees");
}

void check_animation(const GltfChecker& gltf, const Json& animation, const std::string& where,
                     ZerosAsked& zeros) {
    std::size_t samplers = 0;
    for_each_in(gltf, animation, "samplers", where, [&](const Json& s, const std::string& name) {
        for (const char* key : {"input", "output"})
            zeros.add(gltf.index(s, key, "accessors", name), name + '.' + key);
        gltf.string_in(s, "interpolation", name);
        ++samplers;
    });
    for_each_in(gltf, animation, "channels", where, [&](const Json& c, const std::string& name) {
        if (gltf.whole(c, "sampler", name) >= samplers)
            gltf.fail(name, "'sampler' is out of range");
        const Json* target = gltf.object_in(c, "target", name);
        if (target == nullptr) return;
        gltf.index_or_none(*target, "node", "nodes", name + ".target");
        gltf.string_in(*target, "path", name + ".target");
    });
}

}  // namespace

void check_gltf(const GltfChecker& gltf) {
    for_each(gltf, "bufferViews",
             [&](const Json& view, const std::string& where) { check_view(gltf, view, where); });
    for_each(gltf, "accessors", [&](const Json& accessor, const std::string& where) {
        check_accessor(gltf, accessor, where);
    });
    for_each(gltf, "images",
             [&](const Json& image, const std::string& where) { check_image(gltf, image, where); });
    ZerosAsked zeros(gltf);
    for_each(gltf, "textures", [&](const Json& texture, const std::string& where) {
        gltf.index_or_none(texture, "source", "images", where);
        gltf.index_or_none(texture, "sampler", "samplers", where);
    });
    for_each(gltf, "materials", [&](const Json& material, const std::string& where) {
        check_material(gltf, material, where);
    });
    for_each(gltf, "meshes", [&](const Json& mesh, const std::string& where) {
        const Json* primitives = gltf.array_in(mesh, "primitives", where);
        if (primitives == nullptr) gltf.fail(where, "'primitives' is missing");
        for_each_in(gltf, mesh, "primitives", where, [&](const Json& p, const std::string& name) {
            check_primitive(gltf, p, name, zeros);
        });
        gltf.numbers(mesh, "weights", 0, where);
    });
    for_each(gltf, "skins", [&](const Json& skin, const std::string& where) {
        check_indices(gltf, skin, "joints", "nodes", where);
        gltf.index_or_none(skin, "skeleton", "nodes", where);
        check_accessor_use(gltf, skin, "inverseBindMatrices", where, zeros);
    });
    for_each(gltf, "nodes",
             [&](const Json& node, const std::string& where) { check_node(gltf, node, where); });
    check_trees(gltf);
    for_each(gltf, "scenes", [&](const Json& scene, const std::string& where) {
        check_indices(gltf, scene, "nodes", "nodes", where);
    });
    gltf.index_or_none(gltf.root(), "scene", "scenes", "glTF");
    for_each(gltf, "animations", [&](const Json& animation, const std::string& where) {
        check_animation(gltf, animation, where, zeros);
    });
}

}  // namespace burl
