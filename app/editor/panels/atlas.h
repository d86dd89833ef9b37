#pragma once
// What stands around the view of the atlas: the list of modes and the MIP level above it, the
// legend and what the texel under the pointer is below.
#include "app/editor/panels/panels.h"
#include "app/editor/work/view_maker.h"
#include "app/scene/sheet_frame.h"

namespace burl {

struct AtlasViewState {
    bool shown = false;
    SheetMode mode = SheetMode::texture;
    int level = 0;  ///< the finest MIP level that is shown
    SheetFrame frame{};
};

/// `coarsest`: the last level there is. Items are "atlas mode NAME" and "atlas level".
void atlas_controls(const PanelContext& context, AtlasViewState& state, int coarsest);

/// Of the mode; `picture`: what is shown of it, or null; `late`: it is of an earlier texture.
void atlas_legend(SheetMode mode, const SheetPicture* picture, bool late);

/// The texel under a pointer, in level 0.
struct TexelView {
    std::int64_t x = 0, y = 0;
    std::optional<TexelFacts> facts{};
    std::optional<Rgb8> color{};    ///< of the texture
    std::optional<double> error{};  ///< in codes (TextureError)
};
/// In up to three lines; empty: how to point at one.
void atlas_readout(const std::optional<TexelView>& texel);
/// How high legend and readout are together.
float atlas_footer_height();

}  // namespace burl
