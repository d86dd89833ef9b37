#include "procedural/synthesize.h"

#include <algorithm>
#include <memory>

#include "procedural/exit_estimate.h"
#include "procedural/synthesize_pieces.h"
#include "procedural/texel_shaders.h"
#include "procedural/work_sum.h"

namespace burl {

namespace {

/// Pieces from `begin` on that follow one another in a row of the image: where they end, and the
/// number of their texels.
std::pair<std::size_t, std::size_t> run_of(std::span<const Piece> pieces, std::size_t begin) {
    std::size_t end = begin + 1, count = pieces[begin].solid.count;
    while (end < pieces.size() && pieces[end].y == pieces[begin].y &&
           pieces[end].x == pieces[begin].x + count)
        count += pieces[end++].solid.count;
    return {end, count};
}

template <class Shader>
void flush(ShadedBatch& batch, const FieldSampler& sampler, const Shader& shader,
           Image<typename Shader::Pixel>& image) {
    if (batch.count == 0) return;
    shader.sample(sampler, batch);
    shader.shade(batch);
    std::size_t at = 0;
    for (std::size_t i = 0; i < batch.pieces.size();) {
        auto* pixels = &image(batch.pieces[i].x, batch.pieces[i].y);
        const auto [end, count] = run_of(batch.pieces, i);
        if constexpr (requires { shader.pixels(batch, at, count, pixels); })
            shader.pixels(batch, at, count, pixels);
        else
            for (std::size_t j = 0; j < count; ++j) pixels[j] = shader.pixel(batch, at + j);
        at += count;
        i = end;
    }
    batch.pieces.clear();
    batch.count = 0;
}

template <class Shader>
SynthesisWork synthesize_rows(const SolidAtlas& solid, const MovedMaps& maps,
                              const FieldSampler& sampler, const Shader& shader, const Skips& skips,
                              const RowGroups& groups, const RowRange& range,
                              Image<typename Shader::Pixel>& image) {
    const auto background = shader.background(0.0);
    const auto batch = std::make_unique_for_overwrite<ShadedBatch>();
    SynthesisWork& work = batch->streams.work;
    const auto empty = [&] { flush(*batch, sampler, shader, image); };
    for (std::size_t y = groups.begin(range.begin()); y != groups.begin(range.end()); ++y) {
        if (y % groups.rows == 0) empty();
        const std::size_t texels = texels_of(solid.row(y));
        if (skips.allows(Skip::unread_texels)) {
            work.texels += texels;
            work.skip_texels(Skip::unread_texels, solid.size - texels);
            fill_gaps(solid.row(y), background, image.row(y));
        } else {
            work.texels += solid.size;
            for (auto& pixel : image.row(y)) pixel = shader.background(0.0);
        }
        add_row(solid, maps, y, *batch, empty);
    }
    empty();
    return work += batch->corners.batch->streams.work;
}

/// With `exits`, the shader's colour map, the field where it is not seen need not be right.
template <class Shader>
Image<typename Shader::Pixel> synthesize(const SolidAtlas& solid, const Texture& texture,
                                         const Affine3& map, const Filter& filter, int threads,
                                         Kernel kernel, const Economy& economy,
                                         const Shader& shader, const ColorMap* exits = nullptr) {
    auto image = Image<typename Shader::Pixel>::unset(solid.size, solid.size);
    FieldSampler sampler(texture, filter.band_limit, kernel, economy.skips);
    WorkSum work(economy.work);
    const MovedMaps maps(solid.maps, map);
    if (exits && !filter.band_limit && may_exit(texture, economy.skips)) {
        const auto pilot = std::make_unique<FieldBatch>();
        add_pilot(solid, maps, *pilot);
        sampler.plan_exit(*exits, *pilot);
    }
    const RowGroups groups(solid.size, 8 * batch_capacity);
    const auto fill_groups = [&](const RowRange& range) {
        work.add(
            synthesize_rows(solid, maps, sampler, shader, economy.skips, groups, range, image));
    };
    for_row_ranges(groups.count(), 1, threads, fill_groups, economy.stop);
    return image;
}

template <class Pixel>
Image<Pixel> synthesize_colors(const SolidAtlas& solid, const Texture& texture, const Affine3& map,
                               const Filter& filter, int threads, Kernel kernel,
                               const Economy& economy) {
    const ColorMap& colors = texture.colors;
    const auto run = [&](const auto& shader) {
        return synthesize(solid, texture, map, filter, threads, kernel, economy, shader);
    };
    if (filter.kind == FilterKind::none)
        return synthesize(solid, texture, map, filter, threads, kernel, economy,
                          PointColor<Pixel>(colors), &colors);
    if (filter.kind == FilterKind::supersample)
        return run(SupersampledColor<Pixel>(colors, filter.samples));
    return run(FilteredColor<PointColor<Pixel>>(colors, filter.kind));
}

}  // namespace

Image<Rgb8> synthesize_rgb8(const SolidAtlas& solid, const Texture& texture,
                            const Affine3& texture_from_atlas, int threads, const Filter& filter,
                            Kernel kernel, const Economy& economy) {
    return synthesize_colors<Rgb8>(solid, texture, texture_from_atlas, filter, threads, kernel,
                                   economy);
}

Image<Rgb16> synthesize_rgb16(const SolidAtlas& solid, const Texture& texture,
                              const Affine3& texture_from_atlas, int threads, const Filter& filter,
                              Kernel kernel, const Economy& economy) {
    return synthesize_colors<Rgb16>(solid, texture, texture_from_atlas, filter, threads, kernel,
                                    economy);
}

Image<RgbF> synthesize_rgbf(const SolidAtlas& solid, const Texture& texture,
                            const Affine3& texture_from_atlas, int threads, const Filter& filter,
                            Kernel kernel, const Economy& economy) {
    return synthesize_colors<RgbF>(solid, texture, texture_from_atlas, filter, threads, kernel,
                                   economy);
}

Image<float> synthesize_field(const SolidAtlas& solid, const Texture& texture,
                              const Affine3& texture_from_atlas, int threads, Kernel kernel,
                              const Economy& economy) {
    return synthesize(solid, texture, texture_from_atlas, {}, threads, kernel, economy,
                      FieldCopy());
}

}  // namespace burl
