#include "app/editor/graph/graph.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "app/edit/clip.h"
#include "app/edit/node_kinds.h"
#include "app/edit/paint_layers.h"
#include "app/edit/steps.h"
#include "app/editor/widgets/keys.h"
#include "app/editor/widgets/widgets.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

constexpr float tree_share = 0.25f, tree_least = 120.0f, tree_most = 260.0f;

/// The names of "define" that can be connected.
std::vector<std::string> names_of(const NodeGraph& graph) {
    std::vector<std::string> names;
    for (const GraphNodeView& node : graph.nodes)
        if (!node.name.empty()) names.push_back(node.name);
    return names;
}

/// Returns the name of an input: "base colour", "amount of mix in rings".
std::string input_words(const NodeGraph& graph, std::size_t owner, const std::string& place) {
    const GraphNodeView& node = graph.nodes[owner];
    const auto input = std::ranges::find(node.inputs, place, &GraphInput::place);
    return owner == 0 ? input->words : fmt::format("{} of {}", input->words, node.words);
}

/// The text of a node `paint` with a layer of its own.
std::string new_paint(const Recipe& recipe) {
    return fmt::format("paint layer={}", free_paint_layer(recipe));
}

}  // namespace

void EditGraph::build(EditSession& session, const std::function<GraphEdit(const Recipe&)>& edit) {
    const auto place = session.build(edit);
    if (!place) return;
    model_.follow(session);
    if (model_.has(*place)) model_.choose(*place);
    show_chosen_ = true;
}

void EditGraph::open_search(GraphSearch::Purpose purpose, const std::string& place) {
    const NodeGraph& graph = model_.graph();
    const bool is_input = !graph.find(place) && model_.owner_of(place);
    std::string title = "Add a node for later";
    if (purpose == GraphSearch::Purpose::replace)
        title = fmt::format("Replace {}", graph.nodes[graph.find(place).value_or(0)].words);
    else if (purpose == GraphSearch::Purpose::after)
        title = fmt::format("Add a node that goes on with {}",
                            graph.nodes[model_.node_at(place).value_or(0)].words);
    else if (is_input)
        title = fmt::format("Add a node at {}", input_words(graph, *model_.owner_of(place), place));
    else if (!place.empty())
        title = fmt::format("Add a node behind {}",
                            graph.nodes[model_.node_at(place).value_or(0)].words);
    const bool takes_names = is_input && purpose == GraphSearch::Purpose::add;
    search_.open({purpose, place, takes_names ? names_of(graph) : std::vector<std::string>()},
                 std::move(title), search_at_);
}

void EditGraph::take(EditSession& session, const GraphSearch::Choice& chosen) {
    GraphSearch::Choice choice = chosen;
    if (!choice.is_name && choice.text == "paint") choice.text = new_paint(session.recipe());
    const std::string origin = session.recipe_path(), place = choice.wish.place;
    build(session, [&](const Recipe& recipe) {
        if (choice.is_name) return connect(recipe, "define." + choice.text, place);
        const auto step = choice.wish.purpose == GraphSearch::Purpose::replace ? replace_node
                          : choice.wish.purpose == GraphSearch::Purpose::after ? add_node_after
                                                                               : add_node;
        return step(recipe, place, choice.text, origin);
    });
}

void EditGraph::erase(EditSession& session) {
    std::vector<std::string> places = model_.chosen();
    std::erase(places, "material");
    if (places.empty()) return;
    // What takes the node's place is chosen then.
    build(session, [&](const Recipe& recipe) { return delete_nodes(recipe, places); });
}

void EditGraph::copy(EditSession& session, const GraphHooks& hooks) {
    try {
        hooks.set_clipboard(copy_nodes(session.recipe(), model_.chosen()));
        session.tell(
            fmt::format("copied {} nodes with what they are made of", model_.chosen().size()));
    } catch (const Error& error) {
        session.complain(error.what());
    }
}

void EditGraph::paste(EditSession& session, const GraphHooks& hooks) {
    const std::string text = hooks.clipboard(), origin = session.recipe_path();
    // A whole recipe is pasted as one.
    if (!holds_nodes(text)) {
        session.paste_recipe(text);
        return;
    }
    const std::string current = model_.current();
    const std::string place = current == "material" ? "" : current;
    build(session, [&](const Recipe& recipe) { return paste_nodes(recipe, place, text, origin); });
}

void EditGraph::group(EditSession& session) {
    const std::vector<std::string> places = model_.chosen();
    const auto free_name = [&] {
        const std::vector<std::string> names = names_of(model_.graph());
        int number = 1;
        while (std::ranges::count(names, fmt::format("group_{}", number)) > 0) ++number;
        return fmt::format("group_{}", number);
    };
    build(session, [&](const Recipe& recipe) { return group_nodes(recipe, places, free_name()); });
}

void EditGraph::look(const GraphHooks& hooks) {
    const auto node = model_.node_at(model_.current());
    if (!node || *node == 0) return;
    const std::string place = model_.graph().nodes[*node].place;
    hooks.look(place == hooks.looking_at ? "" : place);
}

