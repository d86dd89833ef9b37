#pragma once
// The gallery of presets: a ball and a name each; a click opens one.
#include <imgui.h>

#include <functional>
#include <string>

#include "app/editor/panels/panels.h"

namespace burl {

/// A preset's ball, side x side pixels; null: not ready.
using PresetPicture = std::function<ImTextureID(const std::string& preset, int side)>;

/// `search`: what a person typed to see fewer. Notes "preset:NAME" for every one in sight, and
/// "preset search".
void presets_panel(const PanelContext& context, std::string& search, const PresetPicture& picture);

}  // namespace burl
