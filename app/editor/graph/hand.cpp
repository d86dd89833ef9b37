// The pointer over the canvas of the graph: choosing, moving the view, drawing wires (graph.h).
#include <algorithm>
#include <utility>

#include "app/edit/steps.h"
#include "app/editor/graph/draw.h"
#include "app/editor/graph/graph.h"
#include "app/editor/widgets/keys.h"

namespace burl {

namespace {

constexpr double least_drag = 4.0;   // pixels from which a press is a drag
constexpr double wheel_zoom = 1.15;  // a notch
constexpr double least_graph_zoom = 0.1, most_graph_zoom = 3.0;

bool within(const Vec2d& at, const Vec2d& low, const Vec2d& high) {
    return at.x >= low.x && at.y >= low.y && at.x < high.x && at.y < high.y;
}

}  // namespace

std::string EditGraph::node_under(const Canvas& canvas, const Vec2d& at) const {
    const Vec2d point = model_.camera.plane(at, canvas.low);
    for (std::size_t i = 0; i < model_.graph().nodes.size(); ++i) {
        const Vec2d low = model_.place(i);
        if (within(point, low, low + Vec2d(model_.box(i).width, model_.box(i).height)))
            return model_.graph().nodes[i].place;
    }
    return "";
}

std::string EditGraph::input_under(const Canvas& canvas, const Vec2d& at) const {
    const Vec2d point = model_.camera.plane(at, canvas.low);
    for (std::size_t i = 0; i < model_.graph().nodes.size(); ++i)
        for (std::size_t k = 0; k < model_.graph().nodes[i].inputs.size(); ++k) {
            const Vec2d away = point - input_point(model_, i, k);
            // The whole row takes a wire, its left end begins one.
            const double reach = grip_ == Grip::none ? 9.0 : 0.6 * node_width;
            if (away.x > -9.0 && away.x < reach && std::abs(away.y) < 0.5 * node_row)
                return model_.graph().nodes[i].inputs[k].place;
        }
    return "";
}

std::string EditGraph::output_under(const Canvas& canvas, const Vec2d& at) const {
    const Vec2d point = model_.camera.plane(at, canvas.low);
    for (std::size_t i = 1; i < model_.graph().nodes.size(); ++i)
        if (glm::length(point - output_point(model_, i)) < 10.0)
            return model_.graph().nodes[i].place;
    return "";
}

/// Begins a drag with the left button, and chooses what is under the pointer.
void EditGraph::press(const Canvas& canvas, const Vec2d& at) {
    const bool more = ImGui::GetIO().KeyShift;
    pressed_at_ = at;
    moved_ = false;
    grip_ = Grip::none;
    const std::string input = input_under(canvas, at), output = output_under(canvas, at);
    const std::string node = node_under(canvas, at);
    if (!input.empty()) {
        held_ = input;
        grip_ = Grip::wire_to;
        model_.choose(input);
    } else if (!output.empty() || (!node.empty() && node != "material")) {
        held_ = output.empty() ? node : output;
        grip_ = Grip::wire_from;
        if (more)
            model_.toggle(held_);
        else if (!model_.is_chosen(held_))
            model_.choose(held_);
    } else if (!node.empty()) {
        model_.choose(node);
    } else {
        grip_ = Grip::frame;
        if (!more) model_.choose("");
    }
}

/// Ends the drag of a wire over what takes it.
void EditGraph::drop_wire(EditSession& session, const Canvas& canvas, const Vec2d& at) {
    const std::string input = input_under(canvas, at);
    const std::string node = node_under(canvas, at);
    const std::string held = held_;
    search_at_ = {float(at.x), float(at.y)};
    if (grip_ == Grip::wire_from) {
        if (!input.empty())
            build(session, [&](const Recipe& recipe) { return connect(recipe, held, input); });
        else if (node.empty() && canvas.hovered)
            open_search(GraphSearch::Purpose::after, held);
        return;
    }
    const bool wired = model_.node_at(held) != model_.owner_of(held);
    if (!input.empty() && input != held && wired)
        build(session, [&](const Recipe& recipe) { return move_node(recipe, held, input); });
    else if (!node.empty() && node != "material" && input.empty())
        build(session, [&](const Recipe& recipe) { return connect(recipe, node, held); });
    else if (node.empty() && wired)
        build(session, [&](const Recipe& recipe) { return disconnect(recipe, held); });
    else if (node.empty() && canvas.hovered)
        open_search(GraphSearch::Purpose::add, held);
}

void EditGraph::drop(EditSession& session, const Canvas& canvas, const Vec2d& at) {
    if (grip_ == Grip::frame && moved_) {
        const Vec2d low = model_.camera.plane(glm::min(pressed_at_, at), canvas.low);
        const Vec2d high = model_.camera.plane(glm::max(pressed_at_, at), canvas.low);
        std::vector<std::string> places = model_.chosen();
        for (std::size_t i = 1; i < model_.graph().nodes.size(); ++i) {
            const Vec2d from = model_.place(i),
                        to = from + Vec2d(model_.box(i).width, model_.box(i).height);
            const std::string& place = model_.graph().nodes[i].place;
            if (from.x < high.x && from.y < high.y && to.x > low.x && to.y > low.y &&
                std::ranges::count(places, place) == 0)
                places.push_back(place);
        }
        model_.choose_all(std::move(places));
    } else if ((grip_ == Grip::wire_from || grip_ == Grip::wire_to) && moved_) {
        drop_wire(session, canvas, at);
    }
    grip_ = Grip::none;
}

void EditGraph::hand(const PanelContext& context, const GraphHooks& hooks, const Canvas& canvas) {
    const ImGuiIO& io = ImGui::GetIO();
    const Vec2d at = pointer_now();
    if (canvas.hovered && io.MouseWheel != 0.0f) {
        const Vec2d point = model_.camera.plane(at, canvas.low);
        model_.camera.zoom =
            std::clamp(model_.camera.zoom * std::pow(wheel_zoom, double(io.MouseWheel)),
                       least_graph_zoom, most_graph_zoom);
        model_.camera.offset = point - (at - canvas.low) / model_.camera.zoom;
        model_.follows_layout = false;
    }
    if (ImGui::IsItemActivated() && io.MouseDown[0]) press(canvas, at);
    if (ImGui::IsItemActivated() && !io.MouseDown[0]) {
        grip_ = Grip::pan;
        pressed_at_ = at;
        moved_ = false;
    }
    moved_ |= grip_ != Grip::none && glm::length(at - pressed_at_) >= least_drag;
    if (grip_ == Grip::pan && ImGui::IsItemActive() && moved_) model_.follows_layout = false;
    if (grip_ == Grip::pan && ImGui::IsItemActive() && moved_)
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (grip_ == Grip::pan && ImGui::IsItemActive())
        model_.camera.offset -= Vec2d(io.MouseDelta.x, io.MouseDelta.y) / model_.camera.zoom;
    if (ImGui::IsItemDeactivated()) {
        const bool clicked_right = grip_ == Grip::pan && !moved_ && io.MouseReleased[1];
        const std::string node = node_under(canvas, at);
        drop(context.session, canvas, at);
        if (clicked_right && !node.empty() && !model_.is_chosen(node)) model_.choose(node);
        if (clicked_right) ImGui::OpenPopup("graph menu");
    }
    if (canvas.hovered && ImGui::IsMouseDoubleClicked(0)) {
        const bool on_pin = !input_under(canvas, at).empty() || !output_under(canvas, at).empty();
        const std::string node = node_under(canvas, at);
        if (node.empty() && !on_pin) {
            search_at_ = {float(at.x), float(at.y)};
            open_search(GraphSearch::Purpose::add, "");
        } else if (!on_pin && node != "material") {
            model_.choose(node);
            look(hooks);
        }
    }
}

}  // namespace burl
