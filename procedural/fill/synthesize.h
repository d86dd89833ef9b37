#pragma once
// Synthesis of a texture of the 1999 model over an atlas on the host (Carr & Hart 2001, section
// 5.1): rows in parallel, spans packed into cache-sized batches, field then colour then store. The
// bytes do not depend on the thread count.
#include <functional>

#include "atlas/base/image.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/economy.h"
#include "procedural/batch/filter.h"
#include "procedural/batch/kernel.h"
#include "procedural/batch/row_window.h"
#include "procedural/model/texture.h"

namespace burl {

/// The rows `rows` of the texture as an image of Rgb8, Rgb16 or RgbF. `texture_from_atlas` maps the
/// SolidAtlas's space to the texture's solid coordinates (the recipe's scale). `threads` 0 means
/// all. `kernel` changes the time, and has an effect only without a filter (or with trapezoid2
/// without band limit). `economy` decides which work is left out, which changes no byte, and counts
/// work. Texels outside every span get the colour of field 0.
template <class Pixel>
Image<Pixel> synthesize_model(const SolidAtlas& solid, const Texture& texture,
                              const Affine3& texture_from_atlas, int threads,
                              const Filter& filter = {}, Kernel kernel = Kernel::automatic,
                              const Economy& economy = {}, const RowWindow& rows = {});

/// A callback that takes rows of a texture from `first` on, in order.
using TakeRows = std::function<void(std::size_t first, Image<RgbF> rows)>;

/// Gives the texture of synthesize_model to `take` in bands of `rows` rows, the last of fewer; the
/// filter's tables are made once.
void synthesize_model_in_bands(const SolidAtlas& solid, const Texture& texture,
                               const Affine3& texture_from_atlas, int threads, const Filter& filter,
                               Kernel kernel, const Economy& economy, std::size_t rows,
                               const TakeRows& take);

/// The field in float32, for tests and error measurements; 0 outside every span.
Image<float> synthesize_field(const SolidAtlas& solid, const Texture& texture,
                              const Affine3& texture_from_atlas, int threads,
                              Kernel kernel = Kernel::automatic, const Economy& economy = {});

}  // namespace burl
