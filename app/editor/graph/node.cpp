// The panel of the node that is chosen in the graph (graph.h).
#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <imgui_stdlib.h>

#include "app/edit/lists.h"
#include "app/edit/node_kinds.h"
#include "app/edit/steps.h"
#include "app/editor/graph/graph.h"
#include "app/editor/panels/parameters.h"
#include "app/editor/session/groups.h"
#include "app/editor/widgets/flow.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

constexpr std::array blend_modes{"normal", "multiply", "screen",  "overlay",
                                 "add",    "darken",   "lighten", "soft_light"};

/// The panel in one frame.
class NodePanel {
  public:
    NodePanel(const PanelContext& context, EditGraph& graph, const GraphHooks& hooks)
        : context_(context), graph_(graph), hooks_(hooks) {}

    void show(StopSelection& stop) {
        const std::string current = graph_.model().current();
        const auto node = graph_.model().graph().find(current);
        if (current.empty()) return nothing();
        if (!node) return input(current);
        // A copy, since a step of building makes other nodes.
        const GraphNodeView view = graph_.model().graph().nodes[*node];
        if (*node == 0) return material(view);
        heading(view);
        buttons(view);
        parameters(view);
        if (view.type == "color_map") color_map_editor(context_, view.place, stop);
        if (view.type == "field") terms(view);
        layers(view.place, view.gives);
    }

  private:
    void build(const std::function<GraphEdit(const Recipe&)>& edit) {
        graph_.build(context_.session, edit);
    }
    bool button(const char* words, const std::string& item) {
        const bool clicked = ImGui::Button(words);
        context_.items.note(item);
        return clicked;
    }
    bool small_button(const std::string& words, const std::string& item, const char* sentence) {
        const bool clicked = ImGui::SmallButton((words + "##" + item).c_str());
        context_.items.note(item);
        tip(sentence);
        return clicked;
    }

    static void nothing() {
        ImGui::TextWrapped(
            "Choose a node of the graph. Insert, or a double click beside the nodes, adds one; "
            "drag "
            "from a node to an input to connect it.");
    }

