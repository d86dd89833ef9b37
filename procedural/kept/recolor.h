#pragma once
// New colours of a field that is kept (synthesize_kept.h).
#include "atlas/base/image.h"
#include "procedural/batch/economy.h"
#include "procedural/color/map.h"
#include "procedural/kept/rows.h"

namespace burl {

/// The texels whose numbers lie in `rows`, of an image of `size` x `size`.
struct RecolorTask {
    const KeptRows& rows;
    std::size_t size = 0;
    int threads = 0;
    const Economy& economy;
};

/// Colours of f, unfiltered, as synthesize_rgb8 and its like have them; for Rgb8, Rgb16 and RgbF.
template <class Pixel>
void recolor_field(const RecolorTask& task, const ColorMap& map, const double* field,
                   Image<Pixel>& image);
/// The same from f's places (color_table.h), which are written first where they are not `known`.
void recolor_places(const RecolorTask& task, const ColorMap& map, const double* field, bool known,
                    std::int32_t* places, Image<Rgb8>& image);

}  // namespace burl
