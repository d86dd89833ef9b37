#pragma once
// Descriptions of the presets for people who choose by eye: one sentence each, in an order that
// puts similar presets side by side.
#include <span>
#include <string_view>

namespace burl {

struct PresetNote {
    std::string_view name;   ///< the preset's name, as load_recipe takes it
    std::string_view about;  ///< a description of one sentence
};

/// All presets, each once: stone, wood, planets and skies, water and fire, patterns, relief, noise.
std::span<const PresetNote> preset_notes();

/// Whether a name or description contains a part that somebody searches for, ignoring case; every
/// text contains an empty part.
bool holds_text(std::string_view text, std::string_view part);

}  // namespace burl
