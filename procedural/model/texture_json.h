#pragma once
// The texture as JSON: a tree of nodes, here a color_map over a field (f = quadric + noise).
// docs/reference/recipes.md lists the keys.
#include <span>

#include <nlohmann/json_fwd.hpp>

#include "procedural/batch/parameter.h"
#include "procedural/model/texture.h"

namespace burl {

/// The table of the texture's parameters, in the order of the JSON, with their paths in a recipe.
std::span<const MemberParameter> texture_parameters();

/// Reads the value of a recipe's "texture" key. Keys, types and ranges must have been checked. Keys
/// that are left out have the defaults of the structs; a missing map is black to white.
Texture texture_from_json(const nlohmann::ordered_json& json);

/// JSON that texture_from_json reads back to an equal Texture.
nlohmann::ordered_json texture_to_json(const Texture& texture);

/// The "stops" of a colour map: pairs of a position and "#rrggbb", or "#rrggbbaa" where a stop is
/// transparent.
nlohmann::ordered_json stops_to_json(const std::vector<ColorStop>& stops);

/// The colour written as "#rrggbb", or the first three channels of "#rrggbbaa".
Rgb8 color_from_hex(const std::string& text);
/// The alpha of a colour written as "#rrggbbaa"; 255 for "#rrggbb".
std::uint8_t alpha_from_hex(const std::string& text);
/// The text "#rrggbb" of an opaque colour, "#rrggbbaa" of any other.
std::string color_to_hex(const Rgb8& color, std::uint8_t alpha = 255);

}  // namespace burl
