#pragma once
// What the graph's window shows: the nodes of the recipe with their places, what is chosen of them,
// and the part of the plane that is seen.
#include <imgui.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/edit/graph_layout.h"
#include "app/edit/node_graph.h"
#include "app/editor/session/session.h"

namespace burl {

// Sizes of a node at zoom 1 and interface scale 1.
inline constexpr double node_width = 150.0, node_title = 22.0, node_row = 17.0, node_ball = 46.0;

/// The part of the plane of nodes that a canvas shows.
struct GraphCamera {
    Vec2d offset{0.0};  ///< point of the plane in the canvas's upper left corner
    double zoom = 1.0;  ///< pixels per unit of the plane

    Vec2d screen(const Vec2d& point, const Vec2d& low) const {
        return low + (point - offset) * zoom;
    }
    Vec2d plane(const Vec2d& pixel, const Vec2d& low) const {
        return offset + (pixel - low) / zoom;
    }
};

/// A line of a node: an input, or a parameter that is not what it is by default.
struct NodeLine {
    std::string words;
    Json value{};       ///< null where a wire ends
    bool name = false;  ///< whether the value is the name of the node that the wire comes from
};
/// The lines of a node, its inputs first; of the material one more, to add a channel.
std::vector<NodeLine> lines_of(const NodeGraph& graph, const GraphNodeView& node);

/// The nodes, and what is chosen of them. All functions are called by the user interface's thread.
class GraphModel {
  public:
    /// Follows the session's recipe: nodes that are gone are chosen no more, and the one chosen
    /// last stays where it is on the canvas. Returns whether the recipe is another one than in the
    /// last call.
    bool follow(EditSession& session);

    const NodeGraph& graph() const { return graph_; }
    const Vec2d& place(std::size_t node) const { return layout_.places[node]; }
    const std::vector<GraphPart>& parts() const { return layout_.parts; }
    const NodeBox& box(std::size_t node) const { return boxes_[node]; }
    const std::vector<NodeLine>& lines(std::size_t node) const { return lines_[node]; }

    /// The places chosen, of nodes or inputs, the last one last.
    const std::vector<std::string>& chosen() const { return chosen_; }
    /// The place chosen last; empty: none.
    std::string current() const { return chosen_.empty() ? "" : chosen_.back(); }
    bool is_chosen(const std::string& place) const;
    /// Chooses a place alone; an empty one: nothing.
    void choose(const std::string& place);
    /// Adds a place to what is chosen, or takes it away.
    void toggle(const std::string& place);
    void choose_all(std::vector<std::string> places) { chosen_ = std::move(places); }
    /// Whether a node or an input has the place.
    bool has(const std::string& place) const;
    /// The node at a place, or the one whose wire ends there.
    std::optional<std::size_t> node_at(const std::string& place) const;
    /// The node that has an input with that place.
    std::optional<std::size_t> owner_of(const std::string& place) const;

    /// Moves the camera over a canvas of `size` pixels, `scale` being the interface's, to all
    /// nodes; unless `all` is asked for, to the end at the material where all would be too small.
    void fit(const Vec2d& size, double scale, bool all);
    /// Moves the camera so that the node at a place is seen.
    void show(const std::string& place, const Vec2d& size);

    GraphCamera camera;
    /// Whether the camera fits what is built, until a hand moves it.
    bool follows_layout = true;
    /// Whether the layout is another one since the last fit().
    bool wants_fit() const { return new_layout_ && follows_layout; }

  private:
    void lay_out();
    std::optional<Vec2d> anchor() const;

    NodeGraph graph_;
    GraphLayout layout_;
    std::vector<NodeBox> boxes_;
    std::vector<std::vector<NodeLine>> lines_;
    std::vector<std::string> chosen_;
    std::optional<std::uint64_t> revision_;
    std::uint64_t document_ = 0;
    double time_ = 0.0;
    bool new_layout_ = true;
};

}  // namespace burl
