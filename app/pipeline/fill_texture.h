#pragma once
// Synthesis of a recipe's texture on the host: chooses among the vectorised 1999 model, other
// arithmetic texel by texel, forward differences and graphs of nodes.
#include "app/recipe/recipe.h"
#include "atlas/base/image.h"
#include "procedural/batch/economy.h"
#include "procedural/batch/kernel.h"
#include "procedural/batch/row_window.h"
#include "procedural/fill/mask_images.h"
#include "procedural/fill/synthesize.h"

namespace burl {

/// Options of synthesis on the host. No result depends on `threads`; kernels differ by rounding at
/// most (procedural/batch/kernel.h).
struct HostWay {
    int threads = 0;  ///< number of threads; 0: all
    Kernel kernel = Kernel::automatic;
    /// Whether octaves are evaluated by forward differences, in the recipe's precision or else
    /// float64; the recipe must pass check_forward.
    bool forward = false;
    bool operator==(const HostWay&) const = default;
};

/// Cache key of an unpainted texture on a given atlas: all parts of the recipe that it depends on.
struct TextureKey {
    SolidOptions solid{};
    TextureGraph texture;
    Filter filter{};
    Precision precision{};
    std::vector<PaintStroke> mask_paint;
    explicit TextureKey(const Recipe& recipe)
        : solid(recipe.solid),
          texture(recipe.texture),
          filter(recipe.filter),
          precision(recipe.precision),
          mask_paint(mask_strokes(recipe.paint)) {}
    bool operator==(const TextureKey&) const = default;
};

/// The recipe's texture with its paint on the atlas `solid`, which is in the recipe's space.
/// `masks` has an image for each mask that the base colour reads, else Error(unsupported) is
/// thrown. Defined for Rgb8, Rgb16 and RgbF (linear light).
template <class Pixel>
Image<Pixel> fill_texture(const SolidAtlas& solid, const Recipe& recipe, const HostWay& way,
                          const Economy& economy = {}, const MaskImages& masks = {});
/// The rows `rows` of the recipe's texture without its paint. Defined for Rgb8, Rgb16 and RgbF.
template <class Pixel>
Image<Pixel> fill_unpainted(const SolidAtlas& solid, const Recipe& recipe, const HostWay& way,
                            const Economy& economy = {}, const RowWindow& rows = {},
                            const MaskImages& masks = {});

/// The number of rows of which a band has a multiple, except for the last band.
inline constexpr std::size_t band_rows = 16;

/// Gives the texture in linear light, without paint, to `take` in bands of about `texels` texels,
/// for callers that do not need all of it at a time.
void fill_in_bands(const SolidAtlas& solid, const Recipe& recipe, const HostWay& way,
                   const Economy& economy, const MaskImages& masks, std::size_t texels,
                   const TakeRows& take);

/// Whether the texture is filled in float32 without forward differences: CachedSynthesis can cache
/// it if it is plain (procedural/cache/synthesis.h), and CachedGraph some others
/// (procedural/cache/graph.h).
bool has_fast_way(const Recipe& recipe, const HostWay& way);

/// Throws Error(usage) where the recipe's texture is not a polynomial between cell crossings
/// (procedural/bresenham), has a filter, or asks for fixed-point arithmetic: the kernel `forward`
/// would make another texture.
void check_forward(const Recipe& recipe);

}  // namespace burl
