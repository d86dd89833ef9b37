#pragma once
// The images that recipes name: each is read once for every wrap, however many nodes, frames of an
// animation or bakes of a batch look it up, and those of one recipe are bounded together.
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/base/sha256.h"
#include "app/recipe/recipe.h"
#include "procedural/graph/mip_image.h"

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

/// The recipe that has its images' names from the folder of `from`, a file or preset, with the
/// names that lead from the folder of `to` to the same images. Absolute names stay so for images
/// that are not below that folder.
Recipe with_images_for(Recipe recipe, const std::string& from, const std::string& to);

/// Gives all images absolute names, for a file anywhere.
Recipe with_absolute_images(Recipe recipe, const std::string& from);

}  // namespace burl
