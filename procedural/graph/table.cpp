#include "procedural/graph/table.h"

#include "procedural/graph/node_ops.h"

namespace burl {

std::span<const NodeInput> NodeType::inputs() const {
    std::size_t count = 0;
    while (count < input_list.size() && !input_list[count].key.empty()) ++count;
    return {input_list.data(), count};
}

std::span<const Parameter> NodeType::parameters() const {
    std::size_t count = 0;
    while (count < parameter_list.size() && !parameter_list[count].path.empty()) ++count;
    return {parameter_list.data(), count};
}

const NodeInput* NodeType::input(std::string_view key) const {
    for (const NodeInput& candidate : inputs())
        if (candidate.key == key) return &candidate;
    return nullptr;
}

std::span<const NodeType> graph_table() {
    static const std::vector<NodeType> table = [] {
        std::vector<NodeType> all;
        for (const auto& family :
             {nodes::numbers(), nodes::colors(), nodes::channels(), nodes::patterns(),
              nodes::tiles(), nodes::noises(), nodes::blender_nodes(), nodes::materialx_nodes(),
              nodes::masks(), nodes::points()})
            all.insert(all.end(), family.begin(), family.end());
        return all;
    }();
    return table;
}

const NodeType* find_node(std::string_view name) {
    for (const NodeType& type : graph_table())
        if (type.name == name) return &type;
    return nullptr;
}

double NodeParameters::parameter(std::string_view key, std::size_t component) const {
    std::size_t at = component;
    for (const Parameter& known : type_of(node_).parameters()) {
        if (known.path == key) return node_.parameters[at];
        at += known.count;
    }
    return 0.0;
}

Vec3d NodeParameters::vector(std::string_view key) const {
    return {parameter(key, 0), parameter(key, 1), parameter(key, 2)};
}

}  // namespace burl
