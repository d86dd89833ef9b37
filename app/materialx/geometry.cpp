#include "app/materialx/geometry.h"

namespace burl::materialx {

namespace {

/// The cosine of the normal with an axis, which is the normal's component.
NodeRef normal_component(NodeBuilder& nodes, std::size_t axis) {
    Json direction = Json::array({0, 0, 0});
    direction[axis] = 1;
    return nodes.node("facing", false, {}, {{"direction", direction}});
}

}  // namespace

NodeRef texture_coordinates(NodeBuilder& nodes) {
    const NodeRef point = nodes.node("point", true, {});
    // The recipe's v points down.
    const NodeRef upwards = nodes.node("transform", true, {{"input", point}},
                                       {{"scale", {1, -1, 1}}, {"translate", {0, 1, 0}}});
    return nodes.node("mesh_uv", true, {{"input", upwards}});
}

std::optional<Value> geometric_property(Reader& reader, std::string_view property) {
    NodeBuilder& nodes = reader.nodes;
    if (property == "Pobject" || property == "Pworld")
        return reader.values.of_color(Type::vector3, nodes.node("point", true, {}));
    if (property == "Nobject" || property == "Nworld")
        return reader.values.of_parts(
            Type::vector3,
            {normal_component(nodes, 0), normal_component(nodes, 1), normal_component(nodes, 2)});
    if (property == "UV0") return reader.values.of_color(Type::vector2, texture_coordinates(nodes));
    return {};
}

}  // namespace burl::materialx
