// Selection of the writer by extension, and the checks that need no image.
#include "app/export/export.h"

#include <array>
#include <filesystem>
#include <string_view>

#include "app/base/atomic_file.h"
#include "app/export/command_files.h"
#include "app/export/gltf.h"
#include "app/export/obj.h"
#include "app/image/convert_image.h"
#include "app/image/image_io.h"
#include "app/surface/normals.h"
#include "app/surface/posed_corners.h"
#include "app/surface/tangents.h"
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

/// A source of PNG content in the image's own depth, 8 bits for float. The image must outlive it.
ByteSource png_of(const BakedImage& image) {
    return [&image](const ByteSink& sink) {
        if (const auto* rgb16 = std::get_if<Image<Rgb16>>(&image)) return encode_png(*rgb16, sink);
        if (const auto* linear = std::get_if<Image<RgbF>>(&image))
            return encode_png(to_rgb8(*linear), sink);
        encode_png(std::get<Image<Rgb8>>(image), sink);
    };
}

/// An image of 8 or 16 bits decoded to linear light.
Image<RgbF> linear_of(const BakedImage& image) {
    if (const auto* rgb8 = std::get_if<Image<Rgb8>>(&image)) return to_linear(*rgb8);
    return to_linear(std::get<Image<Rgb16>>(image));
}

std::vector<ByteSource> level_pngs(const ExportOptions& options) {
    std::vector<ByteSource> pngs;
    for (const BakedImage& level : options.levels) pngs.push_back(png_of(level));
    return pngs;
}

/// A source of the normal map's PNG content; empty without a normal map.
ByteSource normal_png(const ExportOptions& options) {
    if (!options.normals) return {};
    return [&normals = options.normals->image](const ByteSink& sink) {
        std::visit([&](const auto& image) { encode_png(image, sink, PngContent::data); }, normals);
    };
}

/// The material's name "teapot marble", which differs between textures, since importers merge what
/// has one name.
std::string texture_name(const Mesh& mesh, const ExportOptions& options) {
    const std::string& recipe = options.recipe_name;
    if (mesh.name.empty() || recipe.empty())
        return mesh.name.empty() && recipe.empty() ? "solid texture" : mesh.name + recipe;
    return mesh.name + ' ' + recipe;
}

/// The files NAME.png, its MIP levels NAME.1.png, NAME.2.png, ..., and its normal map.
std::vector<AtomicFile> export_png(const std::string& path, const BakedImage& image,
                                   const ExportOptions& options) {
    std::vector<AtomicFile> files;
    files.reserve(2 + options.levels.size());
    const auto add = [&](const std::string& file, const ByteSource& png) {
        png(sink_of(files.emplace_back(file)));
    };
    if (options.normals) add(normal_map_path(path), normal_png(options));
    for (std::size_t l = 1; l <= options.levels.size(); ++l)
        add(fs::path(path).replace_extension(level_extension(l)).string(),
            png_of(options.levels[l - 1]));
    add(path, png_of(image));
    return files;
}

/// The image where it is float; otherwise its linear light, stored in `made`.
const Image<RgbF>& float_of(const BakedImage& image, Image<RgbF>& made) {
    if (const auto* linear = std::get_if<Image<RgbF>>(&image)) return *linear;
    return made = linear_of(image);
}

/// One file with all MIP levels. Float images are not copied: 16384 x 16384 floats are 3 GB.
AtomicFile write_exr_file(const std::string& path, const BakedImage& image,
                          const ExportOptions& options) {
    std::vector<Image<RgbF>> made(1 + options.levels.size());
    std::vector<const Image<RgbF>*> levels{&float_of(image, made[0])};
    for (std::size_t l = 0; l < options.levels.size(); ++l)
        levels.push_back(&float_of(options.levels[l], made[l + 1]));
    if (levels.size() > 1) return write_exr_levels(path, levels, options.exr_depth);
    return write_exr(path, *levels[0], options.exr_depth);
}

std::vector<AtomicFile> export_exr(const std::string& path, const BakedImage& image,
                                   const ExportOptions& options) {
    std::vector<AtomicFile> files;
    if (options.normals) normal_png(options)(sink_of(files.emplace_back(normal_map_path(path))));
    files.push_back(write_exr_file(path, image, options));
    return files;
}

std::vector<AtomicFile> export_obj(const std::string& path, const Mesh& mesh, const Atlas& atlas,
                                   const BakedImage& image, const ExportOptions& options) {
    const std::vector<ByteSource> levels = level_pngs(options);
    const std::vector<Vec3f> rest = corner_normals(mesh, options.crease_degrees);
    const auto write = [&](const Mesh& drawn, std::span<const Vec3f> normals) {
        return write_obj(path,
                         {drawn, atlas, normals, texture_name(mesh, options), png_of(image), levels,
                          normal_png(options), options.normals && options.normals->tangent_space});
    };
    if (!options.pose) return write(mesh, rest);
    const auto& [pose, weight] = *options.pose;
    return write(posed_mesh(mesh, pose, weight),
                 blended_normals(rest, posed_corners(mesh, pose, rest).normals, weight));
}

/// The vertex arrays of a glTF; normals and tangents per corner are freed on return.
std::vector<PartVertices> gltf_vertices(const Mesh& mesh, const Atlas& atlas,
                                        const ExportOptions& options) {
    const bool bumped = options.normals && options.normals->tangent_space;
    const std::vector<Vec3f> normals = corner_normals(mesh, options.crease_degrees);
    const std::vector<Vec2d> uvs = bumped ? corner_uvs(atlas) : std::vector<Vec2d>();
    std::vector<Vec4f> tangents;
    if (bumped) tangents = corner_tangents(mesh.positions, mesh.triangles, uvs, normals);
    if (!options.pose) return export_vertices(mesh, atlas, normals, tangents);
    const PosedCorners posed = posed_corners(mesh, options.pose->corners, normals, uvs);
    return export_vertices(mesh, atlas, normals, tangents, &posed);
}

std::vector<AtomicFile> export_gltf(const std::string& path, Format format, const Mesh& mesh,
                                    const Atlas& atlas, const BakedImage& image,
                                    const ExportOptions& options) {
    const std::vector<ByteSource> levels = level_pngs(options);
    const std::vector<PartVertices> vertices = gltf_vertices(mesh, atlas, options);
    GltfContent content{path,
                        mesh,
                        vertices,
                        atlas.options,
                        texture_name(mesh, options),
                        png_of(image),
                        levels,
                        options.recipe_json,
                        normal_png(options)};
    if (options.pose) content.target = {options.pose->corners.name, options.pose->weight};
    if (format == Format::gltf) return write_gltf(content);
    std::vector<AtomicFile> files;
    files.push_back(write_glb(content));
    return files;
}

}  // namespace

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

void check_side_output(const std::string& path, std::string_view extension,
                       std::span<const std::string> taken) {
    CommandFiles files;
    files.read(taken);
    files.write(path, extension);
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
    const Format format = format_of(out_path).format;
    switch (format) {
        case Format::png:
            return export_png(out_path, image, options);
        case Format::exr:
            return export_exr(out_path, image, options);
        case Format::obj:
            return export_obj(out_path, mesh, atlas, image, options);
        default:
            return export_gltf(out_path, format, mesh, atlas, image, options);
    }
}

std::vector<CommittedFile> export_scene(const std::string& out_path, const Mesh& mesh,
                                        const Atlas& atlas, const BakedImage& image,
                                        const ExportOptions& options) {
    std::vector<AtomicFile> files = scene_files(out_path, mesh, atlas, image, options);
    return commit_together(files);
}

}  // namespace burl
