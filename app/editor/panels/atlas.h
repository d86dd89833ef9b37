#pragma once
// The controls around the view of the atlas: mode and MIP level above it, the legend and the facts
// of the texel under the pointer below.
#include "app/editor/jobs/view_maker.h"
#include "app/editor/panels/panels.h"
#include "app/scene/sheet_frame.h"

namespace burl {

/// The state of the atlas view.
struct AtlasViewState {
    bool shown = false;
    SheetMode mode = SheetMode::texture;
    int level = 0;  ///< finest MIP level shown
    SheetFrame frame{};
};

/// Draws the controls; `coarsest` is the texture's last MIP level. Items are "atlas mode NAME" and
/// "atlas level".
void atlas_controls(const PanelContext& context, AtlasViewState& state, int coarsest);

/// Draws the mode's legend. `picture`: the picture shown; null: none. `late`: whether it belongs to
/// an earlier texture.
void atlas_legend(SheetMode mode, const SheetPicture* picture, bool late);

/// A texel at level 0, and its values.
struct TexelView {
    std::int64_t x = 0, y = 0;
    std::optional<TexelFacts> facts{};
    std::optional<Rgb8> color{};    ///< colour in the texture
    std::optional<double> error{};  ///< error in sRGB codes (TextureError)
};
/// Draws up to three lines about a texel; empty: a hint how to point at one.
void atlas_readout(const std::optional<TexelView>& texel);
/// The height of legend and readout together, in screen coordinates.
float atlas_footer_height();

}  // namespace burl
