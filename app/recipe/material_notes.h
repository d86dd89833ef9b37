#pragma once
// Descriptions of the materials for people who choose by eye, as the materials themselves have
// them.
#include <array>
#include <span>
#include <string>
#include <string_view>

namespace burl {

struct MaterialNote {
    std::string name;   ///< the material's name, as load_recipe takes it
    std::string group;  ///< one of material_groups
    std::string about;  ///< a description of one sentence
};

/// The groups of our materials, in the order in which they are shown.
inline constexpr std::array<std::string_view, 7> material_groups{
    "wood", "stone", "gem", "metal", "earth", "glaze", "organic"};

/// All materials, each once, by group and name.
std::span<const MaterialNote> material_notes();

}  // namespace burl
