#pragma once
// New colours of a cached field (procedural/kept/kept.h).
#include "atlas/base/image.h"
#include "procedural/batch/economy.h"
#include "procedural/color/map.h"
#include "procedural/kept/rows.h"

namespace burl {

/// Parameters of recolouring: the layout of the cached numbers, the image's side in texels, and the
/// threads (0: all).
struct RecolorTask {
    const KeptRows& rows;
    std::size_t size = 0;
    int threads = 0;
    const Economy& economy;
};

/// Sets `image` to the unfiltered colours of the cached f, with the bytes of synthesize_model.
/// Defined for Rgb8, Rgb16 and RgbF.
template <class Pixel>
void recolor_field(const RecolorTask& task, const ColorMap& map, const double* field,
                   Image<Pixel>& image);
/// Sets `image` to the unfiltered colours of the cached f from its entries in the colour table
/// (procedural/color/table.h); `places` are computed first if they are not `known`.
void recolor_places(const RecolorTask& task, const ColorMap& map, const double* field, bool known,
                    std::int32_t* places, Image<Rgb8>& image);

}  // namespace burl
