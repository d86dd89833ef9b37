#pragma once
// The graph's window: nodes with pictures of what they give, wires, and a tree of the same for
// keyboards. Whatever is built is one step of the session.
#include <imgui.h>

#include <functional>
#include <string>
#include <vector>

#include "app/editor/graph/model.h"
#include "app/editor/graph/search.h"
#include "app/editor/panels/panels.h"

namespace burl {

/// The services that the graph needs of the program around it.
struct GraphHooks {
    /// The picture of a node; null: none is ready.
    std::function<ImTextureID(const GraphNodeView& node)> picture{};
    std::function<std::string()> clipboard{};
    std::function<void(const std::string& text)> set_clipboard{};
    /// Shows what the node at a place gives on the object; an empty place ends that.
    std::function<void(const std::string& place)> look{};
    /// Takes the brush, which then paints into a layer of paint.
    std::function<void(int layer)> paint{};
    std::string looking_at{};  ///< place of the node that the object shows; empty: none
};

/// The graph's window. All functions are called by the user interface's thread.
class EditGraph {
  public:
    bool shown = false;

    /// Follows the recipe, at the beginning of a frame.
    void follow(EditSession& session) { model_.follow(session); }
    /// Draws the window at the place set for ImGui's next window.
    void window(const PanelContext& context, const GraphHooks& hooks);
    /// Handles the graph's keys while its window has the focus; returns whether one was pressed,
    /// which then means nothing else.
    bool shortcuts(const PanelContext& context, const GraphHooks& hooks);
    /// Whether the box to name a node is open, which takes the keyboard.
    bool searching() const { return shown && search_.is_open(); }
    /// Whether the window has the keyboard's focus.
    bool focused() const { return shown && focused_; }

    const GraphModel& model() const { return model_; }
    GraphModel& model() { return model_; }
    /// The places of nodes whose pictures are seen.
    const std::vector<std::string>& seen() const { return seen_; }

    // What keys, menus and buttons do with what is chosen.
    void build(EditSession& session, const std::function<GraphEdit(const Recipe&)>& edit);
    void open_search(GraphSearch::Purpose purpose, const std::string& place);
    void erase(EditSession& session);
    void copy(EditSession& session, const GraphHooks& hooks);
    void paste(EditSession& session, const GraphHooks& hooks);
    void group(EditSession& session);
    void look(const GraphHooks& hooks);
    /// Takes the brush for the mask of a node `paint`, or for that of a layer `blend`, which gets a
    /// new one where its mask is another node.
    void paint(EditSession& session, const GraphHooks& hooks, const std::string& place);

  private:
    /// The effect of a drag on the canvas.
    enum class Grip { none, pan, frame, wire_from, wire_to };
    /// A canvas in one frame.
    struct Canvas {
        Vec2d low{0.0}, size{0.0};
        double scale = 1.0;  ///< the interface's
        bool hovered = false;
    };

    // graph.cpp: the window
    void canvas(const PanelContext& context, const GraphHooks& hooks, Canvas canvas);
    void take(EditSession& session, const GraphSearch::Choice& chosen);
    void menu(const PanelContext& context, const GraphHooks& hooks);
    // graph_draw.cpp: nodes and wires
    void draw(const Canvas& canvas, const GraphHooks& hooks, EditItems& items);
    void draw_drag(const Canvas& canvas);
    void tell_about(const Canvas& canvas);
    // graph_hand.cpp: the pointer
    void hand(const PanelContext& context, const GraphHooks& hooks, const Canvas& canvas);
    void press(const Canvas& canvas, const Vec2d& at);
    void drop(EditSession& session, const Canvas& canvas, const Vec2d& at);
    void drop_wire(EditSession& session, const Canvas& canvas, const Vec2d& at);
    std::string node_under(const Canvas& canvas, const Vec2d& at) const;
    std::string input_under(const Canvas& canvas, const Vec2d& at) const;
    std::string output_under(const Canvas& canvas, const Vec2d& at) const;
    // graph_tree.cpp: the tree
    void tree(EditItems& items);
    void tree_row(EditItems& items, const std::string& place, const std::string& words, int depth);
    void input_row(EditItems& items, const GraphInput& input, int depth);
    void step_tree(int by);
    void fold(bool open);

    GraphModel model_;
    GraphSearch search_;
    Grip grip_ = Grip::none;
    Vec2d pressed_at_{0.0};
    std::string held_;  ///< place of the node or input that a wire is drawn from
    bool moved_ = false;
    std::vector<std::string> seen_;
    std::vector<std::string> rows_;    ///< places of the tree's rows, from above
    std::vector<std::string> folded_;  ///< places whose rows below are hidden
    std::string rested_on_;            ///< what the pointer is over
    double rested_since_ = 0.0;
    Vec2d canvas_size_{1.0};
    ImVec2 search_at_{};
    bool focused_ = false, wants_focus_ = false, show_chosen_ = false, search_was_open_ = false,
         scroll_to_row_ = false;
};

/// Draws the node that is chosen: its sentence, its name, its parameters and lists, and buttons.
void node_panel(const PanelContext& context, EditGraph& graph, const GraphHooks& hooks,
                StopSelection& stop);

}  // namespace burl
