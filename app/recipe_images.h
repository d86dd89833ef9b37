#pragma once
// The images that recipes name: each is read once however many nodes, frames of an animation or
// bakes of a batch look it up, and those of one recipe are bounded together.
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/recipe.h"
#include "app/sha256.h"
#include "procedural/mip_image.h"

namespace burl {

/// A pyramid of this side takes 1 GB.
inline constexpr std::size_t largest_image_side = 8192;
/// The bound on all images of a recipe together, their sides rounded up to powers of two as
/// pyramids have them.
inline constexpr std::uint64_t most_image_texels = 2 * largest_image_side * largest_image_side;

class RecipeImages {
  public:
    /// The pyramid of a PNG file. Throws Error as read_png does.
    std::shared_ptr<const MipImage> pyramid(const std::string& path, ImageWrap wrap);

    /// Digests of the images, taken of the bytes that were decoded, and of what else is asked for.
    FileDigests& digests() { return digests_; }

  private:
    FileDigests digests_;
    std::map<std::pair<std::string, ImageWrap>, std::shared_ptr<const MipImage>> known_;
};

/// parse_recipe and load_recipe with images that may have been read before; new ones are added.
Recipe parse_recipe(const std::string& json, const std::string& origin,
                    const std::vector<std::string>& settings, RecipeImages& images);
Recipe load_recipe(const std::string& path_or_preset, const std::vector<std::string>& settings,
                   RecipeImages& images);

}  // namespace burl
