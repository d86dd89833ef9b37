// Nodes and wires on the graph's canvas (graph.h).
#include "app/editor/graph/draw.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "app/edit/node_kinds.h"
#include "app/editor/graph/graph.h"
#include "app/editor/widgets/keys.h"
#include "atlas/base/json.h"
#include "procedural/model/texture_json.h"

namespace burl {

namespace {

constexpr ImU32 canvas_color = IM_COL32(27, 29, 33, 255), body_color = IM_COL32(47, 50, 56, 245);
constexpr ImU32 words_color = IM_COL32(226, 228, 232, 255),
                dim_color = IM_COL32(150, 155, 164, 255);
constexpr ImU32 chosen_edge = IM_COL32(255, 204, 110, 255), node_edge = IM_COL32(16, 17, 20, 255);
constexpr ImU32 number_wire = IM_COL32(148, 160, 178, 255),
                color_wire = IM_COL32(222, 172, 92, 255);
constexpr ImU32 look_edge = IM_COL32(110, 200, 255, 255), disc_color = IM_COL32(62, 66, 74, 255);
constexpr ImU32 part_color = IM_COL32(34, 37, 42, 255), name_color = IM_COL32(150, 196, 150, 255);
constexpr double words_zoom = 0.6, title_zoom = 0.3;  // least zooms at which they can be read
constexpr double sharp_zoom = 0.72;
constexpr float least_title = 10.0f;   // least height of a title, in pixels
constexpr std::size_t few_names = 12;  // wires of names that are all drawn

/// Title bars by families: numbers, colours, channels, patterns, tiles, noise, masks, points.
constexpr std::array family_colors{IM_COL32(70, 80, 96, 255),  IM_COL32(128, 92, 48, 255),
                                   IM_COL32(118, 74, 92, 255), IM_COL32(66, 102, 76, 255),
                                   IM_COL32(54, 98, 100, 255), IM_COL32(58, 84, 130, 255),
                                   IM_COL32(98, 76, 128, 255), IM_COL32(112, 68, 62, 255)};

ImVec2 to_screen(const Vec2d& at) {
    return {float(at.x), float(at.y)};
}

std::string value_words(const Json& value) {
    if (value.is_number()) return fmt::format("{:.3g}", value.get<double>());
    if (!value.is_array()) return value.is_string() ? value.get<std::string>() : "";
    std::string all;
    for (const Json& one : value) all += (all.empty() ? "" : " ") + value_words(one);
    return all;
}

/// Draws one canvas.
class CanvasPicture {
  public:
    CanvasPicture(const GraphModel& model, const Vec2d& low, const Vec2d& high)
        : model_(model), low_(low), high_(high), list_(*ImGui::GetWindowDrawList()) {}

    Vec2d screen(const Vec2d& point) const { return model_.camera.screen(point, low_); }
    float zoomed(double length) const { return float(length * model_.camera.zoom); }

    bool seen(std::size_t node) const {
        const Vec2d low = screen(model_.place(node));
        const Vec2d high =
            screen(model_.place(node) + Vec2d(model_.box(node).width, model_.box(node).height));
        return low.x < high_.x && low.y < high_.y && high.x > low_.x && high.y > low_.y;
    }

    void background() {
        list_.AddRectFilled(to_screen(low_), to_screen(high_), canvas_color);
        const double step = 64.0 * model_.camera.zoom;
        if (step < 14.0) return;
        const Vec2d first = screen(glm::ceil(model_.camera.offset / 64.0) * 64.0);
        for (double x = first.x; x < high_.x; x += step)
            for (double y = first.y; y < high_.y; y += step)
                list_.AddRectFilled(to_screen({x, y}), to_screen({x + 1.5, y + 1.5}),
                                    IM_COL32(52, 56, 62, 255));
    }

    /// Frames around the parts of a page.
    void parts() {
        for (const GraphPart& part : model_.parts())
            list_.AddRectFilled(to_screen(screen(part.low)), to_screen(screen(part.high)),
                                part_color, zoomed(8.0));
    }

    /// The names of the parts, where those of the nodes are too small.
    void captions() {
        if (!is_small()) return;
        for (const GraphPart& part : model_.parts()) {
            const GraphNodeView& node = model_.graph().nodes[part.nodes.front()];
            const std::string words = node.name.empty() ? node.words : spoken(node.name);
            const Vec2d low = screen(part.low), high = screen(part.high);
            const ImVec4 clip{float(low.x), float(low.y), float(std::max(high.x, low.x + 60.0)),
                              float(high_.y)};
            list_.AddText(ImGui::GetFont(), ImGui::GetFontSize(), to_screen(low + Vec2d(3.0, -2.0)),
                          name_color, words.data(), words.data() + words.size(), 0.0f, &clip);
        }
    }

