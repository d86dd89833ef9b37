// Textures alone, and the selection of a writer by extension.
#include "app/export/export.h"

#include <array>
#include <filesystem>
#include <string_view>

#include "app/export/formats.h"
#include "app/image/exr_io.h"
#include "app/image/image_io.h"
#include "atlas/base/error.h"
#include "atlas/file/file_extension.h"

namespace burl {
namespace {

namespace fs = std::filesystem;

enum class Format { glb, gltf, obj, ply, stl, png, exr };

struct FormatFiles {
    Format format;
    std::string_view extension;
    std::array<const char*, 2> beside;  // extensions of further files, or null
};

constexpr std::array<FormatFiles, 7> formats{{{Format::glb, ".glb", {}},
                                              {Format::gltf, ".gltf", {".bin", ".png"}},
                                              {Format::obj, ".obj", {".mtl", ".png"}},
                                              {Format::ply, ".ply", {".png"}},
                                              {Format::stl, ".stl", {}},
                                              {Format::png, ".png", {}},
                                              {Format::exr, ".exr", {}}}};

const FormatFiles& format_of(const std::string& path) {
    const std::string extension = lower_extension(path);
    for (const FormatFiles& f : formats) {
        if (f.extension == extension) return f;
    }
    const std::string what = extension.empty()
                                 ? "has no extension"
                                 : fmt::format("has the unknown extension '{}'", extension);
    throw Error(ExitCode::usage,
                fmt::format("{}: the output {}; use .glb, .gltf, .obj, .ply, .stl, .png or .exr",
                            path, what));
}

/// The image, which the .exr holds as it is: 16384 x 16384 floats are 3 GB.
AtomicFile write_exr_file(const SceneContent& content) {
    std::vector<const Image<RgbF>*> levels{&std::get<Image<RgbF>>(content.image)};
    for (const BakedImage& level : content.options.levels)
        levels.push_back(&std::get<Image<RgbF>>(level));
    if (levels.size() > 1) return write_exr_levels(content.path, levels);
    return write_exr(content.path, *levels[0]);
}

template <class Pixel>
constexpr bool is_coded = !std::is_same_v<Pixel, RgbF> && !std::is_same_v<Pixel, RgbaF>;

/// Encodes an image of 8 or 16 bits of a variant, which it refers to.
template <class Images>
std::function<void(const ByteSink&)> encoder(const Images& images, PngContent content) {
    return [&images, content](const ByteSink& sink) {
        const auto encode = [&]<class Pixel>(const Image<Pixel>& image) {
            if constexpr (is_coded<Pixel>) encode_png(image, sink, content);
        };
        std::visit(encode, images);
    };
}

/// A texture with its levels.
template <class Images>
std::vector<SceneImage> texture_of(const std::string& name, const std::string& path,
                                   const Images& image, const std::vector<Images>& levels,
                                   PngContent content) {
    std::vector<SceneImage> texture{{name, path, encoder(image, content)}};
    for (std::size_t l = 1; l <= levels.size(); ++l)
        texture.push_back({fmt::format("{} level {}", name, l),
                           fs::path(path).replace_extension(level_extension(l)).string(),
                           encoder(levels[l - 1], content)});
    return texture;
}

}  // namespace

std::string material_name(const SceneContent& content) {
    const std::string &mesh = content.mesh.name, &recipe = content.options.recipe_name;
    if (mesh.empty() || recipe.empty())
        return mesh.empty() && recipe.empty() ? "solid texture" : mesh + recipe;
    return mesh + ' ' + recipe;
}

std::string picture_path(const std::string& out_path, const std::string& name) {
    const fs::path path(out_path);
    return (path.parent_path() / (path.stem().string() + "_" + name + ".png")).string();
}

void encode_png(const NormalMap& normals, const ByteSink& sink) {
    std::visit([&](const auto& image) { encode_png(image, sink, PngContent::data); },
               normals.image);
}

std::vector<std::vector<SceneImage>> scene_textures(const SceneContent& content,
                                                    const std::string& color) {
    const std::string name = material_name(content);
    const ExportOptions& options = content.options;
    if (!options.vertex_colors.empty()) return {};
    std::vector<std::vector<SceneImage>> textures{
        texture_of(name, color, content.image, options.levels, PngContent::color)};
    if (const auto& normals = options.normals)
        textures.push_back(texture_of(name + " normals", normal_map_path(content.path),
                                      normals->image, normals->levels, PngContent::data));
    for (const ExportPicture& picture : options.pictures)
        textures.push_back(texture_of(
            name + ' ' + picture.name, picture_path(content.path, picture.name), picture.image,
            picture.levels, picture.is_color ? PngContent::color : PngContent::data));
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
                                      bool normal_levels) {
    std::vector<std::string> paths{out_path};
    for (const char* extension : format_of(out_path).beside) {
        if (!extension) continue;
        paths.push_back(fs::path(out_path).replace_extension(extension).string());
    }
    const Format format = format_of(out_path).format;
    if (format == Format::stl) return paths;
    if (format == Format::glb || format == Format::exr) levels = 0;
    const auto add_levels = [&](const std::string path) {
        for (std::uint32_t l = 1; l <= levels; ++l)
            paths.push_back(fs::path(path).replace_extension(level_extension(l)).string());
    };
    add_levels(out_path);
    if (format == Format::glb) return paths;
    if (normals) {
        paths.push_back(normal_map_path(out_path));
        if (normal_levels) add_levels(paths.back());
    }
    if (format == Format::exr) return paths;
    for (const std::string& name : pictures) {
        paths.push_back(picture_path(out_path, name));
        add_levels(paths.back());
    }
    return paths;
}

std::vector<std::string> paths_without_texture(const std::string& out_path) {
    std::vector<std::string> paths = output_paths(out_path);
    std::erase_if(paths, [&](const std::string& path) {
        return path != out_path && lower_extension(path) == ".png";
    });
    return paths;
}

bool holds_mesh(const std::string& out_path) {
    const Format format = format_of(out_path).format;
    return format != Format::png && format != Format::exr;
}

bool is_gltf(const std::string& out_path) {
    const Format format = format_of(out_path).format;
    return format == Format::glb || format == Format::gltf;
}

bool holds_colors(const std::string& out_path) {
    return holds_mesh(out_path) && format_of(out_path).format != Format::stl;
}

bool is_obj(const std::string& out_path) {
    return format_of(out_path).format == Format::obj;
}

ImageKind wanted_kind(const std::string& out_path, int depth) {
    if (format_of(out_path).format == Format::exr) return ImageKind::rgb_float;
    return depth == 16 ? ImageKind::rgb16 : ImageKind::rgb8;
}

std::vector<AtomicFile> scene_files(const std::string& out_path, const Mesh& mesh,
                                    const Atlas& atlas, const BakedImage& image,
                                    const ExportOptions& options) {
    const SceneContent content{out_path, mesh, atlas, image, options};
    const Format format = format_of(out_path).format;
    if (format == Format::gltf) return write_gltf(content);
    if (format == Format::obj) return write_obj(content);
    if (format == Format::ply) return write_ply(content);
    std::vector<AtomicFile> files;
    if (format == Format::stl) {
        files.push_back(write_stl(content));
    } else if (format == Format::png) {
        add_images(files, content, out_path);
    } else if (format == Format::exr) {
        if (const auto& normals = content.options.normals)
            encoder(normals->image,
                    PngContent::data)(sink_of(files.emplace_back(normal_map_path(content.path))));
        files.push_back(write_exr_file(content));
    } else {
        files.push_back(write_glb(content));
    }
    return files;
}

}  // namespace burl
