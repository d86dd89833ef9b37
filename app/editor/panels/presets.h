#pragma once
// The gallery of presets: a thumbnail and a name each; a click opens one.
#include <imgui.h>

#include <functional>
#include <string>

#include "app/editor/panels/panels.h"

namespace burl {

/// Returns a preset's thumbnail, side x side pixels; null: not ready.
using PresetPicture = std::function<ImTextureID(const std::string& preset, int side)>;

/// Draws the gallery; `search` is the text that filters it. Items are "preset:NAME" for every
/// visible preset, and "preset search".
void presets_panel(const PanelContext& context, std::string& search, const PresetPicture& picture);

}  // namespace burl
