#pragma once
// A recipe's texture on the host, by whichever of its ways the recipe asks for: the fast one for
// the 1999 model, another arithmetic texel by texel, forward differences, or a graph of nodes.
#include "app/recipe/recipe.h"
#include "atlas/base/image.h"
#include "procedural/batch/economy.h"
#include "procedural/batch/kernel.h"
#include "procedural/fill/synthesize.h"

namespace burl {

/// How the host works; nothing of it but `forward` changes the result.
struct HostWay {
    int threads = 0;  ///< 0: all
    Kernel kernel = Kernel::automatic;
    /// By forward differences, in the recipe's precision or else float64; check_forward
    /// (app/recipe/forward_check.h) must let the recipe pass.
    bool forward = false;
    bool operator==(const HostWay&) const = default;
};

/// Everything of a recipe that a texture of a given atlas depends on, but for the paint over it.
struct TextureKey {
    SolidOptions solid{};
    Texture texture{};
    TextureGraph graph{};
    Filter filter{};
    Precision precision{};
    explicit TextureKey(const Recipe& recipe)
        : solid(recipe.solid),
          texture(recipe.texture),
          graph(recipe.graph),
          filter(recipe.filter),
          precision(recipe.precision) {}
    bool operator==(const TextureKey&) const = default;
};

/// The atlas's colours; `solid` is in the recipe's space. For Rgb8, Rgb16 and RgbF.
template <class Pixel>
Image<Pixel> fill_texture(const SolidAtlas& solid, const Recipe& recipe, const HostWay& way,
                          const Economy& economy = {});
/// The same without the recipe's paint.
template <class Pixel>
Image<Pixel> fill_unpainted(const SolidAtlas& solid, const Recipe& recipe, const HostWay& way,
                            const Economy& economy = {});

/// The texture in linear light, without paint, in bands as synthesize_rgbf_bands gives them.
void fill_in_bands(const SolidAtlas& solid, const Recipe& recipe, const HostWay& way,
                   const Economy& economy, std::size_t texels, const TakeRows& take);

/// Whether it is the 1999 model in float32 by its fast way, whose parts can be kept
/// (procedural/kept/kept.h).
bool has_fast_way(const Recipe& recipe, const HostWay& way);
/// Whether it is a graph in float32.
bool has_fast_graph(const Recipe& recipe, const HostWay& way);

}  // namespace burl
