#pragma once
// Synthesis of a texture over an atlas on the host (Carr & Hart 2001, section 5.1): rows in
// parallel, spans packed into cache-sized batches, field then colour then store. The bytes do not
// depend on the thread count.
#include <functional>

#include "atlas/base/image.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/economy.h"
#include "procedural/batch/filter.h"
#include "procedural/batch/kernel.h"
#include "procedural/model/texture.h"

namespace burl {

/// The texture as an image. `texture_from_atlas` maps the SolidAtlas's space to the texture's solid
/// coordinates (the recipe's scale). `threads` 0 means all. `kernel` changes the time, and has an
/// effect only without a filter (or with trapezoid2 without band limit). `economy` decides which
/// work is left out, which changes no byte, and counts work. Texels outside every span get the
/// colour of field 0.
Image<Rgb8> synthesize_rgb8(const SolidAtlas& solid, const Texture& texture,
                            const Affine3& texture_from_atlas, int threads,
                            const Filter& filter = {}, Kernel kernel = Kernel::automatic,
                            const Economy& economy = {});
Image<Rgb16> synthesize_rgb16(const SolidAtlas& solid, const Texture& texture,
                              const Affine3& texture_from_atlas, int threads,
                              const Filter& filter = {}, Kernel kernel = Kernel::automatic,
                              const Economy& economy = {});
Image<RgbF> synthesize_rgbf(const SolidAtlas& solid, const Texture& texture,
                            const Affine3& texture_from_atlas, int threads,
                            const Filter& filter = {}, Kernel kernel = Kernel::automatic,
                            const Economy& economy = {});

/// A callback that takes rows of a texture from `first` on, in order.
using TakeRows = std::function<void(std::size_t first, Image<RgbF> rows)>;

/// The number of rows of which a band has a multiple, except for the last band.
inline constexpr std::size_t band_rows = 16;

/// The texture of synthesize_rgbf in bands of about `texels` texels each, for callers that do not
/// need all of it at a time.
void synthesize_rgbf_bands(const SolidAtlas& solid, const Texture& texture,
                           const Affine3& texture_from_atlas, int threads, const Filter& filter,
                           Kernel kernel, const Economy& economy, std::size_t texels,
                           const TakeRows& take);

/// The field in float32, for tests and error measurements; 0 outside every span.
Image<float> synthesize_field(const SolidAtlas& solid, const Texture& texture,
                              const Affine3& texture_from_atlas, int threads,
                              Kernel kernel = Kernel::automatic, const Economy& economy = {});

}  // namespace burl
