#include "app/edit/look.h"

#include <utility>

#include "app/edit/tree.h"
#include "app/recipe/schema_check.h"
#include "procedural/graph/json.h"

namespace burl {

namespace {

/// Puts a node into copies of the nodes around its place that move the point, so that it is
/// evaluated where it stands.
Json at_its_point(const RecipeTree& tree, Json node, const std::string& place) {
    if (const std::string name = defined_at(place); !name.empty()) {
        const std::vector<std::string> uses = tree.uses(name);
        return uses.empty() ? node : at_its_point(tree, std::move(node), uses.front());
    }
    const std::size_t dot = place.rfind('.');
    const Json* owner = dot == std::string::npos ? nullptr : tree.find(place.substr(0, dot));
    if (!owner || !is_node(*owner)) return node;
    if (type_of(*owner).result == NodeResult::inner) {
        Json around = *owner;
        around["input"] = std::move(node);
        node = std::move(around);
    }
    return at_its_point(tree, std::move(node), place.substr(0, dot));
}

}  // namespace

Recipe look_at(const Recipe& recipe, const std::string& place) {
    Recipe bare = recipe;
    bare.paint.clear();
    bare.controls.clear();
    bare.animation = {};
    bare.bump = {};
    bare.material = {};
    if (bare.precision.kind == PrecisionKind::fixed) bare.precision = {};
    RecipeTree tree(bare);
    const RecipeTree whole(recipe);
    const Json* node = whole.find(place);
    if (!node) refuse_edit("nothing stands at \"" + place + "\"");
    for (const std::string_view channel : enum_names<Channel>)
        if (tree.find("material." + std::string(channel)))
            tree.vacate("material." + std::string(channel));
    tree.put("texture", without_marks(at_its_point(whole, *node, place)));
    return tree.finish("", place).recipe;
}

}  // namespace burl