    void curve(const Vec2d& from, const Vec2d& to, ImU32 color, float width) {
        const Vec2d a = screen(from), b = screen(to);
        const double bend = std::clamp(0.5 * std::abs(b.x - a.x), 18.0 * model_.camera.zoom,
                                       90.0 * model_.camera.zoom);
        list_.AddBezierCubic(to_screen(a), to_screen({a.x + bend, a.y}),
                             to_screen({b.x - bend, b.y}), to_screen(b), color, width);
    }

    /// Wires of names are faint or, where there are many, not drawn, unless one of their ends is
    /// chosen: they cross much, and the input says the name.
    void wire(std::size_t node, std::size_t input) {
        const GraphInput& end = model_.graph().nodes[node].inputs[input];
        if (!end.from) return;
        const GraphNodeView& source = model_.graph().nodes[*end.from];
        const bool near = model_.is_chosen(source.place) ||
                          model_.is_chosen(model_.graph().nodes[node].place) ||
                          model_.is_chosen(end.place);
        if (end.by_name && !near && !draws_names_) return;
        const ImU32 full = near                          ? chosen_edge
                           : source.gives == Wire::color ? color_wire
                                                         : number_wire;
        const ImU32 alpha = near ? 255U : end.by_name ? 92U : 200U;
        const ImU32 color = (full & ~IM_COL32_A_MASK) | (alpha << IM_COL32_A_SHIFT);
        curve(output_point(model_, *end.from), input_point(model_, node, input), color,
              std::max(1.0f, zoomed(near ? 2.4 : 1.8)));
    }

    /// The height of words in pixels, at least `least`. Between some zooms they are as sharp as
    /// elsewhere, and have room enough.
    float text_size(float least = 0.0f) const {
        const double zoom = model_.camera.zoom / interface_scale_;
        if (zoom > sharp_zoom && zoom < 1.1) return ImGui::GetFontSize();
        return std::max(least, zoomed(double(ImGui::GetFontSize()) / interface_scale_));
    }
    /// The width of words on the plane.
    double width_of(const std::string& words) const {
        const float size = text_size();
        return double(ImGui::CalcTextSize(words.c_str()).x * size / ImGui::GetFontSize()) /
               model_.camera.zoom;
    }

    void text(const Vec2d& point, ImU32 color, const std::string& words, double room,
              float least = 0.0f) {
        const float size = text_size(least);
        const Vec2d at = screen(point);
        const ImVec4 clip{float(at.x), float(at.y), float(at.x) + zoomed(room), float(high_.y)};
        list_.AddText(ImGui::GetFont(), size, to_screen(at), color, words.data(),
                      words.data() + words.size(), 0.0f, &clip);
    }

    void pin(const Vec2d& point, ImU32 color, bool filled) {
        const ImVec2 at = to_screen(screen(point));
        list_.AddCircleFilled(at, zoomed(4.2), filled ? color : body_color, 12);
        list_.AddCircle(at, zoomed(4.2), color, 12, std::max(1.0f, zoomed(1.3)));
    }

    void node(std::size_t index, ImTextureID picture, bool looked_at) {
        const GraphNodeView& node = model_.graph().nodes[index];
        const Vec2d low = model_.place(index),
                    high = low + Vec2d(model_.box(index).width, model_.box(index).height);
        const ImVec2 a = to_screen(screen(low)), b = to_screen(screen(high));
        const float round = zoomed(5.0);
        list_.AddRectFilled(a, b, body_color, round);
        list_.AddRectFilled(a, is_small() ? b : ImVec2(b.x, a.y + zoomed(node_title)),
                            title_color(node), round,
                            is_small() ? ImDrawFlags_RoundCornersAll : ImDrawFlags_RoundCornersTop);
        const bool chosen = model_.is_chosen(node.place);
        list_.AddRect(a, b, chosen ? chosen_edge : node_edge, round, 0,
                      chosen ? std::max(1.5f, zoomed(2.0)) : 1.0f);
        if (index > 0) ball(index, picture, looked_at);
        if (model_.camera.zoom >= title_zoom * interface_scale_) title(index);
        if (!is_small()) rows(index);
        pins(index);
    }

    void set_interface(double scale) { interface_scale_ = scale; }

