// Textures alone, and the selection of a writer by extension.
#include "app/export/export.h"

#include <filesystem>
#include <string_view>

#include "app/export/formats.h"
#include "app/image/exr_io.h"
#include "app/image/image_io.h"
#include "app/pipeline/stage_records.h"
#include "app/pipeline/tasks.h"
#include "atlas/base/error.h"
#include "atlas/file/file_extension.h"

namespace burl {
namespace {

namespace fs = std::filesystem;

enum class Format { glb, gltf, obj, mtlx, ply, stl, picture, exr };

Format format_of(const std::string& path) {
    const std::string extension = lower_extension(path);
    if (texture_format_of(path)) return Format::picture;
    if (extension == ".glb") return Format::glb;
    if (extension == ".gltf") return Format::gltf;
    if (extension == ".obj") return Format::obj;
    if (extension == ".mtlx") return Format::mtlx;
    if (extension == ".ply") return Format::ply;
    if (extension == ".stl") return Format::stl;
    if (extension == ".exr") return Format::exr;
    if (path.empty()) throw Error(ExitCode::usage, "the output's name is empty");
    if (std::error_code ignored; fs::is_directory(path, ignored))
        throw Error(ExitCode::io, fmt::format("{}: is a folder, not a file", path));
    const std::string what = extension.empty()
                                 ? "has no extension"
                                 : fmt::format("has the unknown extension '{}'", extension);
    throw Error(ExitCode::usage,
                fmt::format("{}: the output {}; use .glb, .gltf, .obj, .mtlx, .ply, .stl, .png, "
                            ".jpg, .webp, .ktx2 or .exr",
                            path, what));
}

/// The image, which the .exr holds as it is: 16384 x 16384 floats are 3 GB.
AtomicFile write_exr_file(const SceneContent& content) {
    std::vector<const Image<RgbF>*> levels{&std::get<Image<RgbF>>(content.image)};
    for (const BakedImage& level : content.options.levels)
        levels.push_back(&std::get<Image<RgbF>>(level));
    const ExrDepth depth = content.options.exr_depth;
    if (levels.size() > 1) return write_exr_levels(content.path, levels, depth);
    return write_exr(content.path, *levels[0], depth);
}

template <class Pixel>
constexpr bool is_coded = !std::is_same_v<Pixel, RgbF> && !std::is_same_v<Pixel, RgbaF>;

/// The bytes of an image and its levels, which a meter counts.
template <class Images>
std::uint64_t bytes_of_texture(const Images& image, const std::vector<Images>& levels) {
    const auto bytes = [](const auto& one) { return std::uint64_t(bytes_of(one)); };
    std::uint64_t sum = std::visit(bytes, image);
    for (const Images& level : levels) sum += std::visit(bytes, level);
    return sum;
}

/// Encodes an image of 8 or 16 bits of a variant, which it refers to. If `begun` is not 0, a task
/// of so many bytes begins with it: each picture is compressed at a pace of its own.
template <class Images>
std::function<void(const ByteSink&)> encoder(const Images& images, const PictureCoding& coding,
                                             PngContent content, std::uint64_t begun = 0) {
    return [&images, coding, content, begun](const ByteSink& sink) {
        if (coding.meter && begun > 0) coding.meter->begin(tasks::pictures, begun);
        const auto encode = [&]<class Pixel>(const Image<Pixel>& image) {
            if constexpr (is_coded<Pixel>) encode_picture(image, sink, coding, content);
        };
        std::visit(encode, images);
    };
}

/// The codes of an image of 8 bits. Throws Error(unsupported) for another one.
template <class Images>
CodeRaster eight_bits(const Images& images) {
    const auto raster = [&]<class Pixel>(const Image<Pixel>& image) -> CodeRaster {
        if constexpr (sizeof(Pixel) <= 4 && !std::is_same_v<Pixel, Grey16>)
            return codes_of(image);
        else
            throw Error(ExitCode::unsupported, "a .ktx2 has no 16 bits; write a .png");
    };
    return std::visit(raster, images);
}

/// Encodes a texture with its levels, which it refers to, as one KTX2 file.
template <class Images>
std::function<void(const ByteSink&)> levels_encoder(const Images& image,
                                                    const std::vector<Images>& levels,
                                                    const PictureCoding& coding,
                                                    PngContent content) {
    return [&image, &levels, coding, content](const ByteSink& sink) {
        if (coding.meter) coding.meter->begin(tasks::pictures, bytes_of_texture(image, levels));
        std::vector<CodeRaster> rasters{eight_bits(image)};
        for (const Images& level : levels) rasters.push_back(eight_bits(level));
        encode_ktx2(rasters, sink, coding.quality.value_or(ktx2_level), content, coding.meter);
    };
}

/// A texture with its levels.
template <class Images>
std::vector<SceneImage> texture_of(const std::string& name, const std::string& path,
                                   const Images& image, const std::vector<Images>& levels,
                                   const PictureCoding& coding, PngContent content) {
    if (coding.format == TextureFormat::ktx2)
        return {{name, path, levels_encoder(image, levels, coding, content)}};
    std::vector<SceneImage> texture{
        {name, path, encoder(image, coding, content, bytes_of_texture(image, levels))}};
    for (std::size_t l = 1; l <= levels.size(); ++l)
        texture.push_back({fmt::format("{} level {}", name, l),
                           path_beside(path, level_extension(l, coding.format)),
                           encoder(levels[l - 1], coding, content)});
    return texture;
}

}  // namespace

std::string material_name(const SceneContent& content) {
    return material_name(content, content.options.recipe_name);
}

std::string material_name(const SceneContent& content, const std::string& recipe) {
    const std::string& mesh = content.mesh.name;
    if (mesh.empty() || recipe.empty())
        return mesh.empty() && recipe.empty() ? "solid texture" : mesh + recipe;
    return mesh + ' ' + recipe;
}

std::string path_beside(const std::string& out_path, std::string_view extension) {
    return fs::path(out_path).replace_extension(extension).string();
}

std::string picture_path(const std::string& out_path, const std::string& name,
                         TextureFormat format) {
    const fs::path path(out_path);
    const std::string file =
        fmt::format("{}_{}{}", path.stem().string(), name, extension_of(format));
    return (path.parent_path() / file).string();
}

std::string level_extension(std::size_t level, TextureFormat format) {
    return fmt::format(".{}{}", level, extension_of(format));
}

std::string normal_map_path(const std::string& out_path, TextureFormat format) {
    return picture_path(out_path, "normal", format);
}

PictureCoding coding_asked(const std::string& text, const std::string& out_path) {
    const std::optional<TextureFormat> own = texture_format_of(out_path);
    const PictureCoding coding =
        text.empty() ? PictureCoding{own.value_or(TextureFormat::png), {}} : coding_named(text);
    const auto refuse = [&](const std::string& why) {
        throw Error(ExitCode::usage,
                    fmt::format("{}: --picture-format {}: {}", out_path, text, why));
    };
    if (own && *own != coding.format)
        refuse(fmt::format("the output's extension says {}; leave one of the two out",
                           to_string(*own)));
    if (coding.format == TextureFormat::ktx2 && is_gltf(out_path))
        refuse(
            "glTF takes KTX2 only with Basis Universal's compression, which Burl does not "
            "write; use webp, or write the .ktx2 as an output of its own");
    const bool known = coding.format == TextureFormat::png || coding.format == TextureFormat::jpeg;
    if (is_materialx(out_path) && !known)
        refuse("programs that read MaterialX read pictures in png and jpeg; use one of these");
    return coding;
}

std::vector<std::vector<SceneImage>> scene_textures(const SceneContent& content,
                                                    const std::string& color) {
    const std::string name = material_name(content);
    const ExportOptions& options = content.options;
    if (!options.vertex_colors.empty()) return {};
    const PictureCoding& coding = options.coding;
    std::vector<std::vector<SceneImage>> textures{
        texture_of(name, color, content.image, options.levels, coding, PngContent::color)};
    if (const auto& normals = options.normals)
        textures.push_back(texture_of(name + " normals",
                                      normal_map_path(content.path, coding.format), normals->image,
                                      normals->levels, coding, PngContent::data));
    for (const ExportPicture& picture : options.pictures)
        textures.push_back(texture_of(name + ' ' + picture.name,
                                      picture_path(content.path, picture.name, coding.format),
                                      picture.image, picture.levels, coding,
                                      picture.is_color ? PngContent::color : PngContent::data));
    return textures;
}

void add_images(std::vector<AtomicFile>& files, const SceneContent& content,
                const std::string& color) {
    for (const std::vector<SceneImage>& texture : scene_textures(content, color))
        for (const SceneImage& image : texture)
            image.encode(sink_of(files.emplace_back(image.path)));
}

std::vector<std::string> output_paths(const std::string& out_path, std::uint32_t levels,
                                      bool normals, const std::vector<std::string>& pictures,
                                      bool normal_levels, TextureFormat asked) {
    const Format out = format_of(out_path);
    const TextureFormat format = texture_format_of(out_path).value_or(asked);
    std::vector<std::string> paths{out_path};
    const auto beside = [&](std::string_view extension) {
        paths.push_back(path_beside(out_path, extension));
    };
    if (out == Format::stl) return paths;
    if (out == Format::gltf) beside(".bin");
    if (out == Format::mtlx) beside(".obj");
    if (out == Format::obj || out == Format::mtlx) beside(".mtl");
    if (out == Format::gltf || out == Format::obj || out == Format::mtlx || out == Format::ply)
        beside(extension_of(format));
    const bool holds_levels = out == Format::glb || out == Format::exr;
    if (holds_levels || format == TextureFormat::ktx2) levels = 0;
    const auto add_levels = [&](const std::string& path) {
        for (std::uint32_t l = 1; l <= levels; ++l)
            paths.push_back(path_beside(path, level_extension(l, format)));
    };
    add_levels(out_path);
    if (out == Format::glb) return paths;
    if (normals) {
        paths.push_back(normal_map_path(out_path, format));
        if (normal_levels) add_levels(std::string(paths.back()));
    }
    if (out == Format::exr) return paths;
    for (const std::string& name : pictures) {
        paths.push_back(picture_path(out_path, name, format));
        add_levels(std::string(paths.back()));
    }
    return paths;
}

std::vector<std::string> paths_without_texture(const std::string& out_path) {
    std::vector<std::string> paths = output_paths(out_path);
    std::erase_if(paths, [&](const std::string& path) {
        return path != out_path && texture_format_of(path);
    });
    return paths;
}

bool holds_mesh(const std::string& out_path) {
    const Format format = format_of(out_path);
    return format != Format::picture && format != Format::exr;
}

bool is_obj(const std::string& out_path) {
    const Format format = format_of(out_path);
    return format == Format::obj || format == Format::mtlx;
}

bool is_materialx(const std::string& out_path) {
    return format_of(out_path) == Format::mtlx;
}

bool is_gltf(const std::string& out_path) {
    const Format format = format_of(out_path);
    return format == Format::glb || format == Format::gltf;
}

bool holds_strips(const std::string& out_path) {
    return is_gltf(out_path) || format_of(out_path) == Format::ply;
}

bool holds_colors(const std::string& out_path) {
    return holds_mesh(out_path) && format_of(out_path) != Format::stl;
}

ImageKind wanted_kind(const std::string& out_path, int depth) {
    if (format_of(out_path) == Format::exr) return ImageKind::rgb_float;
    return depth == 16 ? ImageKind::rgb16 : ImageKind::rgb8;
}

std::vector<AtomicFile> scene_files(const std::string& out_path, const Mesh& mesh,
                                    const Atlas& atlas, const BakedImage& image,
                                    const ExportOptions& options) {
    const SceneContent content{out_path, mesh, atlas, image, options};
    const Format format = format_of(out_path);
    if (format == Format::gltf) return write_gltf(content);
    if (format == Format::obj) return write_obj(content);
    if (format == Format::mtlx) return write_mtlx(content);
    if (format == Format::ply) return write_ply(content);
    std::vector<AtomicFile> files;
    if (format == Format::stl) {
        files.push_back(write_stl(content));
    } else if (format == Format::picture) {
        add_images(files, content, out_path);
    } else if (format == Format::exr) {
        if (const auto& normals = content.options.normals)
            encoder(normals->image, options.coding, PngContent::data)(
                sink_of(files.emplace_back(normal_map_path(content.path, options.coding.format))));
        files.push_back(write_exr_file(content));
    } else {
        files.push_back(write_glb(content));
    }
    return files;
}

}  // namespace burl
