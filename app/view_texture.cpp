#include "app/view_texture.h"

#include "app/convert_image.h"
#include "atlas/block_levels.h"
#include "atlas/solid_tiles.h"

namespace burl {

namespace {

/// The coarsest level that the view reads of those a bake writes.
std::uint32_t levels_read(const MeshAtlas& atlas, const ViewTexels& view) {
    std::uint32_t level = std::min(last_level(atlas), std::uint32_t(view.levels.size()) - 1);
    while (level > 0 && view.levels[level].count() == 0) --level;
    return level;
}

}  // namespace

SolidAtlas view_atlas(const SolidAtlas& solid, const ViewTexels& view, std::uint32_t cell) {
    return cut_to(solid, view.beneath().whole_cells(cell));
}

ViewWork view_work(const SolidAtlas& solid, const SolidAtlas& part, const ViewTexels& view) {
    return {view.count_tiles(), texel_count(cut_to(solid, view.beneath())), texel_count(part),
            texel_count(solid)};
}

SceneTexture view_texture(Pipeline& pipeline, const SolidAtlas& part, const ViewTexels& view,
                          TextureFilter filter, const HostWay& way) {
    SceneTexture texture;
    if (filter != TextureFilter::mip) {
        texture.image = fill_texture<Rgb8>(part, pipeline.recipe(), way);
        return texture;
    }
    const auto linear = fill_texture<RgbF>(part, pipeline.recipe(), way);
    texture.image = to_rgb8(linear);
    const std::uint32_t count = levels_read(pipeline.mesh_atlas(), view);
    for (const Image<RgbF>& level : block_levels(pipeline.mesh_atlas(), linear, count))
        texture.levels.push_back(to_rgb8(level));
    return texture;
}

}  // namespace burl
