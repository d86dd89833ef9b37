#include "app/recipe_images.h"

#include "app/image_io.h"
#include "app/real_path.h"

namespace burl {

std::shared_ptr<const MipImage> RecipeImages::pyramid(const std::string& path, ImageWrap wrap) {
    std::shared_ptr<const MipImage>& known = known_[{real_path(path), wrap}];
    if (known) return known;
    const std::vector<std::uint8_t> bytes = read_png_bytes(path);
    digests_.add(path, bytes);
    return known = std::make_shared<const MipImage>(decode_png(bytes, path), wrap);
}

Recipe parse_recipe(const std::string& json, const std::string& origin,
                    const std::vector<std::string>& settings) {
    RecipeImages images;
    return parse_recipe(json, origin, settings, images);
}

Recipe load_recipe(const std::string& path_or_preset, const std::vector<std::string>& settings) {
    RecipeImages images;
    return load_recipe(path_or_preset, settings, images);
}

}  // namespace burl