    void count_names() {
        std::size_t names = 0;
        for (const GraphNodeView& node : model_.graph().nodes)
            for (const GraphInput& input : node.inputs) names += input.by_name ? 1 : 0;
        draws_names_ = names <= few_names;
    }

  private:
    /// Whether nodes are too small for more than their titles.
    bool is_small() const { return model_.camera.zoom < words_zoom * interface_scale_; }

    static ImU32 title_color(const GraphNodeView& node) {
        const NodeType* type = find_node(node.type);
        return type ? family_colors[std::size_t(family_of(*type))] : IM_COL32(88, 88, 88, 255);
    }

    void title(std::size_t index) {
        const GraphNodeView& node = model_.graph().nodes[index];
        const Vec2d at =
            model_.place(index) + Vec2d(is_small() ? 4.0 : 9.0, is_small() ? 2.0 : 4.0);
        const std::string type = spoken(node.type);
        const std::string words = node.name.empty() ? type : spoken(node.name);
        text(at, words_color, words, node_width - 14.0, least_title * float(interface_scale_));
        if (node.name.empty() || node.type == node.name || is_small()) return;
        const double used = width_of(words) + 8.0;
        text(at + Vec2d(used, 0.0), IM_COL32(226, 228, 232, 140), type, node_width - 22.0 - used);
    }

    void ball(std::size_t index, ImTextureID picture, bool looked_at) {
        const NodeBox& box = model_.box(index);
        const double side = node_ball;
        const Vec2d low = model_.place(index) +
                          Vec2d(box.width - side - 6.0, 0.5 * (node_title + box.height - side));
        const ImVec2 a = to_screen(screen(low)), b = to_screen(screen(low + Vec2d(side)));
        const ImVec2 middle{0.5f * (a.x + b.x), 0.5f * (a.y + b.y)};
        if (picture)
            list_.AddImageRounded(picture, a, b, {0.0f, 0.0f}, {1.0f, 1.0f}, IM_COL32_WHITE,
                                  0.5f * (b.x - a.x));
        else
            list_.AddCircleFilled(middle, zoomed(0.5 * side), disc_color, 32);
        if (looked_at)
            list_.AddCircle(middle, zoomed(0.5 * side + 2.0), look_edge, 40, zoomed(2.0));
    }

    void rows(std::size_t index) {
        const auto& lines = model_.lines(index);
        const std::size_t inputs = model_.graph().nodes[index].inputs.size();
        const double room = node_width - (index > 0 ? node_ball + 12.0 : 4.0);
        for (std::size_t k = 0; k < lines.size(); ++k) {
            const Vec2d at = input_point(model_, index, k) + Vec2d(9.0, -7.0);
            const bool is_color =
                lines[k].value.is_string() && lines[k].value.get<std::string>().starts_with('#');
            const std::string value = is_color ? "" : value_words(lines[k].value);
            const std::string& words = lines[k].words;
            text(at, k < inputs ? words_color : dim_color, words, room - 9.0);
            const double used = width_of(words) + 6.0;
            if (is_color)
                swatch(at + Vec2d(used, 2.0), lines[k].value);
            else
                text(at + Vec2d(used, 0.0), lines[k].name ? name_color : dim_color, value,
                     room - 9.0 - used);
        }
    }

    void swatch(const Vec2d& point, const Json& hex) {
        const Rgb8 color = color_from_hex(hex.get<std::string>());
        const ImVec2 a = to_screen(screen(point)), b = to_screen(screen(point + Vec2d(22.0, 10.0)));
        list_.AddRectFilled(a, b, IM_COL32(color.r, color.g, color.b, 255), zoomed(2.0));
        list_.AddRect(a, b, node_edge, zoomed(2.0));
    }

    void pins(std::size_t index) {
        const GraphNodeView& node = model_.graph().nodes[index];
        const auto color = [](Wire wire) { return wire == Wire::color ? color_wire : number_wire; };
        for (std::size_t k = 0; k < node.inputs.size(); ++k) {
            const GraphInput& input = node.inputs[k];
            const bool chosen = model_.is_chosen(input.place);
            pin(input_point(model_, index, k), chosen ? chosen_edge : color(input.wire),
                input.from.has_value() || chosen);
        }
        if (index > 0) pin(output_point(model_, index), color(node.gives), true);
    }

