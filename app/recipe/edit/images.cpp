#include "app/recipe/edit/images.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/base/messages.h"
#include "app/image/picture_read.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/real_path.h"

namespace burl {

namespace {

namespace fs = std::filesystem;

/// The real path of the file's folder; that of the working folder for a bare name.
fs::path real_folder(const fs::path& file) {
    return real_path((file.parent_path() / ".").string());
}

bool has_images(const Recipe& recipe) {
    return !recipe.texture.images.empty() || !recipe.bump.input.images.empty();
}

/// The recipe with every image's path replaced by spell(absolute path, path).
template <class Spell>
Recipe with_names(Recipe recipe, const std::string& from, const Spell& spell) {
    const fs::path folder = real_folder(from);
    for (TextureGraph* graph : {&recipe.texture, &recipe.bump.input})
        for (GraphImage& image : graph->images) {
            // Symbolic links of the file itself are kept.
            const fs::path file = folder / image.file;
            image.file = spell(real_folder(file) / file.filename(), image.file).string();
        }
    return recipe;
}

}  // namespace

std::shared_ptr<const MipImage> RecipeImages::pyramid(const std::string& path, ImageWrap wrap) {
    std::shared_ptr<const MipImage>& known = known_[{real_path(path), wrap}];
    if (known) return known;
    const std::vector<std::uint8_t> bytes = read_picture_bytes(path);
    digests_.add(path, bytes);
    const auto pyramid_of = [&](auto&& image) {
        return std::make_shared<const MipImage>(std::forward<decltype(image)>(image), wrap);
    };
    return known = std::visit(pyramid_of, decode_picture(bytes, path));
}

void RecipeImages::note_losses(const std::string& path, const std::vector<std::string>& losses) {
    std::vector<std::string>& known = losses_[path];
    for (const std::string& loss : losses) {
        if (std::ranges::find(known, loss) != known.end()) continue;
        known.push_back(loss);
        warn(loss);
    }
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

Recipe with_images_for(Recipe recipe, const std::string& from, const std::string& to) {
    if (!has_images(recipe)) return recipe;
    const fs::path folder = real_folder(to);
    if (folder == real_folder(from)) return recipe;
    return with_names(std::move(recipe), from, [&](const fs::path& file, const fs::path& name) {
        const fs::path relative = file.lexically_relative(folder);
        return name.is_absolute() && relative.string().starts_with("..") ? name : relative;
    });
}

Recipe with_absolute_images(Recipe recipe, const std::string& from) {
    if (!has_images(recipe)) return recipe;
    return with_names(std::move(recipe), from,
                      [](const fs::path& file, const fs::path&) { return file; });
}

}  // namespace burl
