#include "app/edit/circle.h"

#include <set>
#include <vector>

#include <fmt/format.h>

#include "app/recipe/schema_check.h"
#include "procedural/graph/json.h"

namespace burl {

namespace {

/// The way from a node down to another one through inputs and names.
class WayDown {
  public:
    WayDown(const RecipeTree& tree, std::string target) : tree_(tree), target_(std::move(target)) {}

    /// Whether the node at a place is the target or made of it; then `names` has the nodes between.
    bool find(const std::string& place) {
        const Json* value = tree_.find(place);
        if (!value) return false;
        if (is_graph_name(*value)) return find("define." + value->get<std::string>());
        if (!is_node(*value) || !seen_.insert(place).second) return false;
        names.push_back(RecipeTree::called(*value, place));
        if (place == target_) return true;
        for (const NodeInput& input : type_of(*value).inputs())
            if (find(join_path(place, input.key))) return true;
        names.pop_back();
        return false;
    }

    std::vector<std::string> names;

  private:
    const RecipeTree& tree_;
    std::string target_;
    std::set<std::string> seen_;
};

}  // namespace

void refuse_circle(const RecipeTree& tree, const std::string& from, const std::string& to) {
    const std::size_t dot = to.rfind('.');
    if (dot == std::string::npos) return;
    WayDown way(tree, to.substr(0, dot));
    if (!way.find(from)) return;
    refuse_edit(fmt::format("that makes a circle: {} uses {}; take another input",
                            fmt::join(way.names, " uses "), way.names.front()));
}

}  // namespace burl
