#include "app/scene/gltf_textures.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <tuple>

#include "app/image/picture_coding.h"
#include "app/image/picture_read.h"
#include "atlas/base/error.h"
#include "atlas/file/text_scanner.h"
#include "atlas/gltf/container.h"

namespace burl {

namespace {

TextureFilter filter_of(const tinygltf::Sampler& sampler) {
    switch (sampler.minFilter) {
        case TINYGLTF_TEXTURE_FILTER_NEAREST:
            return TextureFilter::nearest;
        case TINYGLTF_TEXTURE_FILTER_LINEAR:
            return TextureFilter::linear;
        case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
        case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST:
        case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR:
        case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR:
            return TextureFilter::mip;
        default:
            break;
    }
    return sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST ? TextureFilter::nearest
                                                                : TextureFilter::linear;
}

TextureWrap wrap_of(int wrap) {
    if (wrap == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return TextureWrap::clamp;
    return wrap == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? TextureWrap::mirror
                                                         : TextureWrap::repeat;
}

}  // namespace

/// The number of the texture's image, which EXT_texture_webp may give; -1 without one.
int GltfTextures::source_of(int number) const {
    const tinygltf::Texture& texture = model_.textures[std::size_t(number)];
    const auto webp = texture.extensions.find(webp_extension);
    if (texture.source >= 0 || webp == texture.extensions.end()) return texture.source;
    const tinygltf::Value& source = webp->second.Get("source");
    const bool exists = source.IsInt() && source.GetNumberAsInt() >= 0 &&
                        std::size_t(source.GetNumberAsInt()) < model_.images.size();
    return exists ? source.GetNumberAsInt() : -1;
}

bool GltfTextures::has_picture(int number) const {
    if (number < 0 || std::size_t(number) >= model_.textures.size()) return false;
    const int source = source_of(number);
    return source >= 0 && is_read(picture_type(model_.images[std::size_t(source)].image));
}

int GltfTextures::load(int number, bool is_color) {
    const auto [entry, is_new] = loaded_.try_emplace({number, is_color}, int(textures_.size()));
    if (!is_new) return entry->second;
    const tinygltf::Texture& source = model_.textures[std::size_t(number)];
    SceneTexture texture;
    texture.is_color = is_color;
    std::tie(texture.image, texture.alpha) = colors_and_alpha(image(source_of(number)));
    add_levels(texture, source);
    if (source.sampler >= 0) {
        const tinygltf::Sampler& sampler = model_.samplers[std::size_t(source.sampler)];
        texture.filter = filter_of(sampler);
        texture.wrap_u = wrap_of(sampler.wrapS);
        texture.wrap_v = wrap_of(sampler.wrapT);
    }
    textures_.push_back(std::move(texture));
    return entry->second;
}

/// Adds the MIP levels that Burl wrote beside the texture, up to the first of a wrong size.
void GltfTextures::add_levels(SceneTexture& texture, const tinygltf::Texture& source) const {
    if (!source.extras.IsObject() || !source.extras.Has("burl_levels")) return;
    const tinygltf::Value& numbers = source.extras.Get("burl_levels");
    std::size_t width = texture.image.width(), height = texture.image.height();
    for (std::size_t i = 0; numbers.IsArray() && i < numbers.ArrayLen(); ++i) {
        const tinygltf::Value& number = numbers.Get(int(i));
        if (!number.IsInt() || number.GetNumberAsInt() < 0 ||
            std::size_t(number.GetNumberAsInt()) >= model_.images.size())
            return;
        auto [level, alpha] = colors_and_alpha(image(number.GetNumberAsInt()));
        width = std::max<std::size_t>(1, width / 2);
        height = std::max<std::size_t>(1, height / 2);
        if (level.width() != width || level.height() != height) return;
        texture.levels.push_back(std::move(level));
        if (texture.alpha.width() > 0) texture.alpha_levels.push_back(std::move(alpha));
    }
}

PictureColors GltfTextures::image(int number) const {
    const std::string where = fmt::format("images[{}]", number);
    if (number < 0)
        throw Error(
            ExitCode::unsupported,
            fmt::format("{}: a texture has no image that is read; export it with {} textures",
                        path_, pictures_read));
    const tinygltf::Image& image = model_.images[std::size_t(number)];
    if (image.image.empty()) {
        const std::string name = confined_file_name(image.uri, named_);
        const bool lies_out = name.empty() || !may_name(named_, path_, name);
        throw Error(lies_out ? ExitCode::invalid_file : ExitCode::io,
                    fmt::format("{}: the texture '{}' {}", path_, printable(image.uri),
                                name.empty() ? confined_rule
                                : lies_out   ? outside_rule
                                             : "is not there; put it beside the file"));
    }
    return decode_picture(image.image, fmt::format("{}: {}", path_, where));
}

}  // namespace burl
