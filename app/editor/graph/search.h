#pragma once
// The box that opens over the graph to name a node: a search over the table of nodes, each with its
// sentence, and over the names of the recipe.
#include <imgui.h>

#include <optional>
#include <string>
#include <vector>

#include "app/editor/widgets/items.h"

namespace burl {

/// The search box. All functions are called by the user interface's thread.
class GraphSearch {
  public:
    /// The use that is made of the choice.
    enum class Purpose {
        add,
        replace,
        after  ///< a node that goes on with the one at the place
    };
    struct Wish {
        Purpose purpose = Purpose::add;
        std::string place{};               ///< empty: a node for later
        std::vector<std::string> names{};  ///< of "define", which may be connected
    };
    /// The choice: the text of a node, as new_node takes it, or a name.
    struct Choice {
        Wish wish{};
        std::string text{};
        bool is_name = false;
    };

    /// Opens the box with its corner at `at`; `title` says what it is for.
    void open(Wish wish, std::string title, const ImVec2& at);
    bool is_open() const { return open_; }
    void close() { open_ = false; }
    /// Draws the box; returns the choice in the frame in which it is made. Items are "graph search"
    /// and "graph found:NAME".
    std::optional<Choice> show(EditItems& items);

  private:
    struct Row {
        std::string name, about;
        bool is_name = false;
    };
    std::vector<Row> rows() const;
    std::optional<Choice> list(EditItems& items, const std::vector<Row>& found, bool entered);
    Choice choice(const Row& row) const;

    Wish wish_;
    std::string title_, text_;
    ImVec2 at_{};
    std::size_t marked_ = 0;
    bool open_ = false, begins_ = false;
};

}  // namespace burl
