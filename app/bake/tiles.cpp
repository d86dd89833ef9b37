#include "app/bake/tiles.h"

#include <algorithm>
#include <bit>
#include <filesystem>
#include <variant>

#include <fmt/format.h>

#include "atlas/base/error.h"
#include "atlas/build/mesh_atlas.h"
#include "atlas/uv/layout.h"

namespace burl {

namespace {

std::string tile_path(const std::string& out, std::uint32_t tile) {
    const std::filesystem::path path(out);
    return (path.parent_path() /
            fmt::format("{}.{}{}", path.stem().string(), tile, path.extension().string()))
        .string();
}

template <class Pixel>
Image<Pixel> cut(const Image<Pixel>& image, std::size_t columns, std::size_t rows) {
    auto part = Image<Pixel>::unset(columns, rows);
    for (std::size_t y = 0; y < rows; ++y)
        std::ranges::copy(image.row(y).first(columns), part.row(y).begin());
    return part;
}

/// Cuts the images of a texture, level 0 first.
template <class Images>
void cut_levels(const AtlasOptions& atlas, Images& image, std::vector<Images>& levels) {
    const auto cut_level = [&](Images& images, std::size_t level) {
        images = std::visit(
            [&](const auto& one) -> Images {
                return cut(one, atlas.columns() >> level, atlas.rows() >> level);
            },
            images);
    };
    cut_level(image, 0);
    for (std::size_t l = 1; l <= levels.size(); ++l) cut_level(levels[l - 1], l);
}

/// One sentence on why a texture that is not square cannot be had in this file, or with so many
/// levels; empty where it can.
std::string why_not_this_extent(const AtlasOptions& atlas, const BakePlan& plan) {
    if (atlas.columns() == atlas.rows()) return "";
    if (plan.kind == ImageKind::rgb_float)
        return "an .exr of Burl is square; write .png, .glb, .gltf or .obj";
    if (!plan.solid_map.empty()) return "a solid map is square; leave --solid-map out";
    if (!plan.channels.empty()) return "pictures of masks are square; leave --channels out";
    const bool powers = std::has_single_bit(atlas.columns()) && std::has_single_bit(atlas.rows());
    if (plan.levels.count > 0 && !powers)
        return "its MIP levels need sides that are powers of two; leave --levels out";
    return "";
}

}  // namespace

BakePlan plan_of_tiles(Pipeline& pipeline, const BakePlan& plan, const Recipe& recipe) {
    const Connectivity& connectivity = pipeline.connectivity();
    const std::vector<std::uint32_t> tiles = udim_tiles(pipeline.mesh(), connectivity);
    BakePlan tiled = plan;
    tiled.paths.clear();
    for (const std::uint32_t tile : tiles)
        tiled.paths.push_back(tile_path(plan.paths.front(), tile));
    tiled.recipe = [recipe, tiles](std::size_t number) {
        Recipe one = recipe;
        one.atlas.tile = tiles[number];
        return one;
    };
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const MeshAtlas made = build_atlas(pipeline.mesh(), connectivity, tiled.recipe(i).atlas);
        const LayoutNotes& notes = made.atlas().notes;
        if (!tiled.tile_notes) {
            tiled.tile_notes = notes;
            continue;
        }
        tiled.tile_notes->overlapped_texels += notes.overlapped_texels;
        tiled.tile_notes->overlapping_triangles += notes.overlapping_triangles;
    }
    return tiled;
}

void cut_to_extent(const AtlasOptions& atlas, BakedImage& image, ExportOptions& options) {
    if (atlas.columns() == atlas.rows()) return;
    cut_levels(atlas, image, options.levels);
    if (options.normals) cut_levels(atlas, options.normals->image, options.normals->levels);
    for (ExportPicture& picture : options.pictures)
        cut_levels(atlas, picture.image, picture.levels);
}

void check_uvs(const BakeCommand& command, const Recipe& recipe, const BakePlan& plan, bool kept) {
    const bool uv = recipe.atlas.kind == AtlasKind::uv;
    if (command.udim && !uv)
        throw Error(
            ExitCode::usage,
            fmt::format("{}: --udim does nothing: the {} atlas makes texture coordinates of "
                        "its own; add --atlas uv, or leave it out",
                        command.out, to_string(recipe.atlas.kind)));
    if (command.uv_set && !uv && !kept)
        throw Error(
            ExitCode::usage,
            fmt::format("{}: --uv-set is for --atlas uv, or for a glTF that becomes a glTF, "
                        "without --pose and --displace; leave it out",
                        command.out));
    if (command.udim && holds_mesh(command.out))
        throw Error(
            ExitCode::usage,
            fmt::format("{}: --udim writes textures alone, such as .png, since one material "
                        "of these files has one image; your mesh keeps its coordinates",
                        command.out));
    if (const std::string why = why_not_this_extent(recipe.atlas, plan); uv && !why.empty())
        throw Error(ExitCode::usage, fmt::format("{}: a texture of {} x {} texels: {}", command.out,
                                                 recipe.atlas.columns(), recipe.atlas.rows(), why));
}

}  // namespace burl
