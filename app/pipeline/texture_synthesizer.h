#pragma once
// Interface of a synthesizer other than the host, through which the pipeline uses OpenGL without
// linking it.
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/recipe/recipe.h"
#include "atlas/base/image.h"
#include "atlas/build/block_levels.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

/// Image to fill, of any kind of pixel that textures have.
using ImageToFill = std::variant<Image<Rgb8>*, Image<Rgb16>*, Image<RgbF>*>;

/// Fills an atlas with a recipe's texture.
class TextureSynthesizer {
  public:
    virtual ~TextureSynthesizer() = default;

    /// The reason, as a clause, why this synthesizer cannot make the recipe's texture; empty if it
    /// can.
    virtual std::string problem(const Recipe& recipe) const = 0;
    /// Sets `image` to the texture of a recipe whose problem() is empty, as near to the host's as
    /// this synthesizer can. An image of the atlas's size is overwritten in place. `threads` 0
    /// means all.
    virtual void synthesize(const SolidAtlas& solid, const Recipe& recipe, int threads,
                            ImageToFill image) = 0;
    /// The levels 1 to `levels` of a texture in linear light, averaged as by block_levels
    /// (atlas/build/block_levels.h).
    virtual std::vector<Image<RgbF>> levels(const MeshAtlas& atlas, const Image<RgbF>& texture,
                                            std::uint32_t levels) {
        return block_levels(atlas, texture, levels);
    }
    /// Frees all that belongs to the atlas of earlier calls; called before that atlas changes or is
    /// destroyed.
    virtual void forget_atlas() = 0;
    /// The report of all calls so far as JSON: the device, the passes, and seconds per kind of
    /// work.
    virtual nlohmann::ordered_json report() const = 0;
};

}  // namespace burl
