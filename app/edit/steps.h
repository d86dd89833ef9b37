#pragma once
// Steps of building with single nodes and wires. Each is a pure function from a recipe to another
// one that is valid; it throws Error(usage), with one sentence, where there is none. Places are
// those of a recipe's JSON as it is written: "texture" (the base colour), "bump.input" (the
// height), "material.roughness" and the other channels, "define.NAME", and inputs of nodes, such as
// "texture.top.input". Paths of controls and of keys follow what they point at.
#include <string>
#include <vector>

#include "app/edit/graph_edit.h"

namespace burl {

/// A recipe with nothing built yet: a grey surface, with the atlas, filter and pose of `like`.
Recipe new_recipe(const Recipe& like);

/// Adds the node of a text such as "fbm octaves=2" (node_kinds.h) at a place. What stood there goes
/// into the new node's first fitting input or, where that is a node and there is no such input, is
/// kept under a name. An empty place adds the node under a name that nothing uses. `origin` is the
/// recipe's file: images are named from its folder on.
GraphEdit add_node(const Recipe& recipe, const std::string& place, const std::string& text,
                   const std::string& origin = {});

/// Adds the node of a text under a name that nothing uses, and connects the node at `from` to its
/// first input that fits, as connect does.
GraphEdit add_node_after(const Recipe& recipe, const std::string& from, const std::string& text,
                         const std::string& origin = {});

/// Deletes the nodes at places. The first of a node's inputs that fits takes its place, nodes and
/// names before constants; else the place is vacant. A name of "define" that is left without a node
/// goes, and so do its uses.
GraphEdit delete_nodes(const Recipe& recipe, const std::vector<std::string>& places);

/// Replaces the node at a place by that of a text. Inputs and parameters with the same key are
/// kept, further inputs in their order; nodes that find no input are kept under a name.
GraphEdit replace_node(const Recipe& recipe, const std::string& place, const std::string& text,
                       const std::string& origin = {});

/// Connects the output of the node at `from` to the place `to` as well: the node gets a name, if it
/// has none, that both use. A node that stood there is kept under a name. A colour where a number
/// is wanted goes through its luminance. A circle is refused with the names of its nodes.
GraphEdit connect(const Recipe& recipe, const std::string& from, const std::string& to);

/// Moves the node, or the name, at `from` to the place `to`; `from` is vacant then.
GraphEdit move_node(const Recipe& recipe, const std::string& from, const std::string& to);

/// Makes a place vacant; a node that stood there is kept under a name.
GraphEdit disconnect(const Recipe& recipe, const std::string& place);

/// Gives the node at a place a name of "define", which takes its place; of a node that has one it
/// is another one, for all that use it.
GraphEdit name_node(const Recipe& recipe, const std::string& place, const std::string& name);

/// Puts copies of a named node into all places that use it, and drops the name.
GraphEdit inline_name(const Recipe& recipe, const std::string& name);

/// Names the one node of a set whose result others use.
GraphEdit group_nodes(const Recipe& recipe, const std::vector<std::string>& places,
                      const std::string& name);

/// Makes a channel of the material, or "height", a node that gives what the channel was.
GraphEdit add_channel(const Recipe& recipe, const std::string& channel);
/// Makes a channel what it is by default; nodes that only it uses go with it.
GraphEdit remove_channel(const Recipe& recipe, const std::string& channel);

}  // namespace burl
