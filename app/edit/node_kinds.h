#pragma once
// The nodes that a person can add to a graph: families, a search by words, new nodes with all that
// they need, and which of their inputs goes on with what stood in their place.
#include <string>
#include <string_view>
#include <vector>

#include "app/base/json_text.h"
#include "atlas/base/json.h"
#include "procedural/graph/table.h"

namespace burl {

/// The families of the node table, in its order; the nodes of Blender's and MaterialX's functions
/// count as noise.
enum class NodeFamily { number, color, channel, pattern, tile, noise, mask, point };
template <>
inline constexpr auto enum_names<NodeFamily> = enum_words("numbers", "colours", "channels",
                                                          "patterns", "tiles", "noise", "masks",
                                                          "points");

/// The family of a type of the table.
NodeFamily family_of(const NodeType& type);

/// A type's or key's name as people read it: with spaces, and colour for color.
std::string spoken(std::string_view name);

/// The types whose name or description has every word of the text, ignoring case: first those whose
/// name begins with it, then those whose name holds it, then the others, each in the table's order.
/// A word after the first that has "=" is a setting and counts for nothing. "field", which needs a
/// list of terms, is among them, "constant" as well.
std::vector<const NodeType*> nodes_with(std::string_view text);

/// The inputs of a type, those first that go on with what stands in the node's place.
std::vector<const NodeInput*> leading_inputs(const NodeType& type);

/// The value that an input has where nothing is connected: its default, or what changes least.
Json vacant_input(const NodeType& type, const NodeInput& input);

/// A node of JSON that is complete but for its optional parameters.
struct NewNode {
    Json json;
    std::vector<std::string> given;  ///< keys that the text gives
};

/// The node of a text such as "fbm octaves=2 seed=7": a type's name, then settings of its keys with
/// JSON values or words. Throws Error(usage) for an unknown name, with the nearest one; the values
/// are left to the recipe's check.
NewNode new_node(const std::string& text);

}  // namespace burl
