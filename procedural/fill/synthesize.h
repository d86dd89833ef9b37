#pragma once
// Fills an atlas with the texture on the host (Carr & Hart 2001, section 5.1): rows in parallel,
// spans packed into cache-sized batches, field then colour then store. The bytes do not depend on
// the thread count.
#include <functional>

#include "atlas/base/image.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/economy.h"
#include "procedural/batch/filter.h"
#include "procedural/batch/kernel.h"
#include "procedural/model/texture.h"

namespace burl {

/// `texture_from_atlas` maps the SolidAtlas's space to the texture's solid coordinates (the
/// recipe's scale). `threads` 0 means all. `kernel` changes the time only, and only where there is
/// no filter (or trapezoid2 without band limit). `economy` says what may be left out, which no byte
/// shows, and counts. Texels outside every span get the colour of field 0.
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

/// Takes rows of a texture from `first` on, in order.
using TakeRows = std::function<void(std::size_t first, Image<RgbF> rows)>;

/// Bands have a multiple of this many rows, but for the last.
inline constexpr std::size_t band_rows = 16;

/// The texture of synthesize_rgbf in bands of about so many texels each, for those who need not
/// have it all at a time.
void synthesize_rgbf_bands(const SolidAtlas& solid, const Texture& texture,
                           const Affine3& texture_from_atlas, int threads, const Filter& filter,
                           Kernel kernel, const Economy& economy, std::size_t texels,
                           const TakeRows& take);

/// The field itself, for tests and error measurements.
Image<float> synthesize_field(const SolidAtlas& solid, const Texture& texture,
                              const Affine3& texture_from_atlas, int threads,
                              Kernel kernel = Kernel::automatic, const Economy& economy = {});

}  // namespace burl