    const GraphModel& model_;
    Vec2d low_, high_;
    ImDrawList& list_;
    double interface_scale_ = 1.0;
    bool draws_names_ = true;
};

/// Notes a rectangle of the canvas as an item, as far as it is seen.
void note(EditItems& items, const std::string& name, const Vec2d& low, const Vec2d& high,
          const Vec2d& seen_low, const Vec2d& seen_high) {
    const Vec2d from = glm::max(low, seen_low), to = glm::min(high, seen_high);
    if (from.x < to.x && from.y < to.y) items.note(name, {from, to});
}

}  // namespace

void EditGraph::draw(const Canvas& canvas, const GraphHooks& hooks, EditItems& items) {
    const Vec2d high = canvas.low + canvas.size;
    CanvasPicture picture(model_, canvas.low, high);
    picture.set_interface(canvas.scale);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(to_screen(canvas.low), to_screen(high), true);
    picture.count_names();
    picture.background();
    picture.parts();
    const auto& nodes = model_.graph().nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t k = 0; k < nodes[i].inputs.size(); ++k) picture.wire(i, k);
    seen_.clear();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!picture.seen(i)) continue;
        if (i > 0) seen_.push_back(nodes[i].place);
        picture.node(i, i > 0 && hooks.picture ? hooks.picture(nodes[i]) : nullptr,
                     !hooks.looking_at.empty() && nodes[i].place == hooks.looking_at);
        const auto item = [&](const char* what, const std::string& place, const Vec2d& from,
                              const Vec2d& to) {
            note(items, what + place, picture.screen(from), picture.screen(to), canvas.low, high);
        };
        const Vec2d at = model_.place(i), pin(5.0);
        item("node:", nodes[i].place, at + Vec2d(12.0, 0.0),
             at + Vec2d(node_width - 12.0, node_title));
        for (std::size_t k = 0; k < nodes[i].inputs.size(); ++k)
            item("in:", nodes[i].inputs[k].place, input_point(model_, i, k) - pin,
                 input_point(model_, i, k) + pin);
        if (i > 0)
            item("out:", nodes[i].place, output_point(model_, i) - pin,
                 output_point(model_, i) + pin);
    }
    picture.captions();
    draw_drag(canvas);
    list.PopClipRect();
    tell_about(canvas);
}

/// Draws the wire or the frame that is being dragged.
void EditGraph::draw_drag(const Canvas& canvas) {
    if (!moved_) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Vec2d at = pointer_now();
    CanvasPicture picture(model_, canvas.low, canvas.low + canvas.size);
    const Vec2d point = model_.camera.plane(at, canvas.low);
    if (grip_ == Grip::frame) {
        list.AddRectFilled(to_screen(pressed_at_), to_screen(at), IM_COL32(255, 204, 110, 24));
        list.AddRect(to_screen(glm::min(pressed_at_, at)), to_screen(glm::max(pressed_at_, at)),
                     chosen_edge);
    }
    if (grip_ == Grip::wire_from)
        if (const auto node = model_.graph().find(held_))
            picture.curve(output_point(model_, *node), point, chosen_edge, 2.4f);
    if (grip_ != Grip::wire_to) return;
    const auto owner = model_.owner_of(held_);
    if (!owner) return;
    const auto& inputs = model_.graph().nodes[*owner].inputs;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
        if (inputs[k].place != held_) continue;
        if (inputs[k].from)
            picture.curve(output_point(model_, *inputs[k].from), point, chosen_edge, 2.4f);
        else
            picture.curve(point, input_point(model_, *owner, k), chosen_edge, 2.4f);
    }
}

/// Shows what the node or input is on which the pointer rests.
void EditGraph::tell_about(const Canvas& canvas) {
    const Vec2d at = pointer_now();
    const std::string under =
        canvas.hovered ? node_under(canvas, at) + " " + input_under(canvas, at) : "";
    if (std::exchange(rested_on_, under) != under) rested_since_ = ImGui::GetTime();
    const auto node = model_.graph().find(node_under(canvas, at));
    if (!canvas.hovered || !node || grip_ != Grip::none || ImGui::IsAnyMouseDown() ||
        ImGui::GetTime() < rested_since_ + 0.6)
        return;
    const GraphNodeView& view = model_.graph().nodes[*node];
    std::string words = view.words;
    if (const NodeType* type = find_node(view.type)) words += fmt::format("\n{}", type->text);
    if (*node == 0) words = "The material: what the nodes end in";
    for (const GraphInput& input : view.inputs)
        if (input.place == input_under(canvas, at))
            words = fmt::format("{}: {}", input.words, input.tip);
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(26.0f * ImGui::GetFontSize());
    ImGui::TextUnformatted(words.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

}  // namespace burl
