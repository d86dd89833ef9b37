#pragma once
// Descriptions of the presets for people who choose by eye: one sentence each, in an order that
// puts similar presets side by side.
#include <span>
#include <string_view>
#include <vector>

namespace burl {

struct PresetNote {
    std::string_view name;   ///< the preset's name, as load_recipe takes it
    std::string_view about;  ///< a description of one sentence
};

/// All presets, each once: stone, wood, planets and skies, water and fire, patterns, relief, noise.
std::span<const PresetNote> preset_notes();

/// The presets, then the materials (material_notes.h), whose name or description contains the text,
/// ignoring case; all for an empty text.
std::vector<PresetNote> presets_with(std::string_view text);

}  // namespace burl
