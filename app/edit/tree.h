#pragma once
// A recipe's JSON opened for steps of building. Every number or colour that stands in the place of
// a node is a constant node in it, so that all places hold nodes or names of "define"; and what
// controls and keys point at is marked, so that it is found again wherever a step has moved it.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/base/json_text.h"
#include "app/edit/graph_edit.h"
#include "app/edit/marks.h"
#include "atlas/base/json.h"
#include "procedural/graph/table.h"

namespace burl {

/// Whether the value is a node of a type that the table has, rather than a name or anything else.
bool is_node(const Json& value);

/// The type of a node.
const NodeType& type_of(const Json& node);

/// Whether the value is a constant node.
bool is_constant(const Json& value);

/// A colour where a number is wanted: its luminance.
Json luminance_of(Json color);

/// The name of "define" that a place is; empty for any other place.
std::string defined_at(const std::string& place);

/// Throws Error(usage) with the sentence.
[[noreturn]] void refuse_edit(const std::string& sentence);

class RecipeTree {
  public:
    explicit RecipeTree(const Recipe& recipe);

    /// The node or name at a place; null where there is none. Places are "texture", "bump.input",
    /// the channels of "material", the names of "define", and inputs of nodes.
    const Json* find(const std::string& place) const;
    /// The node or name at a place. Throws Error(usage) where there is none.
    Json& at(const std::string& place);
    /// The node or name at a place, or the number or colour of a channel that is left out; null
    /// where there is none.
    Json content(const std::string& place) const;
    /// Puts a node, a name, a number or a colour at a place and returns where it stands: a colour
    /// where a number is wanted stands below a node `split`. Throws Error(usage) for what is no
    /// place.
    std::string put(const std::string& place, Json value);
    /// Puts at a place what stands there while nothing is connected.
    void vacate(const std::string& place);
    /// Keeps the node at a place under a name, since something else takes its place; names and
    /// constants are not kept.
    void keep_under_name(const std::string& place);
    /// Takes a node or a name out of a place, which is vacant then.
    Json take(const std::string& place);

    /// The name or the kind of a node or name, for sentences.
    static std::string called(const Json& value, const std::string& place);

    /// The type that a place takes.
    Wire wanted(const std::string& place) const;
    /// The type that a node or a name gives.
    Wire gives(const Json& value) const;
    /// Whether the place takes what the value gives.
    bool fits(const Json& value, const std::string& place) const;

    /// The nodes of "define" by their names; an empty object where there are none.
    const Json& names() const;
    /// A name that "define" does not have, such as "fbm" or "fbm_2".
    std::string free_name(const std::string& wish) const;
    /// Adds a node under a name that "define" does not have.
    void add_name(const std::string& name, Json node);
    void remove_name(const std::string& name);
    /// Calls visit(place, value) for every place, each before those below it; `visit` may replace
    /// the value, whose own inputs are visited then.
    using Visit = std::function<void(const std::string& place, Json& value)>;
    void visit(const Visit& visit);
    /// The places where a name stands.
    std::vector<std::string> uses(const std::string& name) const;

    /// The edited recipe, with the words and the place of the step; images that it did not have are
    /// read relative to the folder of `origin`. Throws Error(usage) with the sentence of the
    /// recipe's check.
    GraphEdit finish(std::string words, std::string path, const std::string& origin = {});

  private:
    Json& owner_of(const std::string& place, std::string& key);
    void check(std::vector<std::string>& lost);

    const Recipe& recipe_;
    Json tree_;  ///< the recipe without paint
    std::optional<PlaceMarks> marks_;
};

}  // namespace burl
