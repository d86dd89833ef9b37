#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "app/materialx/values/builder.h"

namespace burl::materialx {

namespace {

/// The label as a name of "define", which has no dots and does not begin with #.
std::string name_of(const BuiltNode& node) {
    std::string name = node.label.empty() ? node.node : node.label;
    std::ranges::replace(name, '.', '_');
    if (name.starts_with('#')) name.insert(0, "_");
    return name;
}

std::string unused_name(const std::string& wish, const std::set<std::string>& taken) {
    std::string name = wish;
    for (int k = 2; taken.contains(name); ++k) name = fmt::format("{} {}", wish, k);
    return name;
}

/// Whether the node is as short as a name for it.
bool is_leaf(const BuiltNode& node) {
    return node.inputs.empty() && node.parameters.empty();
}

}  // namespace

NodeWriter::NodeWriter(const NodeBuilder& nodes, const std::vector<NodeRef>& roots)
    : nodes_(nodes) {
    for (const NodeRef root : roots) count(root);
    std::set<std::string> taken;
    for (const NodeRef ref : order_) {
        if (uses_[ref] < 2 || is_leaf(nodes_[ref])) continue;
        names_[ref] = unused_name(name_of(nodes_[ref]), taken);
        taken.insert(names_[ref]);
    }
}

void NodeWriter::count(NodeRef ref) {
    if (++uses_[ref] > 1) return;
    for (const auto& [key, input] : nodes_[ref].inputs) count(input);
    order_.push_back(ref);
}

Json NodeWriter::written_out(NodeRef ref) const {
    const BuiltNode& node = nodes_[ref];
    if (node.node.empty()) return node.number;
    Json json{{"node", node.node}};
    json.update(node.parameters);
    for (const auto& [key, input] : node.inputs) json[key] = write(input);
    return json;
}

Json NodeWriter::write(NodeRef ref) const {
    const auto name = names_.find(ref);
    return name == names_.end() ? written_out(ref) : Json(name->second);
}

Json NodeWriter::names() const {
    Json json = Json::object();
    for (const NodeRef ref : order_)
        if (const auto name = names_.find(ref); name != names_.end())
            json[name->second] = written_out(ref);
    return json;
}

}  // namespace burl::materialx
