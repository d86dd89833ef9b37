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

enum class Format { glb, gltf, obj, png, exr };

struct FormatFiles {
    Format format;
    std::string_view extension;
    std::array<const char*, 2> beside;  // extensions of further files, or null
};

constexpr std::array<FormatFiles, 5> formats{{{Format::glb, ".glb", {}},
                                              {Format::gltf, ".gltf", {".bin", ".png"}},
                                              {Format::obj, ".obj", {".mtl", ".png"}},
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
                fmt::format("{}: the output {}; use .glb, .gltf, .obj, .png or .exr", path, what));
}

/// The image, which the .exr holds as it is: 16384 x 16384 floats are 3 GB.
AtomicFile write_exr_file(const SceneContent& content) {
    std::vector<const Image<RgbF>*> levels{&std::get<Image<RgbF>>(content.image)};
    for (const BakedImage& level : content.options.levels)
        levels.push_back(&std::get<Image<RgbF>>(level));
    if (levels.size() > 1) return write_exr_levels(content.path, levels);
    return write_exr(content.path, *levels[0]);
}

void add_normals(std::vector<AtomicFile>& files, const SceneContent& content) {
    if (const auto& normals = content.options.normals)
        encode_png(*normals, sink_of(files.emplace_back(normal_map_path(content.path))));
}

}  // namespace

std::string material_name(const SceneContent& content) {
    const std::string &mesh = content.mesh.name, &recipe = content.options.recipe_name;
    if (mesh.empty() || recipe.empty())
        return mesh.empty() && recipe.empty() ? "solid texture" : mesh + recipe;
    return mesh + ' ' + recipe;
}

void encode_png(const BakedImage& image, const ByteSink& sink) {
    if (const auto* rgb16 = std::get_if<Image<Rgb16>>(&image)) return encode_png(*rgb16, sink);
    encode_png(std::get<Image<Rgb8>>(image), sink);
}

void encode_png(const NormalMap& normals, const ByteSink& sink) {
    std::visit([&](const auto& image) { encode_png(image, sink, PngContent::data); },
               normals.image);
}

void add_images(std::vector<AtomicFile>& files, const SceneContent& content,
                const std::string& texture) {
    add_normals(files, content);
    std::size_t number = 0;
    for (const BakedImage& level : content.options.levels) {
        const fs::path path = fs::path(texture).replace_extension(level_extension(++number));
        encode_png(level, sink_of(files.emplace_back(path.string())));
    }
    encode_png(content.image, sink_of(files.emplace_back(texture)));
}

std::vector<std::string> output_paths(const std::string& out_path, std::uint32_t levels,
                                      bool normals) {
    std::vector<std::string> paths{out_path};
    for (const char* extension : format_of(out_path).beside) {
        if (!extension) continue;
        paths.push_back(fs::path(out_path).replace_extension(extension).string());
    }
    const Format format = format_of(out_path).format;
    if (format == Format::glb || format == Format::exr) levels = 0;
    for (std::uint32_t l = 1; l <= levels; ++l)
        paths.push_back(fs::path(out_path).replace_extension(level_extension(l)).string());
    if (normals && format != Format::glb) paths.push_back(normal_map_path(out_path));
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
    std::vector<AtomicFile> files;
    if (format == Format::png) {
        add_images(files, content, out_path);
    } else if (format == Format::exr) {
        add_normals(files, content);
        files.push_back(write_exr_file(content));
    } else {
        files.push_back(write_glb(content));
    }
    return files;
}

}  // namespace burl
