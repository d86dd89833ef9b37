// The results of a bake as views, and their files.
#include <algorithm>
#include <iterator>
#include <span>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "app/bake/bake.h"
#include "app/bake/material.h"
#include "app/bake/texture.h"
#include "app/export/command_files.h"
#include "app/export/formats.h"
#include "app/image/exr_layers.h"
#include "app/kept/scene.h"
#include "app/library/guard.h"
#include "app/library/states.h"
#include "atlas/file/file_extension.h"

namespace burl::library {

namespace {

/// The type of a pixel's components.
template <class Pixel>
struct ComponentOf {
    using type = Pixel;
};
template <class T>
struct ComponentOf<Rgb<T>> {
    using type = T;
};
template <class T>
struct ComponentOf<Rgba<T>> {
    using type = T;
};

/// The view of an image of any kind; `is_color` says whether codes are sRGB.
template <class Images>
ImageView view_of(const Images& images, bool is_color) {
    return std::visit(
        [&]<class Pixel>(const Image<Pixel>& image) {
            using Component = typename ComponentOf<Pixel>::type;
            const ComponentType type = std::is_same_v<Component, float> ? ComponentType::f32
                                       : sizeof(Component) == 2         ? ComponentType::u16
                                                                        : ComponentType::u8;
            return ImageView{image.width(),
                             image.height(),
                             sizeof(Pixel) / sizeof(Component),
                             type,
                             is_color && type != ComponentType::f32,
                             image.pixels().data()};
        },
        images);
}

template <class Images>
NamedViews views_of(const std::string& name, const Images& image, const std::vector<Images>& levels,
                    bool is_color) {
    NamedViews views{name, {view_of(image, is_color)}};
    for (const Images& level : levels) views.levels.push_back(view_of(level, is_color));
    return views;
}

/// The letters of a picture's components in an .exr.
const char* letters_of(const FloatPicture& picture) {
    constexpr const char* letters[] = {"Y", "RGB", "RGBA"};
    return letters[picture.index()];
}

AtomicFile exr_file(const Baked::State& baked, const std::string& path) {
    std::vector<ExrLayer> layers;
    for (const FloatLevels& floats : baked.floats) {
        ExrLayer& layer = layers.emplace_back();
        if (&floats != baked.floats.data()) layer.name = floats.name;
        layer.channels = letters_of(floats.levels[0]);
        for (const FloatPicture& level : floats.levels)
            std::visit([&](const auto& image) { layer.levels.emplace_back(&image); }, level);
    }
    return write_exr_layers(path, layers, ExrDepth::full);
}

/// Throws burl::Error(usage) where the bake does not fit the format.
void check_format(const Baked::State& baked, const std::string& path) {
    const bool floats = wanted_kind(path, baked.depth) == ImageKind::rgb_float;
    const auto refuse = [&](const char* why) {
        throw burl::Error(ExitCode::usage, fmt::format("{}: {}", path, why));
    };
    if (floats && baked.depth != 32) refuse("an .exr holds floats; bake with depth 32");
    if (!floats && baked.depth == 32) refuse("a bake with depth 32 becomes an .exr only");
    if (is_gltf(path) && baked.packing != Packing::gltf)
        refuse("a glTF has an order of channels of its own; bake with packing gltf");
    if (is_materialx(path) && baked.packing != Packing::separate)
        refuse("a MaterialX document names one picture per channel; bake with packing separate");
}

/// The files of a bake, still to be committed.
std::vector<AtomicFile> files_of(const Baked::State& baked, const std::string& path,
                                 std::vector<std::string>& lost) {
    ExportOptions options = baked.options;
    options.coding = coding_asked("", path);
    options.tell = [&](const std::string& what) { lost.push_back(what); };
    if (baked.depth != 32) {
        std::vector<AtomicFile> files =
            scene_files(path, baked.mesh, baked.atlas, baked.color, options);
        for (const auto& [name, image] : baked.masks) {
            AtomicFile& file = files.emplace_back(picture_path(path, name, options.coding.format));
            std::visit(
                [&](const auto& mask) { encode_picture(mask, sink_of(file), options.coding); },
                image);
        }
        return files;
    }
    std::vector<AtomicFile> files;
    if (options.normals)
        encode_normals(*options.normals, options.coding,
                       sink_of(files.emplace_back(normal_map_path(path, options.coding.format))));
    files.push_back(exr_file(baked, path));
    return files;
}

/// Throws burl::Error(io) where a file would replace one that the mesh or the recipe was read from.
void check_files(const Baked::State& baked, std::span<const AtomicFile> files) {
    FileNames read;
    for (const std::string& file : files_of_mesh(baked.mesh_path)) read.add(file);
    for (const std::string& file : baked.recipe_files) read.add(file);
    for (const AtomicFile& file : files)
        if (read.find(file.target()))
            throw burl::Error(
                ExitCode::io,
                fmt::format("{}: the mesh or the recipe was read from that file; give the output "
                            "another name",
                            file.target()));
}

/// The sentence on the material's values that the file of that name and its pictures cannot hold.
std::string lost_values(const Baked::State& baked, const std::string& path) {
    std::vector<std::string> pictures;
    for (const ExportPicture& picture : baked.options.pictures) pictures.push_back(picture.name);
    for (const FloatLevels& floats : baked.floats) pictures.push_back(floats.name);
    return values_not_held(baked.recipe, pictures, baked.packing, path);
}

/// Sentences on what the file of that name cannot hold of the mesh and its document.
std::vector<std::string> losses_of(const Baked::State& baked, const std::string& path) {
    if (!holds_mesh(path)) return {};
    std::vector<std::string> sentences;
    std::vector<std::string> lost = baked.mesh_losses;
    const bool keeps_uvs = baked.atlas.options.kind == AtlasKind::uv && holds_colors(path);
    if (!baked.mesh_path.empty() && !has_gltf_extension(baked.mesh_path))
        lost = losses_of_flat(baked.mesh_path, baked.mesh, path, keeps_uvs);
    if (!holds_colors(path)) lost.emplace_back(stl_loss);
    if (!lost.empty()) sentences.push_back(losses_sentence(lost));
    if (baked.depth == 16 && is_gltf(path)) sentences.emplace_back(deep_gltf_loss);
    return sentences;
}

}  // namespace

void add_views(Baked::State& state) {
    if (state.depth != 32)
        state.views.push_back(views_of("color", state.color, state.options.levels, true));
    for (const FloatLevels& floats : state.floats) {
        NamedViews& views = state.views.emplace_back(NamedViews{floats.name, {}});
        for (const FloatPicture& level : floats.levels)
            views.levels.push_back(view_of(level, true));
    }
    for (const ExportPicture& picture : state.options.pictures)
        state.views.push_back(
            views_of(picture.name, picture.image, picture.levels, picture.is_color));
    if (const auto& normals = state.options.normals)
        state.views.push_back(views_of("normal", normals->image, normals->levels, false));
    for (const auto& [name, image] : state.masks)
        state.views.push_back(views_of(
            name, image, {},
            std::visit([]<class Pixel>(const Image<Pixel>&) { return sizeof(Pixel) % 3 == 0; },
                       image)));
}

Baked::Baked(std::shared_ptr<const State> state) : state_(std::move(state)) {}

std::span<const double> Baked::positions() const {
    return numbers_of<double>(state_->mesh.positions);
}

std::span<const std::uint32_t> Baked::triangles() const {
    return numbers_of<std::uint32_t>(state_->mesh.triangles);
}

std::span<const double> Baked::uvs() const {
    return state_->uvs;
}

std::vector<std::string> Baked::image_names() const {
    std::vector<std::string> names;
    for (const NamedViews& views : state_->views) names.push_back(views.name);
    return names;
}

std::size_t Baked::level_count(const std::string& name) const {
    const auto found = std::ranges::find(state_->views, name, &NamedViews::name);
    if (found != state_->views.end()) return found->levels.size();
    throw Error(ErrorKind::usage, fmt::format("there is no image '{}'; there are {}", name,
                                              fmt::join(image_names(), ", ")));
}

ImageView Baked::image(const std::string& name, std::size_t level) const {
    const std::size_t count = level_count(name);
    if (level >= count)
        throw Error(ErrorKind::usage, fmt::format("{} has levels 0 to {}, and none of number {}",
                                                  name, count - 1, level));
    return std::ranges::find(state_->views, name, &NamedViews::name)->levels[level];
}

std::vector<std::pair<std::string, double>> Baked::factors() const {
    return state_->factors;
}

std::vector<std::string> Baked::notes() const {
    return state_->notes;
}

std::vector<std::string> write(const Baked& baked, const std::string& path) {
    return guarded([&] {
        check_format(baked.state(), path);
        std::vector<std::string> lost;
        std::string values = lost_values(baked.state(), path);
        if (!values.empty()) lost.push_back(std::move(values));
        std::vector<AtomicFile> files = files_of(baked.state(), path, lost);
        check_files(baked.state(), files);
        std::ranges::move(losses_of(baked.state(), path), std::back_inserter(lost));
        commit_together(files);
        return lost;
    });
}

}  // namespace burl::library
