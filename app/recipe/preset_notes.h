#pragma once
// What the presets are, for people who choose among them by eye: an order in which like stands by
// like, and a sentence each.
#include <span>
#include <string_view>
#include <vector>

namespace burl {

struct PresetNote {
    std::string_view name;   ///< as load_recipe takes it
    std::string_view about;  ///< one sentence
};

/// Every preset once: stone, wood, planets and skies, water and fire, patterns, relief, noise.
std::span<const PresetNote> preset_notes();

/// Those whose name or sentence holds the text, whatever its case; all for none.
std::vector<PresetNote> presets_with(std::string_view text);

}  // namespace burl
