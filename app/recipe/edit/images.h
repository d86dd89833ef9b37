#pragma once
// The images that recipes name. Each is decoded once per wrap mode, however many nodes, frames of
// an animation or bakes of a batch use it; the images of one recipe are bounded in total size.
#include <bit>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/base/json_text.h"
#include "app/base/sha256.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/recipe.h"
#include "atlas/base/named_files.h"
#include "procedural/color/mip_image.h"

namespace burl {

/// The bounds of a recipe's images.
struct ImageLimits {
    /// Where they may lie: without leave anywhere, for the caller's own recipes.
    NamedFiles named = NamedFiles::anywhere;
    /// The largest side of an image, in pixels. A MIP pyramid of 8192 x 8192 takes 0.5 GB, 0.8 GB
    /// where its image is transparent, and 1.1 or 2.1 GB where sides are no powers of two.
    std::size_t side = 8192;

    /// The most texels of all images of a recipe together: two of the largest, all sides rounded up
    /// to powers of two as MIP pyramids have them.
    std::uint64_t texels() const {
        const std::uint64_t rounded = std::bit_ceil(side);
        return 2 * rounded * rounded;
    }
};

/// A cache of decoded images, keyed by real path and wrap mode.
class RecipeImages {
  public:
    explicit RecipeImages(const ImageLimits& asked = {}) : limits(asked) {}

    ImageLimits limits;

    /// The MIP pyramid of a PNG file. Throws Error as read_png does.
    std::shared_ptr<const MipImage> pyramid(const std::string& path, ImageWrap wrap);

    /// Digests of the images, computed from the bytes that were decoded, and of other files asked
    /// for.
    FileDigests& digests() { return digests_; }

    /// Notes what a recipe's file says that the recipe does not hold, and warns of what is new.
    void note_losses(const std::string& path, const std::vector<std::string>& losses);
    /// The losses of the recipe at a path.
    const std::vector<std::string>& losses(const std::string& path) { return losses_[path]; }

  private:
    std::map<std::string, std::vector<std::string>> losses_;
    FileDigests digests_;
    std::map<std::pair<std::string, ImageWrap>, std::shared_ptr<const MipImage>> known_;
};

/// Parses a recipe as parse_recipe (recipe.h) does, with images from the cache, which gains those
/// that it lacks.
Recipe parse_recipe(const std::string& json, const std::string& origin,
                    const std::vector<std::string>& settings, RecipeImages& images);
/// Loads a recipe as load_recipe (recipe.h) does, with images from the cache.
Recipe load_recipe(const std::string& path_or_preset, const std::vector<std::string>& settings,
                   RecipeImages& images);

/// The recipe of JSON that has been checked (check.h) and respelled. Images that `known` has are
/// taken from it, others are read relative to the folder of `origin`, which throws Error as
/// read_png does.
Recipe recipe_of(const Json& tree, const Recipe& known, const std::string& origin);

/// The recipe with its images' paths, which are relative to the folder of `from` (a file or a
/// preset), rewritten relative to the folder of `to`. Absolute paths stay absolute for images that
/// are not below that folder.
Recipe with_images_for(Recipe recipe, const std::string& from, const std::string& to);

/// The recipe with absolute paths of all images, so that it may be stored in any folder.
Recipe with_absolute_images(Recipe recipe, const std::string& from);

}  // namespace burl
