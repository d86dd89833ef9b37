#pragma once
// Another way than the host's to fill an atlas with a recipe's texture, which the pipeline is given
// without knowing what it is made of (OpenGL, which only the program links).
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

/// An image to fill, of one of the kinds of pixels that textures have.
using ImageToFill = std::variant<Image<Rgb8>*, Image<Rgb16>*, Image<RgbF>*>;

class TextureSynthesizer {
  public:
    virtual ~TextureSynthesizer() = default;

    /// What it cannot make of the recipe, as a clause; empty where it can make all.
    virtual std::string problem(const Recipe& recipe) const = 0;
    /// The texture of a recipe without problem(), as near to the host's as the way allows. An image
    /// of the atlas's size is written over. `threads` 0 means all.
    virtual void synthesize(const SolidAtlas& solid, const Recipe& recipe, int threads,
                            ImageToFill image) = 0;
    /// Levels 1 to `levels` of a texture in linear light, as block_levels
    /// (atlas/build/block_levels.h).
    virtual std::vector<Image<RgbF>> levels(const MeshAtlas& atlas, const Image<RgbF>& texture,
                                            std::uint32_t levels) {
        return block_levels(atlas, texture, levels);
    }
    /// The atlas of the calls before is about to change or go away.
    virtual void forget_atlas() = 0;
    /// What all calls so far did: what by, passes, and seconds by what they went into.
    virtual nlohmann::ordered_json report() const = 0;
};

}  // namespace burl