    void heading(const GraphNodeView& view) {
        ImGui::TextWrapped("%s", view.words.c_str());
        context_.items.note("node words");
        const NodeType* type = find_node(view.type);
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyle().Colors[ImGuiCol_TextDisabled]);
        ImGui::TextWrapped("%s", type ? std::string(type->text).c_str() : "");
        ImGui::PopStyleColor();
        name(view);
    }

    /// The name, which Enter gives.
    void name(const GraphNodeView& view) {
        std::string name = view.name;
        ImGui::SetNextItemWidth(0.62f * ImGui::GetContentRegionAvail().x);
        const std::string id = "##name" + view.place;
        const bool entered = ImGui::InputTextWithHint(id.c_str(), "no name", &name,
                                                      ImGuiInputTextFlags_EnterReturnsTrue);
        context_.items.note("node name");
        tip("A name under which others can use it; Enter gives it.");
        ImGui::SameLine();
        ImGui::TextUnformatted("name");
        if (entered && name != view.name)
            build([&](const Recipe& recipe) { return name_node(recipe, view.place, name); });
    }

    void buttons(const GraphNodeView& view) {
        const bool looks = hooks_.looking_at == view.place;
        const char* const look = looks ? "End look" : "Look";
        const std::vector<float> widths{button_width(look), button_width("Add before"),
                                        button_width("Replace"), button_width("Delete"),
                                        button_width("Write out")};
        Flow flow(widths);
        const auto next = [&](const char* words, const char* item, const char* sentence) {
            flow.next();
            const bool clicked = button(words, item);
            tip(sentence);
            return clicked;
        };
        if (next(look, "node look", "Shows what this node gives on the object, alone (Enter)."))
            graph_.look(hooks_);
        if (next("Add before", "node add", "Puts a new node in this one's place (Insert)."))
            graph_.open_search(GraphSearch::Purpose::add, view.place);
        if (next("Replace", "node replace", "Takes another node here, with the same inputs."))
            graph_.open_search(GraphSearch::Purpose::replace, view.place);
        if (next("Delete", "node delete", "Takes the node away; what it changes stays (Delete)."))
            graph_.erase(context_.session);
        if (!view.name.empty() && next("Write out", "node write out",
                                       "Copies it to all that use it, and drops the name."))
            build([&](const Recipe& recipe) { return inline_name(recipe, view.name); });
        paints(view);
    }

    /// The button that takes the brush, of a node `paint` and of a layer.
    void paints(const GraphNodeView& view) {
        const bool layer = view.type == "blend";
        if (!layer && view.type != "paint") return;
        if (button(layer ? "Paint the mask" : "Paint it", "node paint"))
            graph_.paint(context_.session, hooks_, view.place);
        tip(layer ? "Takes the brush: where you paint on the object this layer shows."
                  : "Takes the brush: where you paint on the object this mask is 1.");
    }

    /// The leaves that the node itself has, or those of a part of it.
    std::vector<RecipeLeaf> leaves_of(const std::string& owner) {
        std::vector<RecipeLeaf> own;
        for (RecipeLeaf& leaf : recipe_leaves(slider_json(context_.session.still())))
            if (leaf.path == owner + "." + leaf.label) own.push_back(std::move(leaf));
        return own;
    }

    /// A half of linear light, as a colour to begin with.
    static constexpr const char* middle_grey = "#bcbcbc";

    /// The number or colour of a constant node, as a parameter.
    static RecipeLeaf constant_leaf(const std::string& path, const Json& value) {
        static constexpr Parameter number{
            "value", ParameterType::number, -1e6, 1e6, 0.05, 1, "", "0", "", "a number"};
        static constexpr Parameter color{"value", ParameterType::color, 0,  0,     0,   1, "", "",
                                         "",      "a colour",           {}, false, true};
        // The two are static, so the pointer owns nothing.
        const Parameter* parameter = value.is_string() ? &color : &number;
        return {path, "constant", "value", {std::shared_ptr<void>(), parameter}, value};
    }

    void parameters(const GraphNodeView& view) {
        ImGui::Separator();
        if (view.type == "constant")
            parameter_rows(context_, {constant_leaf(view.place, view.json)});
        std::vector<RecipeLeaf> leaves = leaves_of(view.place);
        if (leaves.empty()) return;
        for (const ParameterGroup& group : parameter_groups(leaves, {})) {
            parameter_rows(context_, group.first);
            parameter_rows(context_, group.more);
        }
    }

    void terms(const GraphNodeView& view) {
        const std::string place = view.place;
        for (std::size_t i = 0; i < view.terms; ++i) {
            const std::string item = fmt::format("{}.noise.{}", place, i);
            const bool open =
                ImGui::CollapsingHeader(fmt::format("Noise {}##{}", i + 1, item).c_str());
            context_.items.note("term:" + item);
            if (!open) continue;
            if (small_button("up", "term up:" + item, "Adds this noise earlier.") && i > 0)
                return build(
                    [&](const Recipe& recipe) { return move_term(recipe, place, i, i - 1); });
            ImGui::SameLine();
            if (small_button("down", "term down:" + item, "Adds this noise later.") &&
                i + 1 < view.terms)
                return build(
                    [&](const Recipe& recipe) { return move_term(recipe, place, i, i + 1); });
            ImGui::SameLine();
            if (small_button("remove", "term remove:" + item, "Takes this noise away."))
                return build([&](const Recipe& recipe) { return remove_term(recipe, place, i); });
            parameter_rows(context_, leaves_of(item));
        }
        if (button("Add noise", "term add"))
            build([&](const Recipe& recipe) { return add_term(recipe, place, view.terms); });
    }

    /// The layers that lie on one another at a place, the uppermost first.
    void layers(const std::string& place, Wire wire) {
        ImGui::Separator();
        const std::vector<std::string> all = layers_at(context_.session.recipe(), place);
        for (std::size_t i = all.size(); i-- > 0;)
            if (layer(place, all, i)) return;
        ImGui::SetNextItemWidth(0.62f * ImGui::GetContentRegionAvail().x);
        const bool open = ImGui::BeginCombo(
            "##layer", wire == Wire::color ? "Add a layer" : "Add a layer of numbers");
        context_.items.note("layer add");
        tip("Lays another node over what stands here, with an opacity and a mask.");
        if (!open) return;
        for (const char* mode : blend_modes) {
            const bool chosen = ImGui::Selectable(spoken(mode).c_str());
            context_.items.note(fmt::format("layer add={}", mode));
            if (chosen) build([&](const Recipe& recipe) { return add_layer(recipe, place, mode); });
        }
        ImGui::EndCombo();
    }

    /// Draws a layer; returns whether it was moved or removed.
    bool layer(const std::string& place, const std::vector<std::string>& all, std::size_t i) {
        const std::string item = fmt::format("{}", i);
        const auto node = graph_.model().graph().find(all[i]);
        if (!node) return true;
        const Json& json = graph_.model().graph().nodes[*node].json;
        const std::string mode = json.value("mode", "normal");
        if (small_button(fmt::format("layer {}", i + 1), "layer:" + item,
                         "Chooses the layer, with its mode, opacity and mask."))
            graph_.model().choose(all[i]);
        ImGui::SameLine();
        ImGui::TextDisabled("%s", spoken(mode).c_str());
        ImGui::SameLine(0.5f * ImGui::GetContentRegionAvail().x);
        if (small_button("up", "layer up:" + item, "Lays it over the next layer.") &&
            i + 1 < all.size()) {
            build([&](const Recipe& recipe) { return move_layer(recipe, place, i, i + 1); });
            return true;
        }
        ImGui::SameLine();
        if (small_button("down", "layer down:" + item, "Lays it below the next layer.") && i > 0) {
            build([&](const Recipe& recipe) { return move_layer(recipe, place, i, i - 1); });
            return true;
        }
        ImGui::SameLine();
        if (!small_button("remove", "layer remove:" + item, "Takes the layer away.")) return false;
        build([&](const Recipe& recipe) { return remove_layer(recipe, place, i); });
        return true;
    }

    /// An input where no node of its own stands.
    void input(const std::string& place) {
        const auto owner = graph_.model().owner_of(place);
        if (!owner) return nothing();
        const GraphNodeView node = graph_.model().graph().nodes[*owner];
        const auto found = std::ranges::find(node.inputs, place, &GraphInput::place);
        ImGui::TextUnformatted(fmt::format("{} of {}", found->words, node.words).c_str());
        ImGui::TextWrapped("%s", found->tip.c_str());
        if (button("Add a node", "node add")) graph_.open_search(GraphSearch::Purpose::add, place);
        if (found->by_name) {
            ImGui::SameLine();
            if (button("Disconnect", "node disconnect"))
                return build([&](const Recipe& recipe) { return disconnect(recipe, place); });
        }
        std::vector<RecipeLeaf> own;
        for (RecipeLeaf& leaf : recipe_leaves(slider_json(context_.session.still())))
            if (leaf.path == place) own.push_back(std::move(leaf));
        if (own.empty() && !found->constant.is_null()) {
            const bool is_node = place == "texture" || place.starts_with("material.");
            own.push_back(constant_leaf(is_node ? place + ".value" : place, found->constant));
        }
        if (found->wire == Wire::color && found->constant.is_number() && !own.empty()) {
            ImGui::SameLine();
            if (button("As a colour", "node colour"))
                context_.session.set(std::vector{own.front().path + "=" + middle_grey});
        }
        parameter_rows(context_, own);
        layers(place, found->wire);
    }

    void material(const GraphNodeView& view) {
        ImGui::TextUnformatted("The material");
        ImGui::TextWrapped(
            "A channel that is a node varies over the surface; the others are numbers "
            "of the parameters.");
        ImGui::Separator();
        for (const GraphInput& input : view.inputs) {
            if (small_button(input.words, "channel:" + input.key, input.tip.c_str()))
                graph_.model().choose(input.place);
            if (input.key == "base_color") continue;
            ImGui::SameLine(0.62f * ImGui::GetContentRegionAvail().x);
            if (small_button("remove", "channel remove:" + input.key,
                             "Makes the channel one number again."))
                return build(
                    [&](const Recipe& recipe) { return remove_channel(recipe, input.key); });
        }
        add_a_channel(view);
    }

    void add_a_channel(const GraphNodeView& view) {
        ImGui::SetNextItemWidth(0.62f * ImGui::GetContentRegionAvail().x);
        const bool open = ImGui::BeginCombo("##channel", "Add a channel");
        context_.items.note("channel add");
        tip("Makes a channel a node, so that it varies over the surface.");
        if (!open) return;
        std::vector<std::string> channels{"height"};
        for (const std::string_view channel : enum_names<Channel>) channels.emplace_back(channel);
        for (const std::string& channel : channels) {
            if (std::ranges::count(view.inputs, channel, &GraphInput::key) > 0) continue;
            const bool chosen = ImGui::Selectable(spoken(channel).c_str());
            context_.items.note("channel add=" + channel);
            if (chosen) build([&](const Recipe& recipe) { return add_channel(recipe, channel); });
        }
        ImGui::EndCombo();
    }

    const PanelContext& context_;
    EditGraph& graph_;
    const GraphHooks& hooks_;
};

}  // namespace

void node_panel(const PanelContext& context, EditGraph& graph, const GraphHooks& hooks,
                StopSelection& stop) {
    NodePanel(context, graph, hooks).show(stop);
}

}  // namespace burl
