#include "app/scene/gltf_textures.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <tuple>

#include "atlas/base/error.h"
#include "atlas/file/text_scanner.h"

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

/// The format of encoded image bytes, from their signature.
std::string_view image_type(const std::vector<unsigned char>& bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.starts_with("\x89PNG\r\n\x1a\n")) return "PNG";
    if (text.starts_with("\xff\xd8\xff")) return "JPEG";
    if (text.starts_with("RIFF") &&
        text.substr(std::min<std::size_t>(8, text.size())).starts_with("WEBP"))
        return "WebP";
    if (text.starts_with("\xabKTX ")) return "KTX";
    return "of unknown type";
}

}  // namespace

bool GltfTextures::has_png(int number) const {
    if (number < 0 || std::size_t(number) >= model_.textures.size()) return false;
    const int source = model_.textures[std::size_t(number)].source;
    return source >= 0 && image_type(model_.images[std::size_t(source)].image) == "PNG";
}

int GltfTextures::load(int number, bool is_color) {
    const auto [entry, is_new] = loaded_.try_emplace({number, is_color}, int(textures_.size()));
    if (!is_new) return entry->second;
    const tinygltf::Texture& source = model_.textures[std::size_t(number)];
    SceneTexture texture;
    texture.is_color = is_color;
    std::tie(texture.image, texture.alpha) = colors_and_alpha(image(source.source));
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

PngColors GltfTextures::image(int number) const {
    const std::string where = fmt::format("images[{}]", number);
    if (number < 0) {
        throw Error(
            ExitCode::unsupported,
            fmt::format("{}: a texture has no PNG image; export it with PNG textures", path_));
    }
    const tinygltf::Image& image = model_.images[std::size_t(number)];
    if (image.image.empty()) {
        throw Error(ExitCode::io,
                    fmt::format("{}: the texture '{}' is not there; put it beside the file", path_,
                                printable(image.uri)));
    }
    if (const std::string_view type = image_type(image.image); type != "PNG") {
        throw Error(ExitCode::unsupported,
                    fmt::format("{}: {} is {}; convert it to PNG", path_, where, type));
    }
    return decode_png_with_alpha(image.image, fmt::format("{}: {}", path_, where));
}

}  // namespace burl
