#pragma once
// Steps with the lists of a graph: noise terms of fields, and layers that lie on one another.
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "app/edit/graph_edit.h"

namespace burl {

/// Adds a noise term to the field at a place, at an index up to the number of its terms; the last
/// term, or where there is none perlin noise, is what it begins as, with another seed.
GraphEdit add_term(const Recipe& recipe, const std::string& field, std::size_t index);
GraphEdit remove_term(const Recipe& recipe, const std::string& field, std::size_t index);
/// Moves a term to another index.
GraphEdit move_term(const Recipe& recipe, const std::string& field, std::size_t from,
                    std::size_t to);

/// The layers at a place from the lowest up: nodes `blend` and `layer_over`, each the base of the
/// next one. Empty where something else stands there.
std::vector<std::string> layers_at(const Recipe& recipe, const std::string& place);

/// Adds a layer on top of what is at a place, a node `blend` of that mode whose opacity is 1.
GraphEdit add_layer(const Recipe& recipe, const std::string& place, std::string_view mode);
/// Takes a layer, by its index from the lowest one on, out of those at a place.
GraphEdit remove_layer(const Recipe& recipe, const std::string& place, std::size_t index);
/// Moves a layer to another index.
GraphEdit move_layer(const Recipe& recipe, const std::string& place, std::size_t from,
                     std::size_t to);

}  // namespace burl