void EditGraph::paint(EditSession& session, const GraphHooks& hooks, const std::string& place) {
    const auto layer_at = [&](const std::string& at) -> std::optional<int> {
        const auto node = model_.graph().find(at);
        if (!node || model_.graph().nodes[*node].type != "paint") return {};
        return model_.graph().nodes[*node].json.value("layer", 1);
    };
    std::optional<int> layer = layer_at(place);
    if (!layer) {
        const std::string mask = place + ".mask";
        layer = layer_at(mask);
        if (!layer)
            build(session,
                  [&](const Recipe& recipe) { return add_node(recipe, mask, new_paint(recipe)); });
        layer = layer_at(mask);
    }
    if (layer) hooks.paint(*layer);
}

bool EditGraph::shortcuts(const PanelContext& context, const GraphHooks& hooks) {
    if (!focused() || search_.is_open()) return false;
    EditSession& session = context.session;
    const std::string current = model_.current() == "material" ? "" : model_.current();
    const auto on = [](const char* key, auto action) {
        if (!pressed(key)) return false;
        action();
        return true;
    };
    const auto add = [&] { open_search(GraphSearch::Purpose::add, current); };
    const auto remove = [&] {
        if (hooks.looking_at == current) hooks.look("");
        erase(session);
    };
    return on("Insert", add) || on("Tab", add) || on("Space", add) || on("Delete", remove) ||
           on("Backspace", remove) || on("Enter", [&] { look(hooks); }) ||
           on("Ctrl+C", [&] { copy(session, hooks); }) ||
           on("Ctrl+X",
              [&] {
                  copy(session, hooks);
                  remove();
              }) ||
           on("Ctrl+V", [&] { paste(session, hooks); }) || on("Ctrl+G", [&] { group(session); }) ||
           on("Up", [&] { step_tree(-1); }) || on("Down", [&] { step_tree(1); }) ||
           on("Left", [&] { fold(false); }) || on("Right", [&] { fold(true); }) ||
           on("F", [&] { model_.fit(canvas_size_, interface_scale(), true); }) ||
           (hooks.looking_at.empty() && on("Escape", [&] { model_.choose(""); }));
}

/// The menu of a right click.
void EditGraph::menu(const PanelContext& context, const GraphHooks& hooks) {
    if (!ImGui::BeginPopup("graph menu")) return;
    const std::string current = model_.current() == "material" ? "" : model_.current();
    const bool is_node = !current.empty() && model_.graph().find(current);
    const auto entry = [&](const char* words, const char* key, bool enabled, auto action) {
        if (menu_item(context.items, words, key, enabled)) action();
    };
    entry("Add...", "Insert", true, [&] { open_search(GraphSearch::Purpose::add, current); });
    entry("Replace...", "", is_node, [&] { open_search(GraphSearch::Purpose::replace, current); });
    entry("Look at it", "Enter", !current.empty(), [&] { look(hooks); });
    entry("Group", "Ctrl+G", is_node, [&] { group(context.session); });
    entry("Copy nodes", "Ctrl+C", is_node, [&] { copy(context.session, hooks); });
    entry("Paste nodes", "Ctrl+V", true, [&] { paste(context.session, hooks); });
    entry("Disconnect", "", !current.empty() && !current.starts_with("define."), [&] {
        build(context.session, [&](const Recipe& recipe) { return disconnect(recipe, current); });
    });
    entry("Delete", "Delete", !current.empty(), [&] { erase(context.session); });
    ImGui::EndPopup();
}

void EditGraph::canvas(const PanelContext& context, const GraphHooks& hooks, Canvas canvas) {
    ImGui::InvisibleButton("canvas", {float(canvas.size.x), float(canvas.size.y)},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    context.items.note("graph");
    canvas.hovered = ImGui::IsItemHovered();
    canvas_size_ = canvas.size;
    if (model_.wants_fit()) model_.fit(canvas.size, canvas.scale, false);
    if (std::exchange(show_chosen_, false)) model_.show(model_.current(), canvas.size);
    hand(context, hooks, canvas);
    draw(canvas, hooks, context.items);
}

void EditGraph::window(const PanelContext& context, const GraphHooks& hooks) {
    if (std::exchange(wants_focus_, false)) ImGui::SetNextWindowFocus();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
    const bool open = ImGui::Begin("Graph", nullptr,
                                   fixed_window | ImGuiWindowFlags_NoScrollbar |
                                       ImGuiWindowFlags_NoScrollWithMouse |
                                       ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoNavFocus);
    ImGui::PopStyleVar();
    focused_ = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows);
    const ImVec2 size = ImGui::GetContentRegionAvail();
    if (open && size.x >= 8.0f && size.y >= 8.0f) {
        const auto scale = float(interface_scale());
        const float wide = std::clamp(
            tree_share * size.x, std::min(tree_least * scale, 0.4f * size.x), tree_most * scale);
        if (ImGui::BeginChild("tree", {wide, 0.0f}, false, ImGuiWindowFlags_NoNavInputs))
            tree(context.items);
        ImGui::EndChild();
        ImGui::SameLine(0.0f, 0.0f);
        const ImVec2 low = ImGui::GetCursorScreenPos();
        search_at_ = {low.x + 12.0f, low.y + 12.0f};
        canvas(context, hooks, {{low.x, low.y}, {size.x - wide, size.y}, scale});
        menu(context, hooks);
    }
    ImGui::End();
    if (const auto choice = search_.show(context.items)) take(context.session, *choice);
    if (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId)) return;
    if (!search_.is_open() && search_was_open_) wants_focus_ = true;
    search_was_open_ = search_.is_open();
}

}  // namespace burl
