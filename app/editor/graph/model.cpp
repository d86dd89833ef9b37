#include "app/editor/graph/model.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "app/edit/node_kinds.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

constexpr std::size_t most_notes = 3;  // parameters that a node shows
constexpr double least_zoom = 0.55;    // below it all nodes are too small to be read

/// The parameters that are not what they are by default, as far as there is room for them.
void add_notes(const GraphNodeView& node, const NodeType& type, std::vector<NodeLine>& lines) {
    std::size_t room = std::max(most_notes, lines.size()) - lines.size();
    for (const Parameter& parameter : type.parameters()) {
        const std::string key(parameter.path);
        if (room == 0 || !node.json.contains(key)) continue;
        const Json& value = node.json[key];
        if (value == Json::parse(parameter.default_value, nullptr, false)) continue;
        lines.push_back({spoken(key), value});
        --room;
    }
}

}  // namespace

std::vector<NodeLine> lines_of(const NodeGraph& graph, const GraphNodeView& node) {
    std::vector<NodeLine> lines;
    for (const GraphInput& input : node.inputs) {
        const bool named = input.by_name && input.from;
        lines.push_back({input.words,
                         named ? Json(spoken(graph.nodes[*input.from].name)) : input.constant,
                         named});
    }
    if (node.place == "material") lines.push_back({"add a channel ..."});
    if (node.terms > 0) lines.push_back({fmt::format("{} noise", node.terms)});
    if (node.type == "constant") lines.push_back({"value", node.json});
    if (const NodeType* type = find_node(node.type)) add_notes(node, *type, lines);
    return lines;
}

bool GraphModel::follow(EditSession& session) {
    const EditHistory& history = session.history();
    const bool moves = !session.recipe().animation.tracks.empty();
    const bool same = revision_ == history.revision() && (!moves || time_ == session.time());
    if (same) return false;
    revision_ = history.revision();
    time_ = session.time();
    if (std::exchange(document_, history.document_number()) != document_) follows_layout = true;
    const std::optional<Vec2d> before = anchor();
    graph_ = node_graph(session.still());
    lay_out();
    std::erase_if(chosen_, [&](const std::string& place) { return !has(place); });
    if (const auto now = anchor(); before && now) camera.offset += *now - *before;
    new_layout_ = true;
    return true;
}

void GraphModel::lay_out() {
    boxes_.clear();
    lines_.clear();
    for (const GraphNodeView& node : graph_.nodes) {
        lines_.push_back(lines_of(graph_, node));
        const double rows = node_row * double(lines_.back().size());
        const double ball = node.place == "material" ? 0.0 : node_ball + 6.0;
        boxes_.push_back({node_width, node_title + std::max(rows, ball) + 6.0,
                          node_title + 0.5 * node_row + 2.0, node_row, 0.5 * node_title});
    }
    layout_ = layout_graph(graph_, boxes_);
}

/// The place of the node chosen last, or of the material, on the plane.
std::optional<Vec2d> GraphModel::anchor() const {
    if (layout_.places.empty()) return {};
    const auto node = node_at(current());
    return layout_.places[node.value_or(0)];
}

bool GraphModel::is_chosen(const std::string& place) const {
    return std::ranges::count(chosen_, place) > 0;
}

void GraphModel::choose(const std::string& place) {
    chosen_.clear();
    if (!place.empty()) chosen_.push_back(place);
}

void GraphModel::toggle(const std::string& place) {
    if (std::erase(chosen_, place) == 0) chosen_.push_back(place);
}

bool GraphModel::has(const std::string& place) const {
    return graph_.find(place).has_value() || owner_of(place).has_value();
}

std::optional<std::size_t> GraphModel::node_at(const std::string& place) const {
    if (const auto node = graph_.find(place)) return node;
    const auto owner = owner_of(place);
    if (!owner) return {};
    for (const GraphInput& input : graph_.nodes[*owner].inputs)
        if (input.place == place && input.from) return input.from;
    return owner;
}

std::optional<std::size_t> GraphModel::owner_of(const std::string& place) const {
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i)
        if (std::ranges::count(graph_.nodes[i].inputs, place, &GraphInput::place) > 0) return i;
    return {};
}

void GraphModel::fit(const Vec2d& size, double scale, bool all) {
    new_layout_ = false;
    constexpr double margin = 24.0;
    const Vec2d whole = layout_.size + Vec2d(2.0 * margin);
    const double zoom = std::min({size.x / whole.x, size.y / whole.y, scale});
    const bool small = zoom < least_zoom * scale && !all;
    camera.zoom = small ? 0.8 * scale : std::max(zoom, 0.1);
    const Vec2d seen = size / camera.zoom;
    camera.offset = 0.5 * (layout_.size - seen);
    if (!small) return;
    const Vec2d material = layout_.places[0] + 0.5 * Vec2d(boxes_[0].width, boxes_[0].height);
    camera.offset = {layout_.size.x + margin - seen.x, material.y - 0.5 * seen.y};
}

void GraphModel::show(const std::string& at, const Vec2d& size) {
    const auto node = node_at(at);
    if (!node) return;
    const Vec2d low = layout_.places[*node],
                high = low + Vec2d(boxes_[*node].width, boxes_[*node].height);
    const Vec2d seen = size / camera.zoom;
    for (int axis = 0; axis < 2; ++axis) {
        const double least = high[axis] + 12.0 - seen[axis], most = low[axis] - 12.0;
        if (least <= most) camera.offset[axis] = std::clamp(camera.offset[axis], least, most);
    }
}

}  // namespace burl
